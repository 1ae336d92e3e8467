// Parallel loops over worker threads.
#pragma once

#include <atomic>
#include <cstdint>
#include <type_traits>

namespace trilith {

/// Largest number of threads of a loop.
inline constexpr int most_threads = 64;

/// Number of hardware threads available to this process, at most most_threads.
int threads_here();

// Type-erased implementations of the two loops below.
using StretchCall = void (*)(void* f, int first, int last, int thread);
void share_stretches(int threads, int count, int stretch, StretchCall call, void* f);
using SlotCall = void (*)(void* f, int first, int last, int thread, int slot);
void share_slots(int threads, int count, int stretch, SlotCall call, SlotCall then, void* both);

/// Calls f(first, last, thread) for chunks [first, last) that together cover [0, count). Each chunk has `stretch`
/// items, the last one perhaps fewer. `thread`, from 0 to threads - 1, is the calling thread and selects its scratch
/// buffer.
///
/// Chunks run in any order and concurrently. So f may write only data of its own items, or scratch data of its thread;
/// then every number of threads gives the same bits. Up to one chunk runs in the caller alone. An exception from f is
/// rethrown after all threads have ended.
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

/// Number of chunks that run or wait for their turn at the same time.
constexpr int stretches_under_way(int threads) {
  return threads <= 1 ? 1 : 4 * threads;
}

/// Like share(), for an ordered reduction. Calls f(first, last, thread, slot) for the chunks in any order, and after
/// each one then(first, last, slot) in the order of the chunks, never two at a time, while other chunks still run.
/// `slot`, below stretches_under_way(threads), belongs to the chunk from the start of f to the end of `then`; it
/// selects the buffer that f fills for `then`.
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

/// One poll of a waiting thread, number `looks`: it spins at first and yields the processor later.
void wait_a_moment(int looks);

/// Lazy initialisation shared by several threads: the first caller runs f(). `made` is 0 before and 2 after; other
/// callers wait meanwhile. With one thread there is no wait and no atomic operation. If f throws, `made` is reset.
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
