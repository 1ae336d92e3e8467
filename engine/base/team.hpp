// Loops whose items several threads share.
#pragma once

#include <type_traits>

namespace trilith {

/// Most threads that a loop may be shared by.
inline constexpr int most_threads = 64;

/// How many threads the machine has for this process, at most most_threads.
int threads_here();

namespace detail {
using StretchCall = void (*)(void* f, int first, int last, int thread);
void share_stretches(int threads, int count, int stretch, StretchCall call, void* f);
}  // namespace detail

/// Calls f(first, last, thread) for stretches [first, last) that together are [0, count), each of `stretch` items but
/// the last; `thread`, from 0 to threads - 1, is that of the calling thread, for room of its own. In any order and at
/// the same time, so f writes only what belongs to its items, or to its thread and means nothing afterwards: then any
/// number of threads gives the same bits. What is not worth two threads, up to one stretch, is one call here. What f
/// throws is passed on once all others have ended.
template <class F>
void share(int threads, int count, int stretch, F&& f) {
  if (count <= 0) return;
  if (threads <= 1 || count <= stretch) return f(0, count, 0);
  using Body = std::remove_reference_t<F>;
  const auto call = [](void* body, int first, int last, int thread) {
    (*static_cast<Body*>(body))(first, last, thread);
  };
  detail::share_stretches(threads, count, stretch, call, const_cast<void*>(static_cast<const void*>(&f)));
}

}  // namespace trilith
