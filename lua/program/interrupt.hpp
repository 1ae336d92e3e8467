// Signals that end a run in order: Ctrl-C, and termination signals.
#pragma once

#include <array>
#include <csignal>
#include <string>

#include "bindings/core/lua_api.hpp"

namespace trilith::program {

/// SIGTERM (batch systems, shutdown), SIGHUP (a closed terminal), SIGXCPU (the limit of CPU time) and SIGPIPE (closed
/// output).
inline constexpr std::array ending_signals{SIGTERM, SIGHUP, SIGXCPU, SIGPIPE};

/// During its lifetime, SIGINT and the ending signals are noted and set `hook` on the running Lua thread, the main one
/// or a coroutine (lua_sethook may be called from a signal). Without a state they are only noted. A stage checks the
/// noted signals, and ends at the next step border. After `patience` unhandled interrupts the next one ends the program
/// at once, and so does a second SIGTERM. The other signals arrive in groups (a closed terminal, each second beyond the
/// limit), and later ones are ignored. Signals that were ignored at the start of the program, as under nohup, remain
/// ignored, except SIGINT.
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

/// Number of unhandled interrupts.
int interrupts();
/// Wall clock after the first of them, or after the ending signal [s].
double since_interrupt();
/// Marks all as handled.
void forget_interrupts();
/// True for an unhandled interrupt or an ending signal; a function for Host.
bool is_interrupted();

/// The first ending signal, or 0.
int ending_signal();
/// Exit code if a signal ends the program: 128 plus its number; 0 without a signal.
int signal_code();
/// The signal in words: "interrupted", "ended by SIGTERM".
std::string signal_text();

// For hooks; `L` is the calling thread.
/// Raises the error "interrupted" in the Lua code, or removes the hook if the interrupt was handled meanwhile. Code
/// that catches the error does not continue for long: see is_raised, and the hook runs again after a while.
void raise_interrupt(lua_State* L, lua_Debug* at);
/// Raises an error that no script can catch, until quench_interrupt.
void raise_final(lua_State* L, const char* message);
/// Calls the hook again after this number of instructions.
void wait_with_interrupt(lua_State* L, int instructions);

/// True from the raise of "interrupted" until quench_interrupt: code that caught it must raise it again.
bool is_raised();
/// Called before the error is printed: removes the hook. The count remains, see forget_interrupts.
void quench_interrupt();

/// Replaces pcall, xpcall and the functions that resume coroutines. The replacements behave equally, but track the
/// running thread, and raise a caught interrupt again.
void open_interruptible_calls(lua_State* L);

/// The running Lua thread, nullptr if none is watched.
lua_State* thread_at_work();
/// For these functions: `thread` runs from now on; returns the previous one.
lua_State* switch_thread(lua_State* thread);

}  // namespace trilith::program
