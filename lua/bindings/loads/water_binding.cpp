// Water: levels against bodies, uplift in joints, drag of a flow; in the plane and in space.
#include <algorithm>
#include <array>

#include "assembly/load_target.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/core/table_fields.hpp"
#include "bindings/loads/load_reading.hpp"
#include "bindings/loads/side_faces.hpp"
#include "model/water/added_mass.hpp"
#include "model/water/water.hpp"

namespace trilith::script {
namespace {

/// `level`: a number, or { {time, level}, ..., smooth = true } with times from `now` on [m].
LoadCurve read_level(Keys& keys, double now) {
  lua_State* L = keys.lua();
  LoadCurve curve;
  const int type = keys.push("level");
  if (type == LUA_TNUMBER) {
    curve.time = {now}, curve.share = {lua_tonumber(L, -1)};
  } else if (type == LUA_TTABLE) {
    try {
      Keys own(L, -1, "level");
      own.allow_list();
      curve.smooth = own.flag("smooth", false);
      own.finish();
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
    for (lua_Integer i = 1; i <= static_cast<lua_Integer>(lua_rawlen(L, -1)); ++i) {
      lua_rawgeti(L, -1, i);
      const auto point = point_at(L, -1);
      if (!point) keys.problem(fmt::format("point {} of the level is {}, must be {{time, level}}", i, what_is(L, -1)));
      if (point) curve.time.push_back(now + point->x()), curve.share.push_back(point->y());
      lua_pop(L, 1);
    }
    if (curve.time.empty()) keys.problem("'level' has no point, must be {time, level}, ...");
  } else if (type == LUA_TNIL) {
    keys.missing("level", "a number [m] or { {time, level}, ... }");
  } else {
    keys.wrong("level", "a number [m] or { {time, level}, ... }");
  }
  lua_pop(L, 1);
  return curve;
}

/// Refuses a body with crack planes: the forces of added mass follow from the accelerations of the step, and are not
/// known at its sections.
template <int D>
void require_whole(SimulatedModel<D>& m, int body, std::string_view what) {
  for (const CrackingBody<D>& c : m.simulation().cracking().bodies)
    if (c.body == body)
      throw InputError(
          fmt::format("{}: body '{}' has crack planes, and the added mass of water is not known at its sections: give "
                      "it cracks = false, or model its parts as bodies with a bond between them",
                      what, m.body_name(body)));
}

template <int D>
int water_of(lua_State* L, SimulatedModel<D>& m) {
  Keys keys(L, 2, "water");
  WaterSpec spec;
  spec.name = keys.text("name", "");
  if (!spec.name.empty()) keys.name_owner(spec.name);
  const std::vector<int> bodies = read_loaded_bodies(keys, m);
  spec.level = read_level(keys, m.time());
  const SideFaces faces = read_sides<D>(keys, "a level needs the side of the bodies that the water reaches");
  spec.density = keys.number("density", "kg/m3", 1000);
  spec.sealed = keys.choice("joints", {"sealed", "wet"}, 0) == 0;
  keys.finish();
  if (spec.name.empty()) spec.name = free_load_name(m, "water");
  const Model<D>& model = m.simulation().model();
  if (find_water(model, spec.name) != nullptr)
    throw InputError(
        fmt::format("water '{}': there is water of that name already; change its level by m:set_level", spec.name));
  std::vector<WetFace<D>> wet;
  for (const int body : bodies)
    for (WetFace<D>& face : faces_of(model, body, faces, "water")) wet.push_back(std::move(face));
  const std::vector made{make_water(model, spec, std::move(wet))};
  m.change([made](Model<D>& changed) { changed.loads.add(made); });
  return push_load_name(L, spec.name);
}

/// m:water{ body =, level =, side = | from =, to =, density =, joints =, name = }: returns its name.
int water(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return water_of<3>(L, *space);
  return water_of<2>(L, this_plane(L));
}

template <int D>
int set_level_of(lua_State* L, SimulatedModel<D>& m) {
  Keys keys(L, 2, "set_level");
  const std::string name = keys.text("name");
  const double level = keys.number("level", "m"), duration = keys.number("duration", "s", 0);
  if (!(duration >= 0)) keys.problem(fmt::format("'duration' is {:g} s, must not be below 0", duration));
  keys.finish();
  if (find_water(m.simulation().model(), name) == nullptr)
    throw InputError(fmt::format("set_level: there is no water '{}'{}", name, name_hint(name, names_of_loads(m))));
  m.change([name, level, duration, box = &m](Model<D>& changed) {
    change_level(changed, name, box->time(), level, duration);
  });
  return 0;
}

/// m:set_level{ name =, level =, duration = }: a new level, reached smoothly.
int set_level(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return set_level_of<3>(L, *space);
  return set_level_of<2>(L, this_plane(L));
}

Vec2 read_water_vector(Keys& keys, const char* key, PlaneModel& /*m*/) {
  return keys.point(key);
}
Vec3 read_water_vector(Keys& keys, const char* key, SpaceModel& /*m*/) {
  return keys.vector(key);
}
std::optional<Vec2> maybe_water_point(Keys& keys, const char* key, PlaneModel& /*m*/) {
  return keys.maybe_point(key);
}
std::optional<Vec3> maybe_water_point(Keys& keys, const char* key, SpaceModel& /*m*/) {
  if (!keys.has(key)) return std::nullopt;
  return keys.vector(key);
}

template <int D, class M>
int uplift_of(lua_State* L, M& m) {
  Keys keys(L, 2, "uplift");
  UpliftSpec<D> spec;
  spec.name = keys.text("name", "");
  if (!spec.name.empty()) keys.name_owner(spec.name);
  spec.upper = read_one_body(keys, "upper", m), spec.lower = read_one_body(keys, "lower", m);
  spec.upstream = keys.text("upstream"), spec.downstream = keys.text("downstream", "");
  spec.heel = maybe_water_point(keys, "heel", m);
  spec.full = keys.choice("head", {"linear", "full"}, 0) == 1;
  if (keys.push("drain") == LUA_TTABLE) {
    try {
      Keys drain(L, -1, "drain");
      spec.drain_at = drain.number("at", "m"), spec.drain_efficiency = drain.number("efficiency", "1");
      if (!(spec.drain_at > 0)) drain.problem(fmt::format("'at' is {:g} m, must be above 0", spec.drain_at));
      drain.finish();
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
  } else if (!lua_isnil(L, -1)) {
    keys.wrong("drain", "{ at = metres from the heel, efficiency = }");
  }
  lua_pop(L, 1);
  keys.finish();
  if (spec.upper == spec.lower) throw InputError("uplift: 'upper' and 'lower' are the same body");
  if (spec.name.empty()) spec.name = free_load_name(m, "uplift");
  const std::vector made{make_uplift<D>(m.simulation().model(), spec)};
  m.change([made](Model<D>& changed) { changed.loads.add(made); });
  return push_load_name(L, spec.name);
}

/// m:uplift{ upper =, lower =, upstream =, downstream =, head =, drain =, heel =, name = }: returns its name.
int uplift(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return uplift_of<3>(L, *space);
  return uplift_of<2>(L, this_plane(L));
}

template <int D, class M>
int drag_of(lua_State* L, M& m) {
  Keys keys(L, 2, "drag");
  DragSpec<D> spec;
  spec.name = keys.text("name", "");
  if (!spec.name.empty()) keys.name_owner(spec.name);
  const int body = read_one_body(keys, "body", m);
  spec.flow = read_water_vector(keys, "velocity", m);
  spec.coefficient = keys.number("coefficient", "1"), spec.area = keys.number("area", "m2");
  spec.density = keys.number("density", "kg/m3", 1000);
  spec.at = maybe_water_point(keys, "at", m);
  spec.curve = read_load_curve(keys, m.time());
  keys.finish();
  if (spec.name.empty()) spec.name = free_load_name(m, "drag");
  const std::vector made{make_drag<D>(m.simulation().model(), body, spec)};
  m.change([made](Model<D>& changed) { changed.loads.add(made); });
  return push_load_name(L, spec.name);
}

/// m:drag{ body =, velocity =, coefficient =, area =, density =, at =, load_curve =, name = }: returns its name.
int drag(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return drag_of<3>(L, *space);
  return drag_of<2>(L, this_plane(L));
}

template <int D>
int added_mass_of(lua_State* L, SimulatedModel<D>& m) {
  Keys keys(L, 2, "added_mass");
  AddedMassSpec spec;
  spec.name = keys.text("name", "");
  if (!spec.name.empty()) keys.name_owner(spec.name);
  const int body = read_one_body(keys, "body", m);
  spec.level = keys.number("level", "m"), spec.bed = keys.number("bed", "m");
  spec.density = keys.number("density", "kg/m3", 1000);
  spec.from = keys.maybe_number("from", "m"), spec.to = keys.maybe_number("to", "m");
  if (keys.has("radius")) {
    spec.form = AddedMassForm::cylinder, spec.radius = keys.number("radius", "m");
  } else {
    std::vector<std::string> names{"left", "right"};
    if (D == 3) names.insert(names.end(), {"front", "back"});
    const std::string side = keys.text("side", "");
    for (const FaceSide& s : face_sides)
      if (s.name == side && std::find(names.begin(), names.end(), side) != names.end())
        spec.side = Vec3(s.space[0], s.space[1], s.space[2]);
    if (spec.side.isZero())
      keys.problem(fmt::format("give side = \"left\" ({}), the side of an upright face, or radius, of a cylinder",
                               fmt::join(names, ", ")));
    spec.form = keys.choice("form", {"exact", "parabola"}, 0) == 0 ? AddedMassForm::exact : AddedMassForm::parabola;
    if (D == 3)
      spec.width = keys.number("width", "m");
    else if (keys.has("width"))
      keys.problem("'width' is for models in space; in the plane the face is as wide as the model is thick");
  }
  keys.finish();
  if (spec.name.empty()) spec.name = free_load_name(m, "added mass");
  require_whole(m, body, "added_mass");
  const std::vector made{make_added_mass(m.simulation().model(), body, spec)};
  m.change([made](Model<D>& changed) { changed.loads.add(made); });
  return push_load_name(L, spec.name);
}

/// m:added_mass{ body =, side =, form =, width = | radius =, level =, bed =, density =, name = }: returns its name.
int added_mass(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return added_mass_of<3>(L, *space);
  return added_mass_of<2>(L, this_plane(L));
}

// Readings of water.

/// Sums forces, and moments about the origin.
struct WaterSum2 : LoadPlaces<2> {
  Vec2 force = Vec2::Zero();
  double moment = 0;
  void push(const Attachment<2>& at, const Vec2& f, double m) { force += f, moment += m + cross(place_of(at), f); }
  void push_skin(int i, const Vec2& f) { force += f, moment += cross(skin(i), f); }
};
struct WaterSum3 : LoadPlaces<3> {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  void push(const Attachment<3>& at, const Vec3& f, const Vec3& m) { force += f, moment += m + cross(place_of(at), f); }
};
template <int D>
using WaterSum = std::conditional_t<D == 2, WaterSum2, WaterSum3>;

void set_components(lua_State* L, const char* key, const Vec2& v) {
  lua_createtable(L, 2, 0);
  for (int k = 0; k < 2; ++k) lua_pushnumber(L, v[k]), lua_rawseti(L, -2, k + 1);
  lua_setfield(L, -2, key);
}
void set_components(lua_State* L, const char* key, const Vec3& v) {
  lua_createtable(L, 3, 0);
  for (int k = 0; k < 3; ++k) lua_pushnumber(L, v[k]), lua_rawseti(L, -2, k + 1);
  lua_setfield(L, -2, key);
}
void set_components(lua_State* L, const char* key, double v) {
  set_number(L, key, v);
}

template <int D>
void push_uplift_state(lua_State* L, const Uplift<D>& uplift, const WaterSum<D>& places) {
  const UpliftNow<D> joint = uplift.now(places);
  WaterSum<D> sum{places};
  uplift.apply(sum, 0);
  lua_createtable(L, 0, 6);
  set_components(L, "force", sum.force), set_components(L, "moment", sum.moment);
  set_number(L, "crack", joint.tip), set_number(L, "length", joint.length);
  set_number(L, "open_toe", joint.length - joint.end);
  set_number(L, "level", uplift.curve.at(places.time()));
}

template <int D>
void push_water_state(lua_State* L, const Water<D>& water, const WaterSum<D>& places) {
  WaterSum<D> sum{places};
  for (int part = 0; part < water.parts(); ++part) water.apply(sum, part);
  lua_createtable(L, 0, 3);
  set_components(L, "force", sum.force), set_components(L, "moment", sum.moment);
  set_number(L, "level", water.curve.at(places.time()));
}

template <int D>
int water_state_of(lua_State* L, SimulatedModel<D>& m) {
  if (lua_type(L, 2) != LUA_TSTRING)
    throw InputError(
        fmt::format("water_state: the name is {}, must be the name of a water or an uplift", what_is(L, 2)));
  const std::string name = text_at(L, 2);
  const Simulation<D>& s = m.evaluated();
  const WaterSum<D> places{{s.model(), s.state(), &s.work(), &s.work().closed_joints}};
  for (const Uplift<D>& one : loads_of<Uplift<D>>(s.model()))
    if (one.name == name) return push_uplift_state<D>(L, one, places), 1;
  if (const Water<D>* one = find_water(s.model(), name)) return push_water_state<D>(L, *one, places), 1;
  throw InputError(
      fmt::format("water_state: there is no water or uplift '{}'{}", name, name_hint(name, names_of_loads(m))));
}

/// m:water_state(name): level, force and moment of a water; force on the upper body, crack and length of an uplift.
int water_state(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return water_state_of<3>(L, *space);
  return water_state_of<2>(L, this_plane(L));
}

const std::array water_method_list{
    Method{"water", guarded<water>},           Method{"set_level", guarded<set_level>},
    Method{"uplift", guarded<uplift>},         Method{"drag", guarded<drag>},
    Method{"added_mass", guarded<added_mass>}, Method{"water_state", guarded<water_state>},
};

}  // namespace

std::span<const Method> water_methods() {
  return water_method_list;
}

}  // namespace trilith::script
