#include "program/script/state.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <string_view>

#include "base/error.hpp"
#include "base/whole_file.hpp"
#include "bindings/core/guard.hpp"
#include "bindings/core/open.hpp"
#include "bindings/restart/random_state.hpp"
#include "interrupt.hpp"
#include "program/script/limits.hpp"
#include "program/script/room.hpp"
#include "verbs.hpp"

namespace trilith::program {
namespace {

/// os.exit(code): as in Lua, but the results record the end of the run.
int exit_script(lua_State* L) {
  const bool good =
      lua_isnoneornil(L, 1) || (lua_isboolean(L, 1) ? lua_toboolean(L, 1) != 0 : lua_tointeger(L, 1) == 0);
  const int code = good ? ended_well : lua_isinteger(L, 1) != 0 ? static_cast<int>(lua_tointeger(L, 1)) : wrong_input;
  auto& host = *static_cast<script::Host*>(lua_touserdata(L, lua_upvalueindex(1)));
  host.finish(good ? "" : "the script called os.exit");
  const std::vector<std::string> untrusted_runs = host.untrusted_runs();
  for (const std::string& line : untrusted_runs) fmt::print(stderr, "{}\n", line);
  std::exit(good && !untrusted_runs.empty() ? not_trusted : code);
}

/// print(...), on separate lines: the status is removed first. Upvalues: the host, and Lua's print.
int print_apart(lua_State* L) {
  const auto& host = *static_cast<script::Host*>(lua_touserdata(L, lua_upvalueindex(1)));
  if (host.silent) return 0;
  if (host.observer != nullptr) host.observer->clear();
  lua_pushvalue(L, lua_upvalueindex(2));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, 0);
  return 0;
}

/// Each run draws the same random numbers unless the script gives another seed.
void seed_random_numbers(lua_State* L) {
  script::find_random_state(L);
  lua_getglobal(L, "math");
  lua_getfield(L, -1, "randomseed");
  lua_pushinteger(L, 1);
  lua_call(L, 1, 0);
  lua_pop(L, 1);
}

int set_up(lua_State* L) {
  auto& host = *static_cast<script::Host*>(lua_touserdata(L, 1));
  luaL_openlibs(L);
  seed_random_numbers(L);
  open_interruptible_calls(L);
  lua_pushlightuserdata(L, &host);
  lua_getglobal(L, "print");
  lua_pushcclosure(L, print_apart, 2);
  lua_setglobal(L, "print");
  script::set_host(L, host);
  lua_getglobal(L, "os");
  lua_pushlightuserdata(L, &host);
  lua_pushcclosure(L, script::guarded<exit_script>, 1);
  lua_setfield(L, -2, "exit");
  script::keep_library_environment(L);
  script::open_trilith(L);
  script::load_library_file(L, "prepare");
  lua_insert(L, -2);
  lua_pushstring(L, host.folder().string().c_str());
  lua_call(L, 2, 0);
  if (host.room.closed()) close_room(L, host);
  return 0;
}

}  // namespace

ScriptState new_script_state(script::Host& host) {
  ScriptState state(luaL_newstate());
  if (!state) throw InputError("not enough memory");
  lua_State* L = state.get();
  limit_memory(L, host.script_memory);
  lua_pushcfunction(L, script::add_traceback);
  lua_pushcfunction(L, set_up);
  lua_pushlightuserdata(L, &host);
  if (lua_pcall(L, 1, 0, 1) != LUA_OK) throw InputError(message_at_top(L));
  limit_time(host.script_seconds);
  return state;
}

void read_script(script::Host& host) {
  host.script_text = text_of_file(host.script, "script", script::largest_script);
}

int load_script(lua_State* L, const script::Host& host, const std::string& before) {
  const std::string text = before + (host.script_text.starts_with("#") ? "--" : "") + host.script_text;
  const std::string chunk = "@" + host.script;  // a first line with # is for the shell
  return luaL_loadbufferx(L, text.data(), text.size(), chunk.c_str(), "t");
}

std::string message_at_top(lua_State* L) {
  const char* text = lua_tostring(L, -1);
  if (text != nullptr && std::string_view(text).starts_with("not enough memory") && !memory_refusal().empty())
    return memory_refusal();
  return text != nullptr ? text : "an error without a message";
}

}  // namespace trilith::program
