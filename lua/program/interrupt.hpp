// Signals that end a run in order: Ctrl-C, and those that ask a program to end.
#pragma once

#include <array>
#include <csignal>
#include <string>

#include "lua_api.hpp"

namespace trilith::program {

/// SIGTERM (batch systems, shutdown), SIGHUP (a closed terminal), SIGXCPU (the limit of CPU time) and SIGPIPE (nobody
/// reads the output).
inline constexpr std::array ending_signals{SIGTERM, SIGHUP, SIGXCPU, SIGPIPE};

/// While it lives, SIGINT and the ending signals are noted and set `hook` on the state (lua_sethook may be called from
/// a signal); no state: noted alone. A hook that is not the one a stage began with ends the stage at the next step
/// border. After `patience` interrupts that nobody took, the next one ends the program at once, and so does a second
/// SIGTERM; the others come in crowds (a closed terminal, each second beyond the limit), and later ones are ignored.
/// What was ignored when the program began, as under nohup, stays so, but for SIGINT.
class InterruptScope {
 public:
  InterruptScope(lua_State* L, lua_Hook hook, int patience = 1);
  InterruptScope(const InterruptScope&) = delete;
  InterruptScope& operator=(const InterruptScope&) = delete;
  ~InterruptScope();

 private:
  void (*previous_)(int);
  std::array<struct sigaction, ending_signals.size()> before_;
};

/// Interrupts that nobody took.
int interrupts();
/// Takes them all, and the hook away.
void forget_interrupts();

/// The first of the ending signals that came, or 0.
int ending_signal();
/// Exit code where a signal is to end the program: 128 and its number; 0 where none came.
int signal_code();
/// What the signal was, in words: "interrupted", "ended by SIGTERM".
std::string signal_text();

/// A hook: raises the error "interrupted" in the Lua code.
void raise_interrupt(lua_State* L, lua_Debug* at);

}  // namespace trilith::program
