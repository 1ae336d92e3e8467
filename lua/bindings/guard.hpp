// The one place where C++ exceptions become Lua errors, and Lua errors C++ exceptions.
//
// Every C function given to Lua is written as guarded<f>. Within f, code throws InputError (or any std::exception) and
// calls no Lua function that raises for anything but lack of memory: raw access, explicit type tests, call() for Lua
// code. So no longjmp ever crosses an object with a destructor, and the same code is right under both builds of Lua.
#pragma once

#include <stdexcept>
#include <string>

#include "lua_api.hpp"

namespace trilith::script {

/// A Lua error on its way through C++: its message is whole (place and traceback are in it).
class ScriptError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs `body`; what it throws becomes a Lua error with the user's script and line in front.
int run_guarded(lua_State* L, lua_CFunction body);

template <int (*body)(lua_State*)>
int guarded(lua_State* L) {
  return run_guarded(L, body);
}

/// Calls the function below `arguments` values on the stack, as lua_pcall does, leaving `results` values. Throws
/// ScriptError with message and traceback where it fails.
void call(lua_State* L, int arguments, int results);

/// Message handler for lua_pcall: adds a traceback, but for errors of input, where the one line says it all.
int add_traceback(lua_State* L);

/// The same with the traceback of `thread`; the message is on top of the stack, and is replaced.
void add_thread_traceback(lua_State* L, lua_State* thread);

/// Marks the string on top of the stack as whole: add_traceback leaves it as it is.
void mark_whole(lua_State* L);

/// "script.lua:12: " of the innermost frame that is the user's own, or "".
std::string user_place(lua_State* L);

}  // namespace trilith::script
