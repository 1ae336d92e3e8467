// End criteria of a stage in scripts, other than its duration.
#include <cmath>

#include "bindings/stages/stage_run.hpp"

namespace trilith::script {
namespace {

/// Default drop of a collapse: 10 % of the height between the lowest and the highest body, or of 1 m without such a
/// height.
double collapse_drop(ScriptModel& m) {
  m.build();
  double low = unbounded, high = -unbounded;
  for (const double h : m.heights())
    if (std::isfinite(h)) low = std::min(low, h), high = std::max(high, h);
  return 0.1 * (high > low ? high - low : 1);
}

}  // namespace

StageUntil read_until(Keys& keys, ScriptModel& m) {
  lua_State* L = keys.lua();
  StageUntil until;
  keys.refuse("until", "'until' is a word of Lua; write until_true = function(m) return ... end");
  if (const int type = keys.push("until_collapse"); type == LUA_TTABLE) {
    Keys own(L, -1, "until_collapse");
    until.drop = own.number("drop", "m", collapse_drop(m));
    until.bodies = own.count("bodies", until.bodies);
    if (!(until.drop > 0)) own.problem(fmt::format("'drop' is {:g} m, must be above 0", until.drop));
    if (until.bodies < 1) own.problem(fmt::format("'bodies' is {}, must be at least 1", until.bodies));
    own.finish();
  } else if (type == LUA_TBOOLEAN) {
    until.drop = lua_toboolean(L, -1) != 0 ? collapse_drop(m) : 0;
  } else if (type != LUA_TNIL) {
    keys.wrong("until_collapse", "true, false or a table { drop = , bodies = }");
  }
  lua_pop(L, 1);
  const int type = keys.push("until_true");
  if (type == LUA_TFUNCTION) {
    until.function = lua_gettop(L);
    return until;
  }
  if (type != LUA_TNIL) keys.wrong("until_true", "a function of the model");
  lua_pop(L, 1);
  return until;
}

}  // namespace trilith::script
