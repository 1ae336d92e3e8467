#include "interrupt.hpp"

#include <ctime>

#include "bindings/core/guard.hpp"
#include "verbs.hpp"

namespace trilith::program {
namespace {

/// A hook of the script that an interrupt has replaced.
struct PushedAside {
  lua_State* thread = nullptr;
  lua_Hook hook = nullptr;
  int mask = 0, count = 0;
};

constexpr int every_event = LUA_MASKCALL | LUA_MASKRET | LUA_MASKLINE | LUA_MASKCOUNT;
/// Instructions between two raises, within which finalizers and message handlers end.
constexpr int instructions_between = 1000000;

lua_State* volatile running_thread = nullptr;
lua_Hook volatile watched_hook = nullptr;
PushedAside aside;
/// Unless "": an error that no script can catch, other than an interrupt.
std::string final_error;
volatile std::sig_atomic_t count = 0, most = 1, ending = 0, raised = 0;
volatile std::time_t first_second = 0;
volatile long first_nanosecond = 0;

void arm(lua_State* L) {
  const lua_Hook own = lua_gethook(L);
  if (own != nullptr && own != watched_hook) aside = {L, own, lua_gethookmask(L), lua_gethookcount(L)};
  lua_sethook(L, watched_hook, every_event, 1);
}

void disarm(lua_State* L) {
  if (lua_gethook(L) != watched_hook) return;
  if (aside.thread == L)
    lua_sethook(L, aside.hook, aside.mask, aside.count);
  else
    lua_sethook(L, nullptr, 0, 0);
  if (aside.thread == L) aside = {};
}

void note_time() {
  std::timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  first_second = now.tv_sec;
  first_nanosecond = now.tv_nsec;
}

extern "C" void on_interrupt(int signal) {
  if (count == 0) note_time();
  count = count + 1;
  if (count >= most) std::signal(signal, SIG_DFL);
  if (running_thread != nullptr) arm(running_thread);
}

extern "C" void on_ending(int signal) {
  if (ending == 0 && count == 0) note_time();
  if (ending == 0) ending = signal;
  std::signal(signal, signal == SIGTERM ? SIG_DFL : SIG_IGN);
  if (running_thread != nullptr) arm(running_thread);
}

}  // namespace

InterruptScope::InterruptScope(lua_State* L, lua_Hook hook, int patience) : main_(L) {
  count = 0;
  raised = 0;
  ending = 0;
  final_error.clear();
  most = patience;
  watched_hook = hook;
  running_thread = L;
  previous_ = std::signal(SIGINT, on_interrupt);
  struct sigaction action {};
  action.sa_handler = on_ending;  // without SA_RESTART: a console stops waiting for a line
  for (std::size_t i = 0; i < before_.size(); ++i) {
    ::sigaction(ending_signals[i], nullptr, &before_[i]);
    if (before_[i].sa_handler != SIG_IGN) ::sigaction(ending_signals[i], &action, nullptr);
  }
}

InterruptScope::~InterruptScope() {
  std::signal(SIGINT, previous_);
  // A closed pipe raises a signal at each line; the last ones must not end the program in another way.
  for (std::size_t i = 0; i < before_.size(); ++i)
    if (ending == 0) ::sigaction(ending_signals[i], &before_[i], nullptr);
  if (main_ != nullptr) disarm(main_);
  running_thread = nullptr;
}

int interrupts() {
  return count;
}

bool is_interrupted() {
  return signal_code() != 0;
}

double since_interrupt() {
  std::timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec - first_second) + 1e-9 * static_cast<double>(now.tv_nsec - first_nanosecond);
}

void forget_interrupts() {
  quench_interrupt();
  count = 0;
  if (running_thread != nullptr) std::signal(SIGINT, on_interrupt);
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
      return "ended by SIGPIPE: the reader of its output ended";
    default:
      return "interrupted";
  }
}

void raise_interrupt(lua_State* L, lua_Debug*) {
  if (!final_error.empty() && raised != 0) {
    lua_pushlstring(L, final_error.data(), final_error.size());
    script::mark_whole(L);
    lua_error(L);
  }
  if (!is_interrupted()) {  // a coroutine that waited, or was created, during an interrupt
    disarm(L);
    return;
  }
  raised = 1;
  wait_with_interrupt(L, instructions_between);
  lua_pushliteral(L, "interrupted");
  script::mark_whole(L);
  lua_error(L);
}

void raise_final(lua_State* L, const char* message) {
  final_error = message;
  raised = 1;
  raise_interrupt(L, nullptr);
}

void wait_with_interrupt(lua_State* L, int instructions) {
  lua_sethook(L, watched_hook, LUA_MASKCOUNT, instructions);
}

bool is_raised() {
  return raised != 0;
}

void quench_interrupt() {
  raised = 0;
  final_error.clear();
  if (running_thread != nullptr) disarm(running_thread);
}

lua_State* thread_at_work() {
  return running_thread;
}

lua_State* switch_thread(lua_State* thread) {
  lua_State* const before = running_thread;
  if (before == nullptr) return nullptr;
  running_thread = thread;
  if (thread != nullptr && is_interrupted() && lua_gethook(thread) != watched_hook) arm(thread);
  return before;
}

}  // namespace trilith::program
