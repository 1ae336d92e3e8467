#include "bindings/core/guard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/no_solution.hpp"
#include "base/terminal_text.hpp"
#include "bindings/core/no_solution_error.hpp"
#include "bindings/core/unit_door.hpp"

namespace trilith::script {
namespace {

constexpr const char* whole_message = "trilith.whole_message";
constexpr const char* no_solution = "trilith.no_solution";
constexpr const char* error_object = "trilith.error_object";
/// Prefix of the chunk names of the built-in library, to distinguish them from the user's.
constexpr std::string_view library_prefix = "=trilith/";

/// Guarded functions that run in this thread, and objects they may still use.
struct AtWork {
  int calls = 0;
  int inner = 0;  ///< those begun after the innermost call of Lua code
  std::uint64_t begun = 0;
  std::vector<std::shared_ptr<void>> kept;
};
thread_local AtWork at_work;
thread_local std::uint64_t crossings = 0;
std::string (*limit_of_memory)() = nullptr;

struct Call {
  Call() { ++at_work.calls, ++at_work.inner, ++at_work.begun; }
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;
  ~Call() {
    --at_work.inner;
    if (--at_work.calls == 0 && !at_work.kept.empty()) std::exchange(at_work.kept, {}).clear();
  }
};

void push_message(lua_State* L, const std::exception& e, bool whole) {
  // It may quote text of the script, and stock lua writes it to the terminal unchanged.
  const std::string text = terminal_text(e.what());
  lua_pushstring(L, whole ? text.c_str() : (user_place(L) + text).c_str());
}

/// Pushes the error object of a ScriptError.
void take_error_object(lua_State* L) {
  lua_getfield(L, LUA_REGISTRYINDEX, error_object);
  lua_pushnil(L);
  lua_setfield(L, LUA_REGISTRYINDEX, error_object);
}

/// Text of a number, or from a value's __tostring; "" if there is none. Errors of __tostring propagate.
int own_text(lua_State* L) {
  if (lua_type(L, 1) == LUA_TNUMBER)
    luaL_tolstring(L, 1, nullptr);
  else if (luaL_callmeta(L, 1, "__tostring") == 0)
    lua_pushliteral(L, "");
  return 1;
}

std::string plain_value(lua_State* L, int index) {
  switch (lua_type(L, index)) {
    case LUA_TSTRING:
      return fmt::format("\"{}\"", text_at(L, index));
    case LUA_TNUMBER:
      return lua_isinteger(L, index) != 0 ? fmt::format("{}", lua_tointeger(L, index))
                                          : fmt::format("{:g}", lua_tonumber(L, index));
    case LUA_TBOOLEAN:
      return lua_toboolean(L, index) != 0 ? "true" : "false";
    default:
      return luaL_typename(L, index);
  }
}

/// "{ 1, code = 5 }": the list part of a table, then its sorted names, each up to a limit.
std::string contents(lua_State* L, int table) {
  constexpr std::size_t most = 8;
  std::vector<std::string> list, named;
  const auto count = static_cast<lua_Integer>(std::min<std::size_t>(lua_rawlen(L, table), most));
  for (lua_Integer i = 1; i <= count; ++i, lua_pop(L, 1)) {
    lua_rawgeti(L, table, i);
    list.push_back(plain_value(L, -1));
  }
  for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1))
    if (lua_type(L, -2) == LUA_TSTRING) named.push_back(text_at(L, -2) + " = " + plain_value(L, -1));
  std::sort(named.begin(), named.end());
  named.resize(std::min(named.size(), most));
  list.insert(list.end(), named.begin(), named.end());
  return list.empty() ? "{}" : fmt::format("{{ {} }}", fmt::join(list, ", "));
}

/// Message handler: add_traceback that leaves error objects unchanged.
int trace_text(lua_State* L) {
  lua_settop(L, 1);
  add_thread_traceback(L, L);
  return 1;
}

/// The Lua function that is running, as "wall: ", or "" if it has no name.
std::string name_at_work(lua_State* L) {
  lua_Debug frame;
  if (lua_getstack(L, 0, &frame) != 1 || lua_getinfo(L, "n", &frame) == 0 || frame.name == nullptr) return "";
  return std::string(frame.name) + ": ";
}

InputError lack_of_memory(lua_State* L) {
  return InputError(name_at_work(L) +
                    "needs more memory than this machine has; use fewer or larger pieces, fewer samples, or a longer "
                    "interval, and check the units of the given counts and lengths");
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

void explain_lack_of_memory(std::string (*text)()) {
  limit_of_memory = text;
}

std::uint64_t engine_crossings() {
  return crossings;
}

void count_crossing() {
  ++crossings;
}

EngineCalls engine_calls() {
  return {at_work.begun, at_work.inner > 0};
}

void keep_until_idle(std::shared_ptr<void> value) {
  if (at_work.calls > 0) at_work.kept.push_back(std::move(value));
}

std::string text_at(lua_State* L, int index) {
  std::size_t length = 0;
  const char* text = lua_type(L, index) == LUA_TSTRING ? lua_tolstring(L, index, &length) : nullptr;
  return text != nullptr ? std::string(text, length) : "";
}

void mark_whole(lua_State* L) {
  lua_pushvalue(L, -1);
  lua_setfield(L, LUA_REGISTRYINDEX, whole_message);
}

bool is_no_solution(lua_State* L, const std::string& message) {
  lua_getfield(L, LUA_REGISTRYINDEX, no_solution);
  const std::string said = text_at(L, -1);
  lua_pop(L, 1);
  return !said.empty() && message.find(said) != std::string::npos;
}

int run_guarded(lua_State* L, lua_CFunction body) {
  try {
    const Call call;
    require_open_door(L);
    return body(L);
  } catch (const ScriptError& e) {
    if (e.is_object())
      take_error_object(L);
    else
      push_message(L, e, true);
  } catch (const std::bad_alloc&) {
    push_message(L, lack_of_memory(L), false);
  } catch (const std::length_error&) {
    push_message(L, lack_of_memory(L), false);
  } catch (const NoSolution& e) {
    push_message(L, e, false);
    lua_pushvalue(L, -1);
    lua_setfield(L, LUA_REGISTRYINDEX, no_solution);
  } catch (const std::exception& e) {
    push_message(L, e, false);
  }
  mark_whole(L);
  return lua_error(L);  // no object with a destructor is alive here
}

void add_thread_traceback(lua_State* L, lua_State* thread) {
  if (lua_type(L, -1) != LUA_TSTRING) return;
  lua_getfield(L, LUA_REGISTRYINDEX, whole_message);
  const bool whole = lua_rawequal(L, -2, -1) != 0;
  lua_pop(L, 1);
  if (!whole) {
    luaL_traceback(L, thread, lua_tostring(L, -1), thread == L ? 1 : 0);
    lua_replace(L, -2);
  }
  mark_whole(L);
}

std::string error_text(lua_State* L, int index) {
  index = lua_absindex(L, index);
  if (lua_type(L, index) == LUA_TSTRING) return text_at(L, index);
  lua_checkstack(L, 8);
  lua_pushcfunction(L, own_text);
  lua_pushvalue(L, index);
  std::string text;
  if (lua_pcall(L, 1, 1, 0) == LUA_OK) text = text_at(L, -1);
  lua_pop(L, 1);
  if (!text.empty()) return text;
  return fmt::format("(error object is a {} value{})", luaL_typename(L, index),
                     lua_type(L, index) == LUA_TTABLE ? ": " + contents(L, index) : "");
}

int add_traceback(lua_State* L) {
  lua_settop(L, 1);
  if (lua_type(L, 1) != LUA_TSTRING) {
    const std::string text = error_text(L, 1);
    lua_pushlstring(L, text.data(), text.size());
    lua_replace(L, 1);
  }
  add_thread_traceback(L, L);
  return 1;
}

void call(lua_State* L, int arguments, int results) {
  const int handler = lua_gettop(L) - arguments;
  lua_pushcfunction(L, trace_text);
  lua_insert(L, handler);
  ++crossings;
  const int inner = std::exchange(at_work.inner, 0);
  int status = LUA_OK;
  {
    const DoorFor door(L, handler + 1);
    status = lua_pcall(L, arguments, results, handler);
  }
  at_work.inner = inner;
  ++crossings;
  lua_remove(L, handler);
  if (status == LUA_OK) return;
  const bool is_object = lua_type(L, -1) != LUA_TSTRING;
  const std::string limit = status == LUA_ERRMEM && limit_of_memory != nullptr ? limit_of_memory() : "";
  const std::string message = limit.empty() ? error_text(L, -1) : limit;
  if (is_object)
    lua_setfield(L, LUA_REGISTRYINDEX, error_object);
  else
    lua_pop(L, 1);
  throw ScriptError(message, is_object);
}

}  // namespace trilith::script
