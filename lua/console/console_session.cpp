#include "console_session.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "bindings/core/guard.hpp"
#include "bindings/core/no_solution_error.hpp"
#include "bindings/core/open.hpp"
#include "interrupt.hpp"
#include "program/script/run.hpp"
#include "verbs.hpp"

namespace trilith::program {
namespace {

const char session_key = 's';
constexpr const char* console_table = "trilith.console";

ConsoleSession& session_of(lua_State* L) {
  lua_rawgetp(L, LUA_REGISTRYINDEX, &session_key);
  auto* session = static_cast<ConsoleSession*>(lua_touserdata(L, -1));
  lua_pop(L, 1);
  return *session;
}

script::Host& host_of(lua_State* L) {
  return *static_cast<script::Host*>(lua_touserdata(L, lua_upvalueindex(1)));
}

using script::text_at;

/// Time that Lua code may continue after Ctrl-C before it counts as endless [s]; a handler ends earlier.
constexpr double longest_wait = 0.5;

/// Completions from console.complete(before, session): first letter (from 1), names. Session: stack index 2 of
/// terminal.read, which is running.
Completion complete(lua_State* L, const std::string& before) {
  Completion found;
  const int top = lua_gettop(L);
  lua_checkstack(L, 10);
  lua_getfield(L, LUA_REGISTRYINDEX, console_table);
  lua_getfield(L, -1, "complete");
  lua_pushlstring(L, before.data(), before.size());
  lua_pushvalue(L, 2);
  if (lua_pcall(L, 2, 2, 0) == LUA_OK && lua_istable(L, -1)) {
    found.from = static_cast<std::size_t>(lua_tointeger(L, -2)) - 1;
    for (lua_Integer i = 1; lua_rawgeti(L, -1, i) == LUA_TSTRING; ++i) {
      found.names.push_back(text_at(L, -1));
      lua_pop(L, 1);
    }
  }
  lua_settop(L, top);
  return found;
}

/// terminal.read(prompt, session): a line, nil at the end of the input, false if Ctrl-C cancelled it.
int read(lua_State* L) {
  script::Host& host = host_of(L);
  if (host.observer != nullptr) host.observer->clear();
  lua_settop(L, 2);
  LineEditor& editor = session_of(L).editor;
  editor.complete_with([L](const std::string& before) { return complete(L, before); });
  std::string line;
  const LineEditor::Read was = editor.read(text_at(L, 1), line);
  if (ending_signal() != 0) end_by_signal(host);
  if (editor.terminal()) forget_interrupts();  // pressed while nothing ran
  if (was == LineEditor::Read::line)
    lua_pushlstring(L, line.data(), line.size());
  else if (was == LineEditor::Read::cancelled)
    lua_pushboolean(L, 0);
  else
    lua_pushnil(L);
  return 1;
}

int write_to(lua_State* L, std::FILE* out) {
  script::Host& host = host_of(L);
  if (host.observer != nullptr) host.observer->clear();
  std::fflush(stdout);
  const std::string text = text_at(L, 1);
  std::fwrite(text.data(), 1, text.size(), out);
  std::fflush(out);
  return 0;
}
int write(lua_State* L) {
  return write_to(L, stdout);
}
int write_error(lua_State* L) {
  return write_to(L, stderr);
}

/// terminal.told(message): an error is printed; if it is an interrupt, the interrupt ends here. True if the message is
/// of a search without a solution.
int told(lua_State* L) {
  quench_interrupt();
  if (session_of(L).editor.terminal()) forget_interrupts();
  lua_pushboolean(L, script::is_no_solution(L, text_at(L, 1)) ? 1 : 0);
  return 1;
}

/// terminal.quit(code, why): ends the program; results are complete if `why` is "".
int quit(lua_State* L) {
  script::Host& host = host_of(L);
  const std::string why = text_at(L, 2);
  host.finish(why.empty() ? session_of(L).failure : why);
  if (host.observer != nullptr) host.observer->clear();
  std::exit(static_cast<int>(lua_tointeger(L, 1)));
}

int load_console(lua_State* L) {
  auto* host = static_cast<script::Host*>(lua_touserdata(L, 1));
  lua_newtable(L);  // console
  lua_pushvalue(L, -1);
  lua_setfield(L, LUA_REGISTRYINDEX, console_table);
  lua_newtable(L);  // terminal
  const luaL_Reg functions[] = {{"read", script::guarded<read>},
                                {"write", script::guarded<write>},
                                {"write_error", script::guarded<write_error>},
                                {"quit", script::guarded<quit>},
                                {"traced", script::add_traceback},
                                {"told", script::guarded<told>},
                                {nullptr, nullptr}};
  lua_pushlightuserdata(L, host);
  luaL_setfuncs(L, functions, 1);
  lua_pushboolean(L, session_of(L).editor.terminal() ? 1 : 0);
  lua_setfield(L, -2, "interactive");
  for (const char* file :
       {"show", "words", "manual", "help", "meta", "pages", "declared", "manual_run", "complete", "session"}) {
    script::load_library_file(L, file);
    lua_pushvalue(L, 2);
    script::push_core(L);
    lua_pushvalue(L, 3);
    lua_call(L, 3, 0);
  }
  return 0;
}

}  // namespace

ConsoleSession::ConsoleSession(lua_State* L, script::Host& host) : host_(host) {
  lua_pushlightuserdata(L, this);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &session_key);
  lua_pushcfunction(L, load_console);
  lua_pushlightuserdata(L, &host);
  script::call(L, 1, 0);
}

bool ConsoleSession::was_interrupted() {
  if (ending_signal() != 0) end_by_signal(host_);
  if (!editor.terminal() || interrupts() == 0) return false;
  forget_interrupts();
  return true;
}

void ConsoleSession::open(lua_State* L, const std::string& why) {
  if (host_.observer != nullptr) host_.observer->clear();
  lua_getfield(L, LUA_REGISTRYINDEX, console_table);
  lua_getfield(L, -1, "pause");
  lua_replace(L, -2);
  lua_insert(L, -2);
  lua_pushlstring(L, why.data(), why.size());
  lua_insert(L, -2);
  script::call(L, 2, 0);
}

void ConsoleSession::push_handler(lua_State* L) {
  lua_getfield(L, LUA_REGISTRYINDEX, console_table);
  lua_getfield(L, -1, "told");
  lua_replace(L, -2);
}

bool ConsoleSession::top(lua_State* L) {
  lua_getfield(L, LUA_REGISTRYINDEX, console_table);
  lua_getfield(L, -1, "top");
  lua_replace(L, -2);
  script::call(L, 0, 2);
  const bool good = lua_toboolean(L, -2) != 0;
  no_solution = no_solution || lua_toboolean(L, -1) != 0;
  lua_pop(L, 2);
  return good;
}

std::string ConsoleSession::prelude(lua_State* L) {
  lua_getfield(L, LUA_REGISTRYINDEX, console_table);
  lua_getfield(L, -1, "prelude");
  std::string text = text_at(L, -1);
  lua_pop(L, 2);
  return text;
}

bool ConsoleSession::manual(lua_State* L, const std::string& what, const std::string& name, std::string& text) {
  lua_getfield(L, LUA_REGISTRYINDEX, console_table);
  lua_getfield(L, -1, "manual_text");
  lua_replace(L, -2);
  lua_pushstring(L, what.c_str());
  lua_pushstring(L, name.c_str());
  script::call(L, 2, 2);
  const bool good = !lua_isnil(L, -2);
  text = text_at(L, good ? -2 : -1);
  lua_pop(L, 2);
  return good;
}

void ConsoleSession::on_interrupt(lua_State* L, lua_Debug* at) {
  ConsoleSession& session = session_of(L);
  if (ending_signal() != 0) end_by_signal(session.host_);
  // A running stage pauses at its next step border, if the running handler ends; a second interrupt does not wait for
  // that.
  if (session.host_.running > 0 && interrupts() == 1 && !is_raised() && session.editor.terminal() &&
      since_interrupt() < longest_wait) {
    wait_with_interrupt(L, 1000);
    return;
  }
  raise_interrupt(L, at);
}

}  // namespace trilith::program
