// Signals that end a run in order: Ctrl-C, and those that ask a program to end.
#pragma once

#include <array>
#include <csignal>
#include <string>

#include "bindings/core/lua_api.hpp"

namespace trilith::program {

/// SIGTERM (batch systems, shutdown), SIGHUP (a closed terminal), SIGXCPU (the limit of CPU time) and SIGPIPE (nobody
/// reads the output).
inline constexpr std::array ending_signals{SIGTERM, SIGHUP, SIGXCPU, SIGPIPE};

/// While it lives, SIGINT and the ending signals are noted and set `hook` on the thread of Lua that runs, the main one
/// or a coroutine (lua_sethook may be called from a signal); no state: noted alone. A stage sees what was noted, and
/// ends at the next step border. After `patience` interrupts that nobody took, the next one ends the program at once,
/// and so does a second SIGTERM; the others come in crowds (a closed terminal, each second beyond the limit), and later
/// ones are ignored. What was ignored when the program began, as under nohup, stays so, but for SIGINT.
class InterruptScope {
 public:
  InterruptScope(lua_State* L, lua_Hook hook, int patience = 1);
  InterruptScope(const InterruptScope&) = delete;
  InterruptScope& operator=(const InterruptScope&) = delete;
  ~InterruptScope();

 private:
  lua_State* main_;
  void (*previous_)(int);
  std::array<struct sigaction, ending_signals.size()> before_;
};

/// Interrupts that nobody took.
int interrupts();
/// Wall clock since the first of them [s].
double since_interrupt();
/// Takes them all.
void forget_interrupts();
/// True where nobody took one, or an ending signal came; a function for Host.
bool is_interrupted();

/// The first of the ending signals that came, or 0.
int ending_signal();
/// Exit code where a signal is to end the program: 128 and its number; 0 where none came.
int signal_code();
/// What the signal was, in words: "interrupted", "ended by SIGTERM".
std::string signal_text();

// For hooks; `L` is the thread they are called in.
/// Raises the error "interrupted" in the Lua code, or takes the hook away where the interrupt was taken meanwhile. What
/// catches the error does not get far: see is_raised, and the hook comes again after a while.
void raise_interrupt(lua_State* L, lua_Debug* at);
/// Raises an error that no script can catch; over with quench_interrupt.
void raise_final(lua_State* L, const char* message);
/// The hook comes again after so many instructions.
void wait_with_interrupt(lua_State* L, int instructions);

/// True from where "interrupted" was raised until quench_interrupt: whatever caught it has to raise it again.
bool is_raised();
/// The error has come to where it is told: no hook any more. The count stays, see forget_interrupts.
void quench_interrupt();

/// Puts pcall, xpcall and what coroutines are resumed with in the place of Lua's own: they do the same, but know which
/// thread runs, and raise an interrupt again that they caught.
void open_interruptible_calls(lua_State* L);

/// The thread of Lua that runs, nullptr where none is watched.
lua_State* thread_at_work();
/// For them: from now on `thread` runs; gives the one before.
lua_State* switch_thread(lua_State* thread);

}  // namespace trilith::program
