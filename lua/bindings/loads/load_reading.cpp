#include "bindings/loads/load_reading.hpp"

#include <algorithm>

#include "bindings/core/bindings.hpp"
#include "model/loads.hpp"

namespace trilith::script {
namespace {

/// Points {t, share} of the list on top of the stack, from `now` on.
void read_curve_points(Keys& keys, double now, LoadCurve& curve) {
  lua_State* L = keys.lua();
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(L, -1, i);
    const auto point = point_at(L, -1);
    if (!point)
      keys.problem(fmt::format("point {} of the load curve is {}, must be {{time, share}}", i, what_is(L, -1)));
    lua_pop(L, 1);
    if (!point) return;
    curve.time.push_back(now + point->x());
    curve.share.push_back(point->y());
  }
}

/// The table of a load curve on top of the stack.
LoadCurve read_curve_table(Keys& keys, double now) {
  Keys own(keys.lua(), -1, "load_curve");
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

}  // namespace

int read_one_body(Keys& keys, const char* key, const ScriptModel& m) {
  int body = -1;
  if (keys.push(key) == LUA_TNIL) {
    keys.missing(key, "a body or its name");
  } else {
    try {
      const std::vector<int> bodies = some_bodies_at(keys.lua(), -1, m, key);
      if (bodies.size() == 1)
        body = bodies.front();
      else
        keys.problem(fmt::format("'{}' is {} bodies, must be one", key, bodies.size()));
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
  }
  lua_pop(keys.lua(), 1);
  return body;
}

std::vector<int> read_loaded_bodies(Keys& keys, const ScriptModel& m) {
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

LoadCurve read_load_curve(Keys& keys, double now) {
  lua_State* L = keys.lua();
  const int type = keys.push("load_curve");
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
    keys.wrong("load_curve", "a number, { ramp = seconds }, { smooth = seconds } or { {time, share}, ... }");
  }
  lua_pop(L, 1);
  return curve;
}

std::optional<Vec3> named_place(const SpaceModel& m, int body, const std::string& name, const std::string& owner) {
  if (const auto place = joint_place(m.spec(body), name)) return place;
  if (name == "centroid") return std::nullopt;
  throw InputError(fmt::format("{}: 'at' is '{}', must be {{x, y, z}}, \"centroid\" or the name of a joint of '{}'",
                               owner, name, m.spec(body).name));
}

Vec2 named_place(PlaneModel& m, int body, const std::string& name, const std::string& owner) {
  if (const auto place = joint_place(m.spec(body), name)) return *place;
  if (const auto place = trilith::named_place(m.simulation().model(), body, name)) return *place;
  throw InputError(fmt::format("{}: 'at' is '{}', must be {{x, y}}, the name of a joint{} or one of {}", owner, name,
                               m.spec(body).frame ? fmt::format(" of '{}'", m.spec(body).name) : "", place_names));
}

std::vector<std::string> names_of_loads(ScriptModel& m) {
  if (SpaceModel* space = as_space(m)) return load_names(space->simulation().model());
  return load_names(as_plane(m)->simulation().model());
}

std::string free_load_name(ScriptModel& m, const char* kind) {
  const std::vector<std::string> names = names_of_loads(m);
  for (std::size_t i = 1;; ++i) {
    std::string name = fmt::format("{} {}", kind, i);
    if (std::find(names.begin(), names.end(), name) == names.end()) return name;
  }
}

int push_load_name(lua_State* L, const std::string& name) {
  lua_pushlstring(L, name.data(), name.size());
  return 1;
}

}  // namespace trilith::script
