#include "base/team.hpp"

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <memory>
#include <mutex>

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

}  // namespace

int threads_here() {
  return std::clamp(tbb::info::default_concurrency(), 1, most_threads);
}

/// Threads take one stretch after the other as they come free: one that the machine holds up delays no more than the
/// stretch it is at, where a fixed share for each would make all others wait.
void detail::share_stretches(int threads, int count, int stretch, StretchCall call, void* f) {
  const int stretches = (count + stretch - 1) / stretch;
  arena_of(std::min(threads, most_threads)).execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<int>(0, stretches, 1),
        [&](const tbb::blocked_range<int>& range) {
          const int thread = tbb::this_task_arena::current_thread_index();
          for (int s = range.begin(); s < range.end(); ++s)
            call(f, s * stretch, std::min(count, (s + 1) * stretch), thread);
        },
        tbb::simple_partitioner());
  });
}

/// A pipeline of three: the next stretch, what is done to it, and what comes after that in order. A stretch that is
/// done before its turn waits in its slot; who comes to its turn takes up those that wait.
void detail::share_in_order(int threads, int count, int stretch, SlotCall call, SlotCall then, void* both) {
  const int stretches = (count + stretch - 1) / stretch, slots = stretches_under_way(std::min(threads, most_threads));
  const auto pass = [&](SlotCall to, int s) {
    to(both, s * stretch, std::min(count, (s + 1) * stretch), tbb::this_task_arena::current_thread_index(), s % slots);
  };
  int next = 0;
  const auto give = [&](tbb::flow_control& flow) {
    if (next == stretches) flow.stop();
    return next < stretches ? next++ : 0;
  };
  const auto work = [&](int s) { return pass(call, s), s; };
  const auto take_up = [&](int s) { pass(then, s); };
  arena_of(std::min(threads, most_threads)).execute([&] {
    tbb::parallel_pipeline(static_cast<std::size_t>(slots),
                           tbb::make_filter<void, int>(tbb::filter_mode::serial_in_order, give) &
                               tbb::make_filter<int, int>(tbb::filter_mode::parallel, work) &
                               tbb::make_filter<int, void>(tbb::filter_mode::serial_in_order, take_up));
  });
}

}  // namespace trilith
