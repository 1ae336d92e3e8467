#include "base/team.hpp"

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>

namespace trilith {
namespace {

/// One arena for each number of threads that was asked for: making one costs more than a loop.
tbb::task_arena& arena_of(int threads) {
  static std::mutex guard;
  static std::array<std::unique_ptr<tbb::task_arena>, most_threads + 1> arena;
  const std::lock_guard lock(guard);
  auto& one = arena[static_cast<std::size_t>(threads)];
  if (one == nullptr) one = std::make_unique<tbb::task_arena>(threads);
  return *one;
}

/// Runs f once in each of `threads` threads, or fewer where they are busy: whoever ends first runs it again in place of
/// one that has not begun, and then finds nothing left to do. What f throws is passed on once all have ended.
template <class F>
void together(int threads, F&& f) {
  arena_of(std::min(threads, most_threads)).execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<int>(0, threads, 1), [&](const tbb::blocked_range<int>& /*one*/) { f(); },
        tbb::simple_partitioner());
  });
}

/// Tells the others where a thread leaves by an exception, as they may wait for what it was at.
class Failing {
 public:
  explicit Failing(std::atomic<bool>& failed) : failed_(failed) {}
  Failing(const Failing&) = delete;
  Failing& operator=(const Failing&) = delete;
  ~Failing() {
    if (std::uncaught_exceptions() > before_) failed_ = true;
  }

 private:
  std::atomic<bool>& failed_;
  const int before_ = std::uncaught_exceptions();
};

/// A thread that finds all slots in use looks so many times before it lets others have its processor.
constexpr int spins_before_yielding = 1000;

}  // namespace

int threads_here() {
  return std::clamp(tbb::info::default_concurrency(), 1, most_threads);
}

/// Threads take one stretch after the other as they come free: one that the machine holds up delays no more than the
/// stretch it is at, where a fixed share for each would make all others wait.
void share_stretches(int threads, int count, int stretch, StretchCall call, void* f) {
  const int stretches = (count + stretch - 1) / stretch;
  std::atomic<int> next = 0;
  std::atomic<bool> failed = false;
  together(std::min(threads, stretches), [&] {
    const Failing failing(failed);
    const int thread = tbb::this_task_arena::current_thread_index();
    for (int s = next++; s < stretches && !failed; s = next++)
      call(f, s * stretch, std::min(count, (s + 1) * stretch), thread);
  });
}

namespace {

/// Stretches under way. Their numbers run on, and slot s % slots holds what stretch s is at.
struct Line {
  Line(int stretches, int slots) : stretches(stretches), slots(slots) {}

  const int stretches, slots;
  alignas(64) std::atomic<int> next = 0;                                     ///< to be worked on
  alignas(64) std::atomic<int> taken = 0;                                    ///< taken up, all before it included
  std::atomic<bool> taking = false;                                          ///< some thread takes up
  std::array<std::atomic<int>, stretches_under_way(most_threads)> worked{};  ///< [slot] 1 + the stretch last done

  /// A stretch whose slot is free; -1 where all slots are in use, `stretches` where there are no more.
  int claim() {
    int s = next;
    while (s < stretches && s - taken < slots)
      if (next.compare_exchange_weak(s, s + 1)) return s;
    return s < stretches ? -1 : stretches;
  }
  [[nodiscard]] bool has_turn() const {
    const int turn = taken;
    return turn < stretches && worked[static_cast<std::size_t>(turn % slots)] == turn + 1;
  }
  /// Takes up what is done and has its turn, if no other thread is at that. One that comes while another is leaving is
  /// not lost: who leaves looks once more.
  template <class TakeUp>
  void take_up(TakeUp&& one) {
    while (has_turn() && !taking.exchange(true)) {
      while (has_turn()) {
        one(taken.load());
        ++taken;
      }
      taking = false;
    }
  }
};

}  // namespace

/// Each thread takes the next stretch, works on it, and then takes up all that have come to their turn. One that
/// waits for its turn stays in its slot; where all slots wait for one that is held up, the others wait too.
void share_slots(int threads, int count, int stretch, SlotCall call, SlotCall then, void* both) {
  const int stretches = (count + stretch - 1) / stretch;
  Line line(stretches, stretches_under_way(std::min(threads, most_threads)));
  std::atomic<bool> failed = false;
  together(std::min(threads, stretches), [&] {
    const Failing failing(failed);
    const int thread = tbb::this_task_arena::current_thread_index();
    const auto pass = [&](SlotCall to, int s) {
      to(both, s * stretch, std::min(count, (s + 1) * stretch), thread, s % line.slots);
    };
    int waits = 0;
    for (int s = line.claim(); s < stretches && !failed; s = line.claim()) {
      if (s >= 0) {
        pass(call, s);
        line.worked[static_cast<std::size_t>(s % line.slots)] = s + 1;
      }
      line.take_up([&](int turn) { pass(then, turn); });
      waits = s >= 0 ? 0 : waits + 1;
      if (waits > spins_before_yielding) std::this_thread::yield();
    }
  });
}

}  // namespace trilith
