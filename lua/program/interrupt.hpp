// Ctrl-C while Lua code or a stage runs.
#pragma once

#include "lua_api.hpp"

namespace trilith::program {

/// While it lives, SIGINT is counted and sets `hook` on the state (lua_sethook may be called from a signal). A hook
/// that is not the one a stage began with ends the stage at the next step border. After `patience` interrupts that
/// nobody took, the next one ends the program at once.
class InterruptScope {
 public:
  InterruptScope(lua_State* L, lua_Hook hook, int patience = 1);
  InterruptScope(const InterruptScope&) = delete;
  InterruptScope& operator=(const InterruptScope&) = delete;
  ~InterruptScope();

 private:
  void (*previous_)(int);
};

/// Interrupts that nobody took.
int interrupts();
/// Takes them all, and the hook away.
void forget_interrupts();

/// A hook: raises the error "interrupted" in the Lua code.
void raise_interrupt(lua_State* L, lua_Debug* at);

}  // namespace trilith::program
