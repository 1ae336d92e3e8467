#include "bindings/stages/stage_reading.hpp"

#include <fmt/format.h>

namespace trilith::script {

bool read_rest_table(Keys& keys, StageOptions& o) {
  lua_State* L = keys.lua();
  const int type = keys.push("rest");
  bool wanted = type == LUA_TBOOLEAN && lua_toboolean(L, -1) != 0;
  if (type == LUA_TTABLE) {
    wanted = true;
    Keys own(L, -1, "rest");
    o.still_speed = own.number("speed", "m/s", o.still_speed);
    o.still_ratio = own.number("ratio", "1", o.still_ratio);
    o.still_hold = own.number("hold", "s", o.still_hold);
    o.still_from = own.number("from", "s", o.still_from);
    try {
      own.finish();
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
  } else if (type != LUA_TNIL && type != LUA_TBOOLEAN) {
    keys.wrong("rest", "true, false or a table { speed = , ratio = , hold = , from = }");
  }
  lua_pop(L, 1);
  return wanted;
}

void read_step(Keys& keys, StageOptions& o) {
  o.dt = keys.number("dt", "s", 0);
  o.safety = keys.number("safety", "1", o.safety);
  o.watched = keys.flag("watch", true);
}

void refuse(Keys& keys, std::initializer_list<const char*> names, std::string_view of) {
  for (const char* const key : names)
    if (keys.has(key))
      keys.problem(fmt::format("'{}' is for integrator = \"{}\", but this stage is explicit; leave it out", key, of));
}

void read_nothing_for_nil(lua_State* L) {
  lua_settop(L, 2);
  if (!lua_isnil(L, 2)) return;
  lua_newtable(L);
  lua_replace(L, 2);
}

}  // namespace trilith::script
