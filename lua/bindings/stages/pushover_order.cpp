#include "bindings/stages/pushover_order.hpp"

#include <array>
#include <tuple>

#include "bindings/core/bindings.hpp"

namespace trilith::script {
namespace {

/// Keys of one control only.
template <int D>
void read_control(Keys& keys, PushOrder<D>& o) {
  o.by_arc = keys.choice("control", {"time", "arc"}, 0) == 1;
  const std::vector<std::string_view> others =
      o.by_arc ? std::vector<std::string_view>{"rate", "local_damping", "dt", "safety", "watch"}
               : std::vector<std::string_view>{"arc"};
  for (const std::string_view key : others)
    if (keys.has(key))
      keys.problem(
          fmt::format("'{}' is given, which is for control = \"{}\"; leave it out", key, o.by_arc ? "time" : "arc"));
  o.arc = keys.number("arc", "m", 0);
  if (keys.has("arc") && !(o.arc > 0)) keys.problem(fmt::format("'arc' is {:g} m, must be above 0", o.arc));
  if (!o.by_arc) o.rate = keys.maybe_number("rate", "m/s").value_or(0);
}

/// Early end criteria: drift =, storey =, drop =.
template <int D>
void read_limits(Keys& keys, PushOrder<D>& o) {
  o.limits.drift = keys.number("drift", "m", unbounded);
  o.limits.drop = keys.number("drop", "1", 0);
  o.storey = keys.count("storey", 0);
  if (keys.has("storey") && o.storey < 1) keys.problem(fmt::format("'storey' is {}, must be at least 1", o.storey));
  if (!(o.limits.drift > 0)) keys.problem(fmt::format("'drift' is {:g} m, must be above 0", o.limits.drift));
  if (!(o.limits.drop >= 0 && o.limits.drop < 1))
    keys.problem(fmt::format("'drop' is {:g}, must be at least 0 and below 1", o.limits.drop));
}

/// `at`: a point, or the name of a place or a joint.
template <int D>
void read_place(Keys& keys, PushOrder<D>& o) {
  lua_State* L = keys.lua();
  const int type = keys.push("at");
  if (type == LUA_TSTRING)
    o.place = text_at(L, -1);
  else if constexpr (D == 2)
    o.at = type == LUA_TNIL ? std::nullopt : point_at(L, -1);
  else
    o.at = type == LUA_TNIL ? std::nullopt : vector_at(L, -1);
  if (type != LUA_TNIL && type != LUA_TSTRING && !o.at)
    keys.wrong("at",
               D == 2 ? "{x, y} or the name of a place or a joint" : "{x, y, z}, \"centroid\" or the name of a joint");
  lua_pop(L, 1);
}

template <int D>
void read_pushed(Keys& keys, const ScriptModel& m, PushOrder<D>& o) {
  lua_State* L = keys.lua();
  if (keys.push("body") == LUA_TNIL) {
    keys.missing("body", "a body, a set or a name");
  } else {
    try {
      o.bodies = bodies_at(L, -1, m, "body");
      if (o.bodies.empty()) keys.problem("'body' is an empty set; check the filters of its m:bodies{...}");
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
  }
  lua_pop(L, 1);
  read_place(keys, o);
  if (keys.has("at") && o.bodies.size() > 1) keys.problem("'at' is a point of one body; several are given");
}

/// `direction`: along an axis, in either sense.
template <int D>
Vec<D> read_direction(Keys& keys) {
  std::vector<std::string> names{"x", "-x", "y", "-y"};
  if constexpr (D == 3) names.insert(names.end(), {"z", "-z"});
  const std::size_t which = keys.choice("direction", names, 0);
  return (which % 2 == 0 ? 1 : -1) * Vec<D>::Unit(static_cast<Eigen::Index>(which / 2));
}

/// `top`: directions in which the pushed bodies are held.
template <int D>
PushTop read_top(Keys& keys, const Vec<D>& direction) {
  constexpr std::array tops{PushTop::free, PushTop::level, PushTop::locked};
  const PushTop top = tops[keys.choice("top", {"free", "level", "locked"}, 0)];
  if (top == PushTop::locked && direction[D - 1] != 0)
    keys.problem(
        "'top' is \"locked\", which holds the height of the pushed bodies, but the push is vertical; push along x, or "
        "give top = \"level\"");
  return top;
}

/// `on_sample`: a function, which remains on the stack.
template <int D>
void read_on_sample(Keys& keys, PushOrder<D>& o) {
  lua_State* L = keys.lua();
  const int type = keys.push("on_sample");
  if (type == LUA_TFUNCTION) {
    o.on_sample = lua_gettop(L);
    return;
  }
  if (type != LUA_TNIL) keys.wrong("on_sample", "a function of the model and the sample");
  lua_pop(L, 1);
}

}  // namespace

template <int D>
PushOrder<D> read_order(Keys& keys, const ScriptModel& m) {
  constexpr std::array patterns{PushPattern::mass, PushPattern::uniform, PushPattern::triangle};
  PushOrder<D> o;
  o.stage.name = keys.text("name", "pushover");
  read_pushed(keys, m, o);
  o.direction = read_direction<D>(keys);
  o.top = read_top<D>(keys, o.direction);
  o.pattern = patterns[keys.choice("pattern", {"mass", "uniform", "triangle"}, 0)];
  read_control(keys, o);
  read_limits(keys, o);
  const bool bounded = o.limits.drift < unbounded;
  o.displacement = bounded ? keys.number("displacement", "m", 2 * o.limits.drift) : keys.number("displacement", "m");
  o.samples = keys.count("samples", o.samples);
  o.stage.rest_share = keys.number("local_damping", "1", 0.8);
  o.stage.dt = keys.number("dt", "s", 0);
  o.stage.safety = keys.number("safety", "1", o.stage.safety);
  o.stage.watched = keys.flag("watch", true);
  read_on_sample(keys, o);
  for (const auto& [key, value, unit] : {std::tuple{"rate", o.by_arc || !keys.has("rate") ? 1 : o.rate, "m/s"},
                                         std::tuple{"displacement", o.displacement, "m"}})
    if (!(value > 0))
      keys.problem(fmt::format("'{}' is {:g} {}, must be above 0; the direction sets the sign", key, value, unit));
  const StageOptions& stage = o.stage;
  if (!(stage.rest_share >= 0 && stage.rest_share < 1))
    keys.problem(fmt::format("'local_damping' is {:g}, must be at least 0 and below 1", stage.rest_share));
  if (!(stage.dt >= 0)) keys.problem(fmt::format("'dt' is {:g} s, must not be below 0", stage.dt));
  if (!(stage.safety > 0 && stage.safety <= 0.9))
    keys.problem(fmt::format("'safety' is {:g}, must be above 0 and at most 0.9", stage.safety));
  if (o.samples < 2) keys.problem(fmt::format("'samples' is {}, must be at least 2", o.samples));
  return o;
}

template PushOrder<2> read_order(Keys&, const ScriptModel&);
template PushOrder<3> read_order(Keys&, const ScriptModel&);

}  // namespace trilith::script
