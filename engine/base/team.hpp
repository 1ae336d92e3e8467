// Loops whose items several threads share.
#pragma once

#include <atomic>
#include <cstdint>
#include <type_traits>

namespace trilith {

/// Most threads that a loop may be shared by.
inline constexpr int most_threads = 64;

/// How many threads the machine has for this process, at most most_threads.
int threads_here();

// What the two loops below come to behind their templates.
using StretchCall = void (*)(void* f, int first, int last, int thread);
void share_stretches(int threads, int count, int stretch, StretchCall call, void* f);
using SlotCall = void (*)(void* f, int first, int last, int thread, int slot);
void share_slots(int threads, int count, int stretch, SlotCall call, SlotCall then, void* both);

/// Calls f(first, last, thread) for stretches [first, last) that together are [0, count), each of `stretch` items but
/// the last; `thread`, from 0 to threads - 1, is that of the calling thread, for room of its own. In any order and at
/// the same time, so f writes only what belongs to its items, or to its thread and means nothing afterwards: then any
/// number of threads gives the same bits. What is not worth two threads, up to one stretch, is one call here. What f
/// throws is passed on once all others have ended.
template <class F>
void share(int threads, int count, int stretch, F&& f) {
  if (count <= 0) return;
  if (threads <= 1 || count <= stretch) return f(0, count, 0);
  using Item = std::remove_reference_t<F>;
  const auto call = [](void* body, int first, int last, int thread) {
    (*static_cast<Item*>(body))(first, last, thread);
  };
  share_stretches(threads, count, stretch, call, const_cast<void*>(static_cast<const void*>(&f)));
}

/// Stretches that are worked on, or wait for their turn, at the same time.
constexpr int stretches_under_way(int threads) {
  return threads <= 1 ? 1 : 4 * threads;
}

/// The same for what must be summed up in order: f(first, last, thread, slot) as with share(), in any order, and after
/// it then(first, last, slot) for the same stretch, in the order of the stretches and never two at a time, while others
/// go on with theirs. `slot`, below stretches_under_way(threads), is the stretch's own from the one to the end of the
/// other: room for what f hands to `then`.
template <class F, class G>
void share_in_order(int threads, int count, int stretch, F&& f, G&& then) {
  if (threads <= 1 || count <= stretch) {
    for (int first = 0; first < count; first += stretch) {
      const int last = count - first < stretch ? count : first + stretch;
      f(first, last, 0, 0);
      then(first, last, 0);
    }
    return;
  }
  struct Both {
    std::remove_reference_t<F>* f;
    std::remove_reference_t<G>* then;
  } both{&f, &then};
  share_slots(
      threads, count, stretch,
      [](void* b, int first, int last, int thread, int slot) {
        (*static_cast<Both*>(b)->f)(first, last, thread, slot);
      },
      [](void* b, int first, int last, int /*thread*/, int slot) { (*static_cast<Both*>(b)->then)(first, last, slot); },
      &both);
}

/// One look of a thread that waits for another, the `looks`th: it keeps its processor at first, and then lets others
/// have it.
void wait_a_moment(int looks);

/// What several threads may ask for at the same time and the first one makes, by f(). `made` is 0 before and 2 after;
/// whoever comes meanwhile waits. With one thread there is nobody to wait for, and nothing is paid for it. Where f
/// throws it is as if nobody had asked.
template <class F>
void make_once(int threads, std::uint8_t& made, F&& f) {
  constexpr std::uint8_t being_made = 1, is_made = 2;
  if (threads <= 1) {
    if (made == is_made) return;
    f();
    made = is_made;
    return;
  }
  const std::atomic_ref<std::uint8_t> shared(made);
  for (int looks = 0; shared.load(std::memory_order_acquire) != is_made; ++looks) {
    std::uint8_t now = 0;
    if (!shared.compare_exchange_strong(now, being_made)) {
      wait_a_moment(looks);
      continue;
    }
    try {
      f();
    } catch (...) {
      shared.store(0);
      throw;
    }
    shared.store(is_made, std::memory_order_release);
    return;
  }
}

}  // namespace trilith
