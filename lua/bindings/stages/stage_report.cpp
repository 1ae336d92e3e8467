// The report of a stage as a table of Lua.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "base/nearest.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/stages/stage_run.hpp"

namespace trilith::script {
namespace {

/// tostring(report): "shake ended (time) after 12 s in 100740 steps".
int report_text(lua_State* L) {
  if (lua_type(L, 1) != LUA_TTABLE) throw InputError("report: no report");
  const auto raw = [&](const char* key) {
    lua_pushstring(L, key);
    lua_rawget(L, 1);
  };
  const auto text = [&](const char* key) {
    raw(key);
    const std::string value = text_at(L, -1);
    lua_pop(L, 1);
    return value;
  };
  const auto number = [&](const char* key) {
    raw(key);
    const double value = lua_tonumber(L, -1);
    lua_pop(L, 1);
    return value;
  };
  std::string line = fmt::format("{} ended ({}) after {:.6g} s in {:.0f} steps", text("name"), text("ending"),
                                 number("ended") - number("begun"), number("steps"));
  if (const std::string reason = text("reason"); !reason.empty()) line += ": " + reason;
  lua_pushlstring(L, line.data(), line.size());
  return 1;
}

/// Access to an unknown field of a report. `mass_scaling` exists only if masses were scaled.
int no_such_field(lua_State* L) {
  const std::string name = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : what_is(L, 2);
  if (name == "mass_scaling") return 0;
  std::vector<std::string> known;
  for (lua_pushnil(L); lua_next(L, 1) != 0; lua_pop(L, 1))
    if (lua_type(L, -2) == LUA_TSTRING) known.emplace_back(lua_tostring(L, -2));
  throw InputError(fmt::format("report has no '{}'{}", name, name_hint(name, known)));
}

}  // namespace

void push_report(lua_State* L, const StageReport& r) {
  const auto number = [&](const char* key, double value) {
    lua_pushnumber(L, value);
    lua_setfield(L, -2, key);
  };
  lua_createtable(L, 0, 16);
  lua_pushstring(L, r.name.c_str());
  lua_setfield(L, -2, "name");
  lua_pushstring(L, name_of(r.end));
  lua_setfield(L, -2, "ending");
  lua_pushboolean(L, r.end == StageEnd::rest ? 1 : 0);
  lua_setfield(L, -2, "rests");
  lua_pushboolean(L, r.reason == collapse_reason ? 1 : 0);
  lua_setfield(L, -2, "collapsed");
  lua_pushstring(L, r.reason.c_str());
  lua_setfield(L, -2, "reason");
  lua_pushinteger(L, r.steps);
  lua_setfield(L, -2, "steps");
  number("begun", r.begun);
  number("ended", r.ended);
  number("shortest_dt", r.shortest_dt);
  number("longest_dt", r.longest_dt);
  number("speed", r.speed);
  number("ratio", r.ratio);
  lua_pushinteger(L, r.threads);
  lua_setfield(L, -2, "threads");
  number("thread_gain", r.thread_gain);
  if (r.scaled) {
    lua_createtable(L, 0, 6);
    number("bodies", r.scaled->bodies);
    number("share", r.scaled->share);
    number("most", r.scaled->most);
    number("before", r.scaled->before);
    number("energy", r.scaled->energy);
    number("kinetic", r.scaled->kinetic);
    lua_setfield(L, -2, "mass_scaling");
  }
  if (luaL_newmetatable(L, "trilith.report") != 0) {
    set_function(L, "__tostring", guarded<report_text>);
    set_function(L, "__index", guarded<no_such_field>);
  }
  lua_setmetatable(L, -2);
}

}  // namespace trilith::script
