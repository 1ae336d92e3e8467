#include "program/script/limits.hpp"

#include <fmt/format.h>
#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <ctime>

#include "bindings/core/guard.hpp"
#include "interrupt.hpp"

namespace trilith::program {
namespace {

constexpr double longest_between = 10;  ///< interval of clock reads [s]

struct Memory {
  double most = 0, held = 0;  ///< [bytes]
  std::string refusal;
} memory;

/// A signal reads the clock at intervals: a hook that counts instructions would slow down all Lua code.
struct Time {
  double most = 0;  ///< [s]; 0: no limit
  std::uint64_t crossings = 0;
  std::uint64_t calls = 0;  ///< guarded functions that had begun at the last look
  std::timespec begun{};    ///< begin of the interval without a crossing
  timer_t timer{};
  bool runs = false;
} script_time;

void note_refusal() {
  lua_State* const L = thread_at_work();
  memory.refusal = fmt::format(
      "{}the script needs more than {:.4g} MB of memory; --script-memory allows more, as in --script-memory=8GB",
      L != nullptr ? script::user_place(L) : "", memory.most / 1e6);
}

/// As Lua's own allocator, with the limit. If it returns nothing, Lua calls it again after a full collection.
void* allocate(void*, void* block, std::size_t before, std::size_t wanted) {
  const double was = block != nullptr ? static_cast<double>(before) : 0;
  if (wanted == 0) {
    std::free(block);
    memory.held -= was;
    return nullptr;
  }
  const double more = static_cast<double>(wanted) - was;
  if (more > 0 && memory.held + more > memory.most) {
    note_refusal();
    return nullptr;
  }
  void* const found = std::realloc(block, wanted);
  if (found != nullptr) memory.held += more;
  return found;
}

/// Time after the last crossing, as far as the clock was read [s]; restarts after a crossing, and while one function of
/// the engine runs from one look to the next.
double seconds_alone() {
  std::timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  const std::uint64_t crossings = script::engine_crossings();
  const script::EngineCalls calls = script::engine_calls();
  if (crossings != script_time.crossings || (calls.within && calls.begun == script_time.calls)) {
    script_time.crossings = crossings;
    script_time.begun = now;
  }
  script_time.calls = calls.begun;
  return static_cast<double>(now.tv_sec - script_time.begun.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec - script_time.begun.tv_nsec);
}

/// A hook: raises the error at the script's next instruction, unless the engine ran meanwhile.
void raise_at_limit(lua_State* L, lua_Debug*) {
  if (seconds_alone() < script_time.most) {
    lua_sethook(L, nullptr, 0, 0);
    return;
  }
  lua_sethook(L, raise_at_limit, LUA_MASKCOUNT, 1000000);
  char message[1000];  // no object with a destructor may be alive where the error is raised
  {
    const std::string text = fmt::format(
        "{}the script has run for more than {:g} s without a stage or another long computation of the engine; "
        "--script-seconds allows more",
        script::user_place(L), script_time.most);
    message[text.copy(message, sizeof message - 1)] = '\0';
  }
  raise_final(L, message);
}

extern "C" void on_look(int) {
  lua_State* const L = thread_at_work();
  if (L == nullptr || seconds_alone() < script_time.most) return;
  if (lua_gethook(L) != raise_at_limit) lua_sethook(L, raise_at_limit, LUA_MASKCALL | LUA_MASKRET | LUA_MASKCOUNT, 1);
}

/// A forked process (a case of a study) does not inherit the timer.
extern "C" void start_timer() {
  if (!(script_time.most > 0)) return;
  struct sigaction action {};
  action.sa_handler = on_look;
  action.sa_flags = SA_RESTART;
  ::sigaction(SIGVTALRM, &action, nullptr);
  sigevent event{};
  event.sigev_notify = SIGEV_THREAD_ID;
  event.sigev_signo = SIGVTALRM;
  event._sigev_un._tid = ::gettid();
  script_time.runs = ::timer_create(CLOCK_MONOTONIC, &event, &script_time.timer) == 0;
  if (!script_time.runs) return;
  const double between = std::clamp(script_time.most / 8, 0.01, longest_between);
  itimerspec times{};
  times.it_interval.tv_sec = static_cast<std::time_t>(between);
  times.it_interval.tv_nsec = static_cast<long>(1e9 * (between - std::floor(between)));
  times.it_value = times.it_interval;
  ::timer_settime(script_time.timer, 0, &times, nullptr);
}

}  // namespace

void limit_memory(lua_State* L, double bytes) {
  memory = {};
  if (!(bytes > 0)) return;
  memory.most = bytes;
  memory.held = 1024.0 * lua_gc(L, LUA_GCCOUNT, 0) + lua_gc(L, LUA_GCCOUNTB, 0);
  lua_setallocf(L, allocate, nullptr);
  script::explain_lack_of_memory(memory_refusal);
}

std::string memory_refusal() {
  return memory.refusal;
}

void limit_time(double seconds) {
  if (script_time.runs) ::timer_delete(script_time.timer);
  script_time = {};
  script_time.most = seconds;
  script_time.crossings = script::engine_crossings();
  ::clock_gettime(CLOCK_MONOTONIC, &script_time.begun);
  static const int registered = ::pthread_atfork(nullptr, nullptr, start_timer);
  if (registered == 0) start_timer();
}

}  // namespace trilith::program
