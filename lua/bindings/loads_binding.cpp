// Loads: forces at points, pressure on faces, their load curves; quiet release.
#include <algorithm>
#include <cmath>

#include "bindings.hpp"
#include "step/release.hpp"
#include "world/loads.hpp"

namespace trilith::script {
namespace {

std::vector<int> read_bodies(Keys& keys, const ScriptModel& m) {
  std::vector<int> bodies;
  if (keys.push("body") == LUA_TNIL) {
    keys.missing("body", "a body, a set or a name");
  } else {
    try {
      bodies = some_bodies_at(keys.lua(), -1, m, "body");
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
  }
  lua_pop(keys.lua(), 1);
  return bodies;
}

/// Points {t, share} of the list on top of the stack, from `now` on.
void read_curve_points(Keys& keys, double now, LoadCurve& curve) {
  lua_State* L = keys.lua();
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(L, -1, i);
    const auto point = point_at(L, -1);
    if (!point) keys.problem(fmt::format("point {} of the course is {}, must be {{time, share}}", i, what_is(L, -1)));
    lua_pop(L, 1);
    if (!point) return;
    curve.time.push_back(now + point->x());
    curve.share.push_back(point->y());
  }
}

/// The table of a load curve on top of the stack.
LoadCurve read_curve_table(Keys& keys, double now) {
  Keys own(keys.lua(), -1, "course");
  own.allow_list();
  LoadCurve curve;
  read_curve_points(keys, now, curve);
  const auto over = own.maybe_number("ramp", "s");
  std::optional<double> smooth;
  if (curve.time.empty())
    smooth = own.maybe_number("smooth", "s");
  else
    curve.smooth = own.flag("smooth", false);
  if (static_cast<int>(over.has_value()) + static_cast<int>(smooth.has_value()) +
          static_cast<int>(!curve.time.empty()) !=
      1)
    own.problem("give one of ramp = seconds, smooth = seconds, or points { {time, share}, ... }");
  const double duration = over.value_or(smooth.value_or(1));
  if (!(duration > 0)) own.problem(fmt::format("its duration is {:g} s, must be above 0", duration));
  own.finish();
  return curve.time.empty() ? ramp_curve(now, 0, 1, duration, smooth.has_value()) : curve;
}

/// `course`: nothing (all at once, for good), a share, { ramp = T }, { smooth = T } or { {t, share}, ... , smooth =
/// true } with times from now on.
LoadCurve read_load_curve(Keys& keys, double now) {
  lua_State* L = keys.lua();
  const int type = keys.push("course");
  LoadCurve curve;
  if (type == LUA_TNUMBER) {
    curve = ramp_curve(now, 0, lua_tonumber(L, -1), 0, false);
  } else if (type == LUA_TTABLE) {
    try {
      curve = read_curve_table(keys, now);
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
  } else if (type != LUA_TNIL) {
    keys.wrong("course", "a number, { ramp = seconds }, { smooth = seconds } or { {time, share}, ... }");
  }
  lua_pop(L, 1);
  return curve;
}

/// Names of the loads of a model; builds it.
std::vector<std::string> names_of_loads(ScriptModel& m) {
  if (SpaceModel* space = as_space(m)) return load_names(space->simulation().model());
  return load_names(as_plane(m)->simulation().model());
}

std::string free_name(ScriptModel& m, const char* kind) {
  const std::vector<std::string> names = names_of_loads(m);
  for (std::size_t i = 1;; ++i) {
    std::string name = fmt::format("{} {}", kind, i);
    if (std::find(names.begin(), names.end(), name) == names.end()) return name;
  }
}

int push_name(lua_State* L, const std::string& name) {
  lua_pushlstring(L, name.data(), name.size());
  return 1;
}

/// `at` = {x, y} or the name of a place; the points, one for each body.
std::vector<std::optional<Vec2>> read_places(Keys& keys, const Model<2>& model, const std::vector<int>& bodies) {
  lua_State* L = keys.lua();
  std::vector<std::optional<Vec2>> places(bodies.size());
  const int type = keys.push("at");
  const std::string name = type == LUA_TSTRING ? text_at(L, -1) : "";
  const auto point = type == LUA_TTABLE ? point_at(L, -1) : std::nullopt;
  if (type != LUA_TNIL && type != LUA_TSTRING && !point) keys.wrong("at", "{x, y} or the name of a place");
  lua_pop(L, 1);
  if (point && bodies.size() > 1) keys.problem("'at' is a point of one body; several are given: name a place instead");
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    places[i] = type == LUA_TSTRING ? named_place(model, bodies[i], name) : point;
    if (type == LUA_TSTRING && !places[i])
      keys.problem(fmt::format("'at' is '{}', must be {{x, y}} or one of {}", name, place_names));
  }
  return places;
}

int solid_point_load(lua_State* L, SpaceModel& m) {
  Keys keys(L, 2, "point_load");
  SolidLoadSpec spec;
  spec.name = keys.text("name", "");
  if (!spec.name.empty()) keys.name_owner(spec.name);
  const std::vector<int> bodies = read_bodies(keys, m);
  spec.force = keys.vector("force", Vec3::Zero());
  spec.moment = keys.vector("moment", Vec3::Zero());
  if (spec.force.isZero() && spec.moment.isZero()) keys.problem("gives neither a force nor a moment");
  if (keys.has("at")) spec.at = keys.vector("at");
  if (spec.at && bodies.size() > 1) keys.problem("'at' is a point of one body; several are given: leave it out");
  spec.follows = keys.flag("follow", false);
  spec.curve = read_load_curve(keys, m.time());
  keys.finish();
  if (spec.name.empty()) spec.name = free_name(m, "load");
  std::vector<PointLoad<3>> loads;
  for (const int body : bodies) loads.push_back(make_solid_load(m.simulation().model(), body, spec));
  m.change([loads](Model<3>& changed) {
    changed.point_loads.insert(changed.point_loads.end(), loads.begin(), loads.end());
  });
  return push_name(L, spec.name);
}

/// m:point_load{ body =, force =, moment =, at =, follow =, course =, name = }: its name.
int point_load(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return solid_point_load(L, *space);
  PlaneModel& m = this_plane(L);
  Keys keys(L, 2, "point_load");
  PointLoadSpec spec;
  spec.name = keys.text("name", "");
  if (!spec.name.empty()) keys.name_owner(spec.name);
  const std::vector<int> bodies = read_bodies(keys, m);
  spec.force = keys.point("force", Vec2::Zero());
  spec.moment = keys.number("moment", "N m", 0);
  if (spec.force.isZero() && spec.moment == 0) keys.problem("gives neither a force nor a moment");
  spec.follows = keys.flag("follow", false);
  spec.curve = read_load_curve(keys, m.time());
  keys.know({"at"});
  keys.finish();
  const Model<2>& model = m.simulation().model();
  const auto places = read_places(keys, model, bodies);
  keys.finish();
  if (spec.name.empty()) spec.name = free_name(m, "load");
  std::vector<PointLoad<2>> loads;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    spec.at = places[i];
    for (PointLoad<2>& load : make_point_load(model, bodies[i], spec)) loads.push_back(std::move(load));
  }
  m.change([loads](Model<2>& changed) {
    changed.point_loads.insert(changed.point_loads.end(), loads.begin(), loads.end());
  });
  return push_name(L, spec.name);
}

/// Which faces a pressure acts on: face = "top" ..., "all", or from = , to = .
struct FaceChoice {
  std::string side;
  std::optional<Vec2> from, to;
};

FaceChoice read_faces(Keys& keys) {
  FaceChoice faces;
  faces.side = keys.text("face", "");
  faces.from = keys.maybe_point("from");
  faces.to = keys.maybe_point("to");
  if (faces.from.has_value() != faces.to.has_value()) keys.problem("give both 'from' and 'to', points of the outline");
  if (faces.side.empty() == !faces.from.has_value())
    keys.problem("give either face = \"top\" (bottom, left, right, all), or 'from' and 'to' counter-clockwise");
  const std::array sides{"top", "bottom", "left", "right", "all"};
  if (!faces.side.empty() && std::find(sides.begin(), sides.end(), faces.side) == sides.end())
    keys.problem(fmt::format("'face' is '{}', must be top, bottom, left, right or all{}", faces.side,
                             name_hint(faces.side, {sides.begin(), sides.end()})));
  return faces;
}

std::vector<FacePart> chosen_faces(const Model<2>& model, int body, const FaceChoice& choice) {
  const std::string owner = "pressure";
  if (choice.from) return faces_between(model, body, *choice.from, *choice.to, owner);
  if (choice.side == "all") return outline_faces(model, body);
  const Vec2 side = choice.side == "top"      ? Vec2(0, 1)
                    : choice.side == "bottom" ? Vec2(0, -1)
                    : choice.side == "left"   ? Vec2(-1, 0)
                                              : Vec2(1, 0);
  const std::vector<FacePart> faces = faces_towards(model, body, side);
  if (faces.empty())
    throw InputError(fmt::format("pressure: no face of '{}' looks to the {} within 45 degrees; give 'from' and 'to'",
                                 model.bodies[body].name, choice.side));
  return faces;
}

/// m:pressure{ body =, face = | from =, to =, value =, follow =, direction =, course =, name = }: its name.
int pressure(lua_State* L) {
  PlaneModel& m = this_plane(L);
  Keys keys(L, 2, "pressure");
  PressureSpec spec;
  spec.name = keys.text("name", "");
  if (!spec.name.empty()) keys.name_owner(spec.name);
  const std::vector<int> bodies = read_bodies(keys, m);
  const FaceChoice faces = read_faces(keys);
  spec.value = keys.number("value", "Pa");
  spec.direction = keys.maybe_point("direction");
  spec.follows = keys.flag("follow", !spec.direction.has_value());
  spec.curve = read_load_curve(keys, m.time());
  keys.finish();
  if (spec.name.empty()) spec.name = free_name(m, "pressure");
  const Model<2>& model = m.simulation().model();
  std::vector<FaceLoad<2>> loads;
  for (const int body : bodies)
    for (FaceLoad<2>& load : make_pressure(model, body, chosen_faces(model, body, faces), spec))
      loads.push_back(std::move(load));
  m.change(
      [loads](Model<2>& changed) { changed.face_loads.insert(changed.face_loads.end(), loads.begin(), loads.end()); });
  return push_name(L, spec.name);
}

void require_load(ScriptModel& m, const std::string& name, const char* owner) {
  const std::vector<std::string> names = names_of_loads(m);
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw InputError(fmt::format("{}: there is no load '{}'{}", owner, name, name_hint(name, names)));
}

double read_span(Keys& keys, const char* key, double preset) {
  const double span = keys.number(key, "s", preset);
  if (!(span >= 0 && std::isfinite(span))) keys.problem(fmt::format("'{}' is {:g} s, must not be below 0", key, span));
  return span;
}

/// From the step border on.
void change_share(ScriptModel& m, const std::string& name, double share, double duration) {
  const auto change = [name, share, duration, box = &m](auto& model) {
    change_loads(model, name, box->time(), share, duration);
  };
  if (SpaceModel* space = as_space(m))
    space->change(change);
  else
    as_plane(m)->change(change);
}

/// m:set_load{ name =, factor =, duration = }: its share from now on, reached smoothly.
int set_load(lua_State* L) {
  ScriptModel& m = this_model(L);
  Keys keys(L, 2, "set_load");
  const std::string name = keys.text("name");
  const double share = keys.number("factor", "1"), duration = read_span(keys, "duration", 0);
  keys.finish();
  require_load(m, name, "set_load");
  change_share(m, name, share, duration);
  return 0;
}

std::string directions_text(const std::array<bool, 3>& on) {
  constexpr std::array names{"x", "y", "rotation"};
  std::string text;
  for (std::size_t k = 0; k < 3; ++k)
    if (on[k]) text += fmt::format("{}{}", text.empty() ? "" : ", ", names[k]);
  return text;
}

/// `place`: of the script, for a message at the step border, where it is the run's line that is known.
void release_bodies(PlaneModel& m, const std::vector<int>& bodies, const std::array<bool, 3>& on, double fade,
                    const std::string& place) {
  const bool waits = m.running() && !m.paused();
  m.change([bodies, on, fade, box = &m, place = waits ? place : ""](Model<2>& model) {
    int freed = 0;
    for (const int body : bodies) freed += release_supports(model, box->if_built()->state(), body, on, fade);
    if (freed > 0) {
      box->simulation().drop_step();
      return;
    }
    const Body& first = model.bodies[bodies.front()];
    throw InputError(fmt::format(
        "release: {}{} free already in {}, so there is nothing to let go", place,
        bodies.size() == 1 ? fmt::format("body '{}' is", first.name) : fmt::format("the {} bodies are", bodies.size()),
        directions_text(on)));
  });
}

/// m:release{ load =, fade = } in space.
int release_solid_load(lua_State* L, SpaceModel& m) {
  Keys keys(L, 2, "release");
  const std::string load = keys.text("load");
  const double fade = read_span(keys, "fade", 1);
  keys.finish();
  require_load(m, load, "release");
  change_share(m, load, 0, fade);
  return 0;
}

/// m:release{ body =, x =, y =, rotation =, fade = } or { load =, fade = } or { push =, fade = }
int release(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return release_solid_load(L, *space);
  PlaneModel& m = this_plane(L);
  Keys keys(L, 2, "release");
  const bool of_load = keys.has("load"), of_push = keys.has("push"), of_body = keys.has("body");
  const std::string load = keys.text("load", ""), push = keys.text("push", "");
  const double fade = read_span(keys, "fade", 1);
  std::array<bool, 3> on{keys.flag("x", false), keys.flag("y", false), keys.flag("rotation", false)};
  if (!on[0] && !on[1] && !on[2]) on = {true, true, true};
  if (static_cast<int>(of_load) + static_cast<int>(of_push) + static_cast<int>(of_body) != 1)
    keys.problem("give one of body, load (its name) and push (its name)");
  const std::vector<int> bodies = of_body ? read_bodies(keys, m) : std::vector<int>{};
  keys.know({"body"});
  keys.finish();
  m.simulation();
  if (of_load) {
    require_load(m, load, "release");
    change_share(m, load, 0, fade);
  } else if (of_push) {
    require_load(m, push, "release");
    m.evaluated();
    m.change([push, fade, box = &m](Model<2>& model) {
      const Simulation<2>& s = *box->if_built();
      release_push(model, s.state(), s.work(), push, fade);
    });
  } else {
    release_bodies(m, bodies, on, fade, user_place(L));
  }
  return 0;
}

const std::array load_method_list{
    Method{
        "point_load", guarded<point_load>,
        "point_load{body=, force={x, y}, moment=, at=, follow=, course=, name=}: a force from now on; gives its name"},
    Method{
        "pressure", guarded<pressure>,
        "pressure{body=, face= or from= and to=, value=, follow=, direction=, course=, name=}: from now on; gives its "
        "name",
        2},
    Method{"set_load", guarded<set_load>, "set_load{name=, factor=, duration=}: a load's share from now on"},
    Method{"release", guarded<release>,
           "release{body=, x=, y=, rotation=, fade=} or {load=, fade=} or {push=, fade=}: frees without a jolt"},
};

}  // namespace

std::span<const Method> load_methods() {
  return load_method_list;
}

}  // namespace trilith::script
