// The shared module: require "trilith" from a stock lua5.4.
#include <fmt/format.h>

#include <new>
#include <string>

#include "bindings/core/open.hpp"

namespace {

using trilith::script::Host;

int end_host(lua_State* L) {
  auto* host = static_cast<Host*>(lua_touserdata(L, 1));
  try {
    host->finish("");
    for (const std::string& line : host->untrusted_runs()) fmt::print(stderr, "trilith: {}\n", line);
  } catch (const std::exception& e) {  // the state is closing: the script cannot be informed
    fmt::print(stderr, "trilith: {}\n", e.what());
  }
  host->~Host();
  return 0;
}

/// Takes the words after the script in the interpreter's table `arg`, as the program takes its own command line. Words
/// that are not NAME=VALUE are left for trilith.params to reject: a script without it may read `arg` itself.
void read_arg(lua_State* L, Host& host) {
  lua_rawgeti(L, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
  lua_pushliteral(L, "arg");
  const bool is_there = lua_rawget(L, -2) == LUA_TTABLE;  // raw: strict globals may reject unknown names
  for (lua_Integer i = 0; is_there; ++i) {
    const bool is_text = lua_rawgeti(L, -1, i) == LUA_TSTRING;
    const std::string word = is_text ? lua_tostring(L, -1) : "";
    lua_pop(L, 1);
    if (!is_text && i > 0) break;
    host.command_line += (i == 0 ? "lua " : " ") + word;
    if (i > 0) host.arguments.push_back(word);
  }
  lua_pop(L, 2);
  for (const std::string& word : host.arguments) {
    const bool lists = word == "--params" || word == "--help";
    host.list_parameters = host.list_parameters || lists;
    if (!lists) host.given.push_back(word);
  }
}

void make_host(lua_State* L) {
  auto* host = new (lua_newuserdatauv(L, sizeof(Host), 0)) Host();
  trilith::script::set_host(L, *host);
  host->records = trilith::script::record_folders();
  read_arg(L, *host);
}

}  // namespace

extern "C" __attribute__((visibility("default"))) int luaopen_trilith(lua_State* L) {
  make_host(L);
  lua_createtable(L, 0, 1);
  lua_pushcfunction(L, end_host);
  lua_setfield(L, -2, "__gc");
  lua_setmetatable(L, -2);
  lua_rawsetp(L, LUA_REGISTRYINDEX, reinterpret_cast<const void*>(&luaopen_trilith));  // lives as long as the state
  return trilith::script::open_trilith(L);
}
