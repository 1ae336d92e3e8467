// Conversion of C++ exceptions to Lua errors, and of Lua errors to C++ exceptions.
//
// Every C function for Lua is written as guarded<f>. Within f, code throws InputError (or any std::exception). It calls
// no Lua function that raises errors other than lack of memory: only raw access, explicit type tests, and call() for
// Lua code. So no longjmp crosses an object with a destructor, and the same code is valid for both builds of Lua.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

#include "bindings/core/lua_api.hpp"

namespace trilith::script {

/// A Lua error that passes through C++. Its message is complete, with place and traceback. An error object that is not
/// a text is stored in the Lua state and is raised again unchanged; the message then describes it.
class ScriptError : public std::runtime_error {
 public:
  explicit ScriptError(const std::string& message, bool is_object = false)
      : std::runtime_error(message), is_object_(is_object) {}
  [[nodiscard]] bool is_object() const { return is_object_; }

 private:
  bool is_object_;
};

/// Keeps `value` alive until no guarded function runs, because a finalizer may run during one that still uses it.
void keep_until_idle(std::shared_ptr<void> value);

/// Runs `body`; its exceptions become Lua errors that begin with the user's script and line.
int run_guarded(lua_State* L, lua_CFunction body);

template <int (*body)(lua_State*)>
int guarded(lua_State* L) {
  return run_guarded(L, body);
}

/// Calls the function below `arguments` values on the stack, as lua_pcall does, leaving `results` values. Throws
/// ScriptError if it fails, with the text and its traceback, or the error object as raised.
void call(lua_State* L, int arguments, int results);

/// Number of starts and ends of stages and of handlers in this thread. A short call, such as a reading or a function of
/// trilith.math, does not count: a loop of such calls is work of the script.
std::uint64_t engine_crossings();

/// Counts the start or the end of a stage.
void count_crossing();

/// Guarded functions of this thread: the number that began, and whether one runs now and has not called Lua code.
struct EngineCalls {
  std::uint64_t begun = 0;
  bool within = false;
};
EngineCalls engine_calls();

/// `text` returns an explanation of Lua's "not enough memory" if a limit was reached, otherwise "".
void explain_lack_of_memory(std::string (*text)());

/// Message handler for lua_pcall before an error is printed: converts it to a text, and adds a traceback except for
/// input errors, whose single line is sufficient.
int add_traceback(lua_State* L);

/// Adds the traceback of `thread` to the message on top of the stack; an error object that is not a text remains
/// unchanged.
void add_thread_traceback(lua_State* L, lua_State* thread);

/// The value at `index` as a text for people: from its __tostring, or its content. Raises no error.
std::string error_text(lua_State* L, int index);

/// The text at `index` with all its bytes, "" if there is none.
std::string text_at(lua_State* L, int index);

/// Marks the string on top of the stack as complete: add_traceback leaves it unchanged.
void mark_whole(lua_State* L);

/// "script.lua:12: " of the innermost frame of the user's code, or "".
std::string user_place(lua_State* L);

}  // namespace trilith::script
