// Host side of the console: lua/console/*.lua reads and runs lines, this class provides the terminal and the run.
#pragma once

#include <string>

#include "bindings/core/host.hpp"
#include "bindings/core/lua_api.hpp"
#include "line_editor.hpp"

namespace trilith::program {

class ConsoleSession : public script::Console {
 public:
  /// Loads the console's Lua into the state; `host` and the state must outlive it. Throws InputError if that fails.
  ConsoleSession(lua_State* L, script::Host& host);

  bool was_interrupted() override;
  void open(lua_State* L, const std::string& why) override;

  /// The console at the top, until it is left. False where a chunk failed. A chunk with a search without a
  /// solution sets `no_solution` instead.
  bool top(lua_State* L);
  /// Pushes a message handler for lua_pcall that keeps the locals of the failed function.
  static void push_handler(lua_State* L);
  /// Text before a script's first line, which makes its locals available at the console afterwards.
  [[nodiscard]] static std::string prelude(lua_State* L);
  /// A text of the manual: of `name`, or "meta" or "check" (see console/manual_run.lua); false with the reason in
  /// `text`.
  static bool manual(lua_State* L, const std::string& what, const std::string& name, std::string& text);
  /// Action of Ctrl-C while Lua code runs: a hook for InterruptScope.
  static void on_interrupt(lua_State* L, lua_Debug* at);

  LineEditor editor;
  std::string failure;  ///< why the script before the console ended early; "": it did not
  bool no_solution = false;

 private:
  script::Host& host_;
};

}  // namespace trilith::program
