#include "interrupt.hpp"

#include "guard.hpp"
#include "verbs.hpp"

namespace trilith::program {
namespace {

lua_State* volatile watched_state = nullptr;
lua_Hook volatile watched_hook = nullptr;
volatile std::sig_atomic_t count = 0, most = 1, ending = 0;

void set_hook() {
  if (watched_state != nullptr)
    lua_sethook(watched_state, watched_hook, LUA_MASKCALL | LUA_MASKRET | LUA_MASKLINE | LUA_MASKCOUNT, 1);
}

extern "C" void on_interrupt(int signal) {
  count = count + 1;
  if (count >= most) std::signal(signal, SIG_DFL);
  set_hook();
}

extern "C" void on_ending(int signal) {
  if (ending == 0) ending = signal;
  std::signal(signal, signal == SIGTERM ? SIG_DFL : SIG_IGN);
  set_hook();
}

}  // namespace

InterruptScope::InterruptScope(lua_State* L, lua_Hook hook, int patience) {
  count = 0;
  most = patience;
  ending = 0;
  watched_hook = hook;
  watched_state = L;
  previous_ = std::signal(SIGINT, on_interrupt);
  struct sigaction action {};
  action.sa_handler = on_ending;  // without SA_RESTART: a console that waits for a line waits no longer
  for (std::size_t i = 0; i < before_.size(); ++i) {
    ::sigaction(ending_signals[i], nullptr, &before_[i]);
    if (before_[i].sa_handler != SIG_IGN) ::sigaction(ending_signals[i], &action, nullptr);
  }
}

InterruptScope::~InterruptScope() {
  std::signal(SIGINT, previous_);
  // A pipe that nobody reads is told of at each line; the last ones must not end the program in another way.
  for (std::size_t i = 0; i < before_.size(); ++i)
    if (ending == 0) ::sigaction(ending_signals[i], &before_[i], nullptr);
  watched_state = nullptr;
}

int interrupts() {
  return count;
}

void forget_interrupts() {
  if (watched_state != nullptr && lua_gethook(watched_state) == watched_hook) lua_sethook(watched_state, nullptr, 0, 0);
  count = 0;
  if (watched_state != nullptr) std::signal(SIGINT, on_interrupt);
}

int ending_signal() {
  return ending;
}

int signal_code() {
  return ending != 0 ? 128 + ending : count > 0 ? interrupted : 0;
}

std::string signal_text() {
  switch (ending) {
    case SIGTERM:
      return "ended by SIGTERM";
    case SIGHUP:
      return "ended by SIGHUP: its terminal was closed";
    case SIGXCPU:
      return "ended by SIGXCPU: the limit of CPU time was reached";
    case SIGPIPE:
      return "ended by SIGPIPE: nobody reads its output any more";
    default:
      return "interrupted";
  }
}

void raise_interrupt(lua_State* L, lua_Debug*) {
  lua_sethook(L, nullptr, 0, 0);
  lua_pushliteral(L, "interrupted");
  script::mark_whole(L);
  lua_error(L);
}

}  // namespace trilith::program
