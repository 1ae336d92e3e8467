// pcall, xpcall and coroutines that let an interrupt pass. A hook belongs to one Lua thread, so Ctrl-C needs the
// running one; and a script that catches every error must not catch this one.
#include "interrupt.hpp"

namespace trilith::program {
namespace {

/// Result of a protected call, also if it continues after a yield. `before`: values on the stack below its results.
int finish_call(lua_State* L, int status, lua_KContext before) {
  if (status == LUA_OK || status == LUA_YIELD) return lua_gettop(L) - static_cast<int>(before);
  if (is_raised()) raise_interrupt(L, nullptr);
  lua_pushboolean(L, 0);
  lua_pushvalue(L, -2);
  return 2;
}

/// pcall(f, ...)
int protected_call(lua_State* L) {
  luaL_checkany(L, 1);
  lua_pushboolean(L, 1);
  lua_insert(L, 1);
  return finish_call(L, lua_pcallk(L, lua_gettop(L) - 2, LUA_MULTRET, 0, 0, finish_call), 0);
}

/// xpcall(f, handler, ...)
int handled_call(lua_State* L) {
  const int given = lua_gettop(L) - 2;
  luaL_checktype(L, 2, LUA_TFUNCTION);
  lua_pushboolean(L, 1);
  lua_pushvalue(L, 1);
  lua_rotate(L, 3, 2);
  return finish_call(L, lua_pcallk(L, given, LUA_MULTRET, 2, 2, finish_call), 2);
}

/// Resumes `thread` with the values on top of the stack. Returns the number of its results, now on top of the stack; -1
/// with an error there.
int resume_with(lua_State* L, lua_State* thread, int given) {
  if (lua_checkstack(thread, given) == 0) {
    lua_pushliteral(L, "too many arguments to resume");
    return -1;
  }
  lua_xmove(L, thread, given);
  lua_State* const before = switch_thread(thread);
  int results = 0;
  const int status = lua_resume(thread, L, given, &results);
  switch_thread(before);
  if (status != LUA_OK && status != LUA_YIELD) {
    lua_xmove(thread, L, 1);
    return -1;
  }
  if (lua_checkstack(L, results + 1) == 0) {
    lua_pop(thread, results);
    lua_pushliteral(L, "too many results to resume");
    return -1;
  }
  lua_xmove(thread, L, results);
  return results;
}

lua_State* thread_at(lua_State* L, int index) {
  lua_State* const thread = lua_tothread(L, index);
  if (thread == nullptr) luaL_typeerror(L, index, "coroutine");
  return thread;
}

/// coroutine.resume(thread, ...)
int resume(lua_State* L) {
  const int results = resume_with(L, thread_at(L, 1), lua_gettop(L) - 1);
  if (results < 0 && is_raised()) raise_interrupt(L, nullptr);
  lua_pushboolean(L, results < 0 ? 0 : 1);
  lua_insert(L, results < 0 ? -2 : -(results + 1));
  return results < 0 ? 2 : results + 1;
}

/// The function that coroutine.wrap returns; upvalue 1: the thread.
int resume_wrapped(lua_State* L) {
  lua_State* const thread = lua_tothread(L, lua_upvalueindex(1));
  const int results = resume_with(L, thread, lua_gettop(L));
  if (results >= 0) return results;
  if (is_raised()) raise_interrupt(L, nullptr);
  const int status = lua_status(thread);
  if (status != LUA_OK && status != LUA_YIELD) {  // closing its variables may raise a further error
    lua_resetthread(thread);
    lua_xmove(thread, L, 1);
  }
  if (lua_type(L, -1) == LUA_TSTRING) {
    luaL_where(L, 1);
    lua_insert(L, -2);
    lua_concat(L, 2);
  }
  return lua_error(L);
}

/// coroutine.wrap(f)
int wrap(lua_State* L) {
  luaL_checktype(L, 1, LUA_TFUNCTION);
  lua_State* const thread = lua_newthread(L);
  lua_pushvalue(L, 1);
  lua_xmove(L, thread, 1);
  lua_pushcclosure(L, resume_wrapped, 1);
  return 1;
}

/// coroutine.close(thread): Lua's own function, upvalue 1, with the closing code running in the thread.
int close(lua_State* L) {
  lua_State* const before = switch_thread(thread_at(L, 1));
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  const int status = lua_pcall(L, lua_gettop(L) - 1, LUA_MULTRET, 0);
  switch_thread(before);
  if (is_raised()) raise_interrupt(L, nullptr);
  return status == LUA_OK ? lua_gettop(L) : lua_error(L);
}

}  // namespace

void open_interruptible_calls(lua_State* L) {
  lua_pushcfunction(L, protected_call);
  lua_setglobal(L, "pcall");
  lua_pushcfunction(L, handled_call);
  lua_setglobal(L, "xpcall");
  lua_getglobal(L, "coroutine");
  lua_pushcfunction(L, resume);
  lua_setfield(L, -2, "resume");
  lua_pushcfunction(L, wrap);
  lua_setfield(L, -2, "wrap");
  lua_getfield(L, -1, "close");
  lua_pushcclosure(L, close, 1);
  lua_setfield(L, -2, "close");
  lua_pop(L, 1);
}

}  // namespace trilith::program
