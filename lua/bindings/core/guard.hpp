// The one place where C++ exceptions become Lua errors, and Lua errors C++ exceptions.
//
// Every C function given to Lua is written as guarded<f>. Within f, code throws InputError (or any std::exception) and
// calls no Lua function that raises for anything but lack of memory: raw access, explicit type tests, call() for Lua
// code. So no longjmp ever crosses an object with a destructor, and the same code is right under both builds of Lua.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

#include "bindings/core/lua_api.hpp"

namespace trilith::script {

/// A Lua error on its way through C++: its message is whole (place and traceback are in it). An error object that is no
/// text waits in the Lua state, and goes on as it was; the message then says what it is.
class ScriptError : public std::runtime_error {
 public:
  explicit ScriptError(const std::string& message, bool is_object = false)
      : std::runtime_error(message), is_object_(is_object) {}
  [[nodiscard]] bool is_object() const { return is_object_; }

 private:
  bool is_object_;
};

/// Keeps `value` until no guarded function is at work: a finalizer may run in the midst of one that still uses it.
void keep_until_idle(std::shared_ptr<void> value);

/// Runs `body`; what it throws becomes a Lua error with the user's script and line in front.
int run_guarded(lua_State* L, lua_CFunction body);

template <int (*body)(lua_State*)>
int guarded(lua_State* L) {
  return run_guarded(L, body);
}

/// Calls the function below `arguments` values on the stack, as lua_pcall does, leaving `results` values. Throws
/// ScriptError where it fails: a text with its traceback, or the error object as it was raised.
void call(lua_State* L, int arguments, int results);

/// How often control has passed between Lua and the engine in this thread, in either direction.
std::uint64_t engine_crossings();

/// `text` gives what Lua's "not enough memory" means where a limit was reached, and "" elsewhere.
void explain_lack_of_memory(std::string (*text)());

/// Message handler for lua_pcall where an error is told: makes it a text, and adds a traceback, but for errors of
/// input, where the one line says it all.
int add_traceback(lua_State* L);

/// Adds the traceback of `thread` to the message on top of the stack; an error object that is no text is left as it is.
void add_thread_traceback(lua_State* L, lua_State* thread);

/// The value at `index` as a text for people: what its __tostring says, or what it holds. Raises nothing.
std::string error_text(lua_State* L, int index);

/// The text at `index` with all its bytes, "" where there is none.
std::string text_at(lua_State* L, int index);

/// Marks the string on top of the stack as whole: add_traceback leaves it as it is.
void mark_whole(lua_State* L);

/// "script.lua:12: " of the innermost frame that is the user's own, or "".
std::string user_place(lua_State* L);

}  // namespace trilith::script
