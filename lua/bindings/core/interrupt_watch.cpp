#include "bindings/core/interrupt_watch.hpp"

namespace trilith::script {
namespace {

int do_nothing(lua_State*) {
  return 0;
}

/// The C function that implements all hooks of debug.sethook; nullptr without the library.
lua_Hook hook_of_scripts(lua_State* L) {
  const int top = lua_gettop(L);
  lua_checkstack(L, 10);
  lua_State* const thread = lua_newthread(L);
  lua_Hook hook = nullptr;
  if (lua_getfield(L, LUA_REGISTRYINDEX, LUA_LOADED_TABLE) == LUA_TTABLE) {
    lua_pushliteral(L, "debug");
    if (lua_rawget(L, -2) == LUA_TTABLE) {
      lua_pushliteral(L, "sethook");
      lua_rawget(L, -2);
      lua_pushvalue(L, top + 1);
      lua_pushcfunction(L, do_nothing);
      lua_pushliteral(L, "r");
      if (lua_pcall(L, 3, 0, 0) == LUA_OK) hook = lua_gethook(thread);
    }
  }
  lua_settop(L, top);
  return hook;
}

}  // namespace

InterruptWatch::InterruptWatch(lua_State* L, const Host& host) : host_(host) {
  if (host.interrupted != nullptr) return;
  lua_rawgeti(L, LUA_REGISTRYINDEX, LUA_RIDX_MAINTHREAD);
  main_ = lua_tothread(L, -1);
  lua_pop(L, 1);
  before_ = lua_gethook(main_);
  of_scripts_ = hook_of_scripts(L);
}

bool InterruptWatch::pressed() const {
  if (host_.interrupted != nullptr) return host_.interrupted();
  const lua_Hook now = lua_gethook(main_);
  return now != nullptr && now != before_ && now != of_scripts_;
}

}  // namespace trilith::script
