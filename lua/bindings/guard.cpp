#include "guard.hpp"

#include <exception>
#include <string_view>

namespace trilith::script {
namespace {

constexpr const char* whole_message = "trilith.whole_message";
/// Chunks of the library that is compiled in are named so; they are not the user's.
constexpr std::string_view library_prefix = "=trilith/";

void push_message(lua_State* L, const std::exception& e, bool whole) {
  if (whole)
    lua_pushstring(L, e.what());
  else
    lua_pushstring(L, (user_place(L) + e.what()).c_str());
}

}  // namespace

std::string user_place(lua_State* L) {
  lua_Debug frame;
  for (int level = 0; lua_getstack(L, level, &frame) == 1; ++level) {
    lua_getinfo(L, "Sl", &frame);
    if (frame.currentline > 0 && !std::string_view(frame.source).starts_with(library_prefix))
      return std::string(frame.short_src) + ":" + std::to_string(frame.currentline) + ": ";
  }
  return "";
}

void mark_whole(lua_State* L) {
  lua_pushvalue(L, -1);
  lua_setfield(L, LUA_REGISTRYINDEX, whole_message);
}

int run_guarded(lua_State* L, lua_CFunction body) {
  try {
    return body(L);
  } catch (const ScriptError& e) {
    push_message(L, e, true);
  } catch (const std::exception& e) {
    push_message(L, e, false);
  }
  mark_whole(L);
  return lua_error(L);  // no object with a destructor is alive here
}

void add_thread_traceback(lua_State* L, lua_State* thread) {
  if (lua_type(L, -1) != LUA_TSTRING) {
    if (luaL_callmeta(L, -1, "__tostring") == 0)
      lua_pushfstring(L, "(error object is a %s value)", luaL_typename(L, -1));
    lua_replace(L, -2);
  }
  lua_getfield(L, LUA_REGISTRYINDEX, whole_message);
  const bool whole = lua_rawequal(L, -2, -1) != 0;
  lua_pop(L, 1);
  if (!whole) {
    luaL_traceback(L, thread, lua_tostring(L, -1), thread == L ? 1 : 0);
    lua_replace(L, -2);
  }
  mark_whole(L);
}

int add_traceback(lua_State* L) {
  lua_settop(L, 1);
  add_thread_traceback(L, L);
  return 1;
}

void call(lua_State* L, int arguments, int results) {
  const int handler = lua_gettop(L) - arguments;
  lua_pushcfunction(L, add_traceback);
  lua_insert(L, handler);
  const int status = lua_pcall(L, arguments, results, handler);
  lua_remove(L, handler);
  if (status == LUA_OK) return;
  const char* text = lua_tostring(L, -1);
  const std::string message = text != nullptr ? text : "an error without a message";
  lua_pop(L, 1);
  throw ScriptError(message);
}

}  // namespace trilith::script
