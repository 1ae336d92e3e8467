#include "script_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "guard.hpp"
#include "interrupt.hpp"

namespace trilith::program {
namespace {

using Clock = std::chrono::steady_clock;

/// Instructions between two looks at the clock: about a millisecond.
constexpr int instructions_between_looks = 100000;

struct Memory {
  double most = 0, held = 0;  ///< [bytes]
  std::string refusal;
} memory;

struct Time {
  double most = 0;  ///< [s]
  std::uint64_t crossings = 0;
  Clock::time_point begun;
} script_time;

void note_refusal() {
  lua_State* const L = thread_at_work();
  memory.refusal = fmt::format(
      "{}the script needs more than {:.4g} MB of memory; --script-memory allows more, as in --script-memory=8GB",
      L != nullptr ? script::user_place(L) : "", memory.most / 1e6);
}

/// As Lua's own allocator, with the limit. Lua calls it again after a full collection where it gives nothing.
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

void look_at_clock(lua_State* L, lua_Debug*) {
  const std::uint64_t now = script::engine_crossings();
  if (now != script_time.crossings) {
    script_time.crossings = now;
    script_time.begun = Clock::now();
    return;
  }
  if (std::chrono::duration<double>(Clock::now() - script_time.begun).count() < script_time.most) return;
  // No object with a destructor may be alive where the error is raised.
  char message[1000];
  {
    const std::string text = fmt::format(
        "{}the script has run for more than {:g} s without a call into the engine; --script-seconds allows more",
        script::user_place(L), script_time.most);
    message[text.copy(message, sizeof message - 1)] = '\0';
  }
  raise_final(L, message);
}

}  // namespace

void limit_memory(lua_State* L, double bytes) {
  memory = {};
  if (!(bytes > 0)) return;
  memory.most = bytes;
  memory.held = 1024.0 * lua_gc(L, LUA_GCCOUNT, 0) + lua_gc(L, LUA_GCCOUNTB, 0);
  lua_setallocf(L, allocate, nullptr);
}

const std::string& memory_refusal() {
  return memory.refusal;
}

void limit_time(lua_State* L, double seconds) {
  script_time = {seconds, script::engine_crossings(), Clock::now()};
  if (seconds > 0)
    set_standing_hook(L, look_at_clock, instructions_between_looks);
  else
    set_standing_hook(L, nullptr, 0);
}

}  // namespace trilith::program
