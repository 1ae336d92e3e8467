// The shared module: require "trilith" from a stock lua5.4.
#include <fmt/format.h>

#include <new>

#include "open.hpp"

namespace {

using trilith::script::Host;

int end_host(lua_State* L) {
  auto* host = static_cast<Host*>(lua_touserdata(L, 1));
  try {
    host->finish("");
  } catch (const std::exception& e) {  // the state closes: no script is left to be told
    fmt::print(stderr, "trilith: {}\n", e.what());
  }
  host->~Host();
  return 0;
}

void make_host(lua_State* L) {
  auto* host = new (lua_newuserdatauv(L, sizeof(Host), 0)) Host();
  trilith::script::set_host(L, *host);
  host->records = trilith::script::record_folders();
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
