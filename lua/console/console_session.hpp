// The console as the host knows it: lua/console/*.lua reads and runs lines, this gives it the terminal and the run.
#pragma once

#include <string>

#include "bindings/core/host.hpp"
#include "bindings/core/lua_api.hpp"
#include "line_editor.hpp"

namespace trilith::program {

class ConsoleSession : public script::Console {
 public:
  /// Loads the console's Lua into the state; `host` and the state must outlive it. Throws InputError where that fails.
  ConsoleSession(lua_State* L, script::Host& host);

  bool was_interrupted() override;
  void open(lua_State* L, const std::string& why) override;

  /// The console at the top, until it is left. False where a chunk failed.
  bool top(lua_State* L);
  /// Pushes a message handler for lua_pcall that keeps the locals of what fails.
  static void push_handler(lua_State* L);
  /// What stands before a script's first line, so that its locals are seen at the console afterwards.
  [[nodiscard]] static std::string prelude(lua_State* L);
  /// A text of the manual: of `name`, or "meta" or "check" (see console/manual_run.lua); false with why not in `text`.
  static bool manual(lua_State* L, const std::string& what, const std::string& name, std::string& text);
  /// What Ctrl-C does while Lua code runs: a hook for InterruptScope.
  static void on_interrupt(lua_State* L, lua_Debug* at);

  LineEditor editor;
  std::string failure;  ///< why the script before the console ended early; "": it did not

 private:
  script::Host& host_;
};

}  // namespace trilith::program
