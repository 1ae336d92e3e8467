#include "base/team.hpp"

#include <sched.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>

namespace trilith {
namespace {

/// Polls of a waiting thread before it yields the processor.
constexpr int spins_before_yielding = 1000;

void rest_a_moment() {
#ifdef __x86_64__
  __builtin_ia32_pause();
#endif
}

}  // namespace

void wait_a_moment(int looks) {
  looks < spins_before_yielding ? rest_a_moment() : std::this_thread::yield();
}

namespace {

using Clock = std::chrono::steady_clock;

/// Time that the calling thread has lost by waiting for delayed workers; decides whether threads are used.
///
/// A loop ends only after all chunks. If other programs occupy all processors, a worker may be delayed by milliseconds
/// in a loop of microseconds. Each such wait is a loss. Losses below a third of the elapsed time decay, because two
/// threads gain more than that. Above this limit the caller works alone for a while, twice as long if the limit is
/// reached again soon.
class Losses {
 public:
  /// True: the caller must not wait for workers.
  [[nodiscard]] bool are_high() {
    if (alone_until_ == Clock::time_point{}) return false;
    const Clock::time_point now = Clock::now();
    if (now < alone_until_) return true;
    if (now - alone_until_ > 4 * alone_for_) alone_until_ = {}, alone_for_ = shortest;
    return false;
  }
  void add(Clock::time_point from, Clock::time_point to) {
    lost_ = std::max(Clock::duration::zero(), lost_ - (from - last_) / 3) + (to - from);
    last_ = to;
    if (lost_ < most) return;
    alone_for_ = std::min<Clock::duration>(alone_until_ == Clock::time_point{} ? shortest : 2 * alone_for_, longest);
    alone_until_ = to + alone_for_;
    lost_ = {};
  }

 private:
  static constexpr Clock::duration most = std::chrono::milliseconds(16), shortest = std::chrono::milliseconds(20),
                                   longest = std::chrono::milliseconds(640);
  Clock::duration lost_{}, alone_for_ = shortest;
  Clock::time_point last_ = Clock::now(), alone_until_{};
};

/// One wait for other threads, poll by poll. Reports to `losses` where it outlasts the first polls, unless it is
/// nullptr.
class Wait {
 public:
  explicit Wait(Losses* losses) : losses_(losses) {}
  void look() {
    if (looks_ == spins_before_yielding && losses_ != nullptr) from_ = Clock::now();
    wait_a_moment(looks_++);
  }
  /// The awaited event has happened.
  void end() {
    if (looks_ > spins_before_yielding && losses_ != nullptr) losses_->add(from_, Clock::now());
    looks_ = 0;
  }

 private:
  Losses* losses_;
  int looks_ = 0;
  Clock::time_point from_;
};

/// Worker threads. They spin for a while after a loop, because the next loop of a step follows within microseconds, and
/// then sleep. The caller works too and does not wait for workers that have not entered, so on a busy machine it does
/// all the work. One caller at a time uses the workers; a concurrent caller works alone.
class Crew {
 public:
  /// Runs call(f, thread) in the calling thread, as thread 0, and in up to `threads` - 1 workers that enter before it
  /// has finished. An exception is rethrown after all have ended.
  void run(int threads, void (*call)(void*, int), void* f) {
    if (threads <= 1 || busy_.exchange(true)) return call(f, 0);
    call_ = call, f_ = f, thrown_ = nullptr;
    losses_.are_high() ? guarded(0) : run_with_others(threads - 1);
    const std::exception_ptr thrown = thrown_;
    busy_ = false;
    if (thrown) std::rethrow_exception(thrown);
  }
  /// Losses of the current caller.
  [[nodiscard]] Losses& losses() { return losses_; }

 private:
  // Bit fields of the gate, from the lowest: threads inside, threads that have entered, seats, the open flag, and the
  // number of the loop.
  static constexpr std::uint64_t count_mask = 0xff, open_bit = std::uint64_t{1} << 24;
  static constexpr int entered_shift = 8, seats_shift = 16, epoch_shift = 25;
  static constexpr auto awake = std::chrono::microseconds(300);

  alignas(64) std::atomic<std::uint64_t> gate_ = 0;
  alignas(64) std::atomic<std::uint32_t> bell_ = 0;
  std::atomic<bool> busy_ = false;
  void (*call_)(void*, int) = nullptr;
  void* f_ = nullptr;
  std::mutex throwing_;
  std::exception_ptr thrown_;
  int hired_ = 0;
  Losses losses_;  ///< of the caller that has set busy_

  void run_with_others(int others) {
    hire(others);
    const std::uint64_t epoch = (gate_.load() >> epoch_shift) + 1;
    gate_ = epoch << epoch_shift | open_bit | static_cast<std::uint64_t>(others) << seats_shift;
    ++bell_;
    bell_.notify_all();
    guarded(0);
    gate_.fetch_and(~open_bit);
    Wait wait(&losses_);
    while ((gate_.load() & count_mask) != 0) wait.look();
    wait.end();
  }
  void hire(int count) {
    for (; hired_ < count; ++hired_) std::thread([this] { serve(); }).detach();
  }
  void guarded(int thread) {
    try {
      call_(f_, thread);
    } catch (...) {
      const std::lock_guard lock(throwing_);
      if (!thrown_) thrown_ = std::current_exception();
    }
  }
  /// Enters, works and leaves, if the gate is open, a seat is free, and this thread has not yet entered for this loop.
  bool enter(std::uint64_t& last_epoch) {
    std::uint64_t gate = gate_;
    while ((gate & open_bit) != 0 && gate >> epoch_shift != last_epoch) {
      const std::uint64_t entered = gate >> entered_shift & count_mask;
      if (entered >= (gate >> seats_shift & count_mask)) return false;
      if (!gate_.compare_exchange_weak(gate, gate + 1 + (std::uint64_t{1} << entered_shift))) continue;
      last_epoch = gate >> epoch_shift;
      guarded(static_cast<int>(entered) + 1);
      --gate_;
      return true;
    }
    return false;
  }
  [[noreturn]] void serve() {
    std::uint64_t last_epoch = 0;
    Clock::time_point until = Clock::now() + awake;
    for (;;) {
      const std::uint32_t rung = bell_;
      for (int i = 0; i < 200; ++i) {
        if (enter(last_epoch)) until = Clock::now() + awake;
        rest_a_moment();
      }
      if (Clock::now() > until) {
        bell_.wait(rung);
        until = Clock::now() + awake;
      } else {
        std::this_thread::yield();
      }
    }
  }
};

/// Never destroyed: workers may still wait when the process ends, and a forked child process has none of them.
Crew& crew() {
  static Crew* const one = new Crew;
  return *one;
}

/// Runs f(thread) in up to `threads` threads at the same time.
template <class F>
void together(int threads, F&& f) {
  using Body = std::remove_reference_t<F>;
  crew().run(
      std::min(threads, most_threads), [](void* body, int thread) { (*static_cast<Body*>(body))(thread); }, &f);
}

/// Signals to the other threads that a thread has left by an exception, because they may wait for its chunk.
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

}  // namespace

int threads_here() {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  const bool is_known = sched_getaffinity(0, sizeof allowed, &allowed) == 0;
  return std::clamp(is_known ? CPU_COUNT(&allowed) : static_cast<int>(std::thread::hardware_concurrency()), 1,
                    most_threads);
}

namespace {

/// Chunks [first, last) of one thread: the owner takes them from the front; threads without chunks of their own take
/// them from the back.
class alignas(64) Share {
 public:
  void set(int first, int last) { ends_ = packed(first, last); }
  /// The next chunk; -1 if none is left.
  int take_front() {
    return take([](std::uint32_t& first, std::uint32_t& /*last*/) { return first++; });
  }
  int take_back() {
    return take([](std::uint32_t& /*first*/, std::uint32_t& last) { return --last; });
  }

 private:
  std::atomic<std::uint64_t> ends_ = 0;

  static std::uint64_t packed(std::uint64_t first, std::uint64_t last) { return first << 32 | last; }
  template <class Take>
  int take(Take&& one) {
    for (std::uint64_t ends = ends_;;) {
      auto first = static_cast<std::uint32_t>(ends >> 32), last = static_cast<std::uint32_t>(ends);
      if (first >= last) return -1;
      const std::uint32_t taken = one(first, last);
      if (ends_.compare_exchange_weak(ends, packed(first, last))) return static_cast<int>(taken);
    }
  }
};

}  // namespace

/// Each thread has the same partition in every step, so its data stays in its cache. A thread that has finished its
/// partition takes chunks from the others; so a delayed thread holds up its current chunk alone.
void share_stretches(int threads, int count, int stretch, StretchCall call, void* f) {
  const int stretches = (count + stretch - 1) / stretch, shares = std::min({threads, stretches, most_threads});
  std::array<Share, most_threads> share;
  const auto first_of = [&](int t) { return static_cast<int>(static_cast<std::int64_t>(stretches) * t / shares); };
  for (int t = 0; t < shares; ++t) share[static_cast<std::size_t>(t)].set(first_of(t), first_of(t + 1));
  std::atomic<bool> failed = false;
  together(shares, [&](int thread) {
    const Failing failing(failed);
    for (int k = 0; k < shares; ++k) {
      Share& of = share[static_cast<std::size_t>((thread + k) % shares)];
      const auto next = [&] { return failed ? -1 : k == 0 ? of.take_front() : of.take_back(); };
      for (int s = next(); s >= 0; s = next()) call(f, s * stretch, std::min(count, (s + 1) * stretch), thread);
    }
  });
}

namespace {

/// The chunks of share_slots(). Their numbers increase, and slot s % slots holds the state of chunk s. Thread t of n
/// works on chunks t, t + n, t + 2n ..., the same in every step, so that their data stays in its cache. It takes chunks
/// of other threads where its own next chunk has to wait.
struct Line {
  Line(int stretches, int slots, int threads) : stretches(stretches), slots(slots), threads(threads) {
    for (int t = 0; t < threads; ++t) next[static_cast<std::size_t>(t)].of = t;
  }

  struct alignas(64) Next {
    std::atomic<int> of = 0;
  };
  const int stretches, slots, threads;
  std::array<Next, most_threads> next;                                       ///< [thread] next chunk to be worked on
  alignas(64) std::atomic<int> taken = 0;                                    ///< chunks before this one are reduced
  std::atomic<bool> taking = false;                                          ///< a thread is in take_up()
  std::array<std::atomic<int>, stretches_under_way(most_threads)> worked{};  ///< [slot] 1 + the last finished chunk

  /// A chunk with a free slot, preferably of this thread; -1 where all slots are in use, `stretches` where no chunk is
  /// left.
  int claim(int thread) {
    bool some_left = false;
    for (int k = 0; k < threads; ++k) {
      std::atomic<int>& of = next[static_cast<std::size_t>((thread + k) % threads)].of;
      int s = of;
      while (s < stretches && s - taken < slots)
        if (of.compare_exchange_weak(s, s + threads)) return s;
      some_left = some_left || s < stretches;
    }
    return some_left ? -1 : stretches;
  }
  [[nodiscard]] bool has_turn() const {
    const int turn = taken;
    return turn < stretches && worked[static_cast<std::size_t>(turn % slots)] == turn + 1;
  }
  /// Reduces finished chunks in order, unless another thread is doing so. A chunk that finishes while that thread
  /// leaves is not lost: the thread checks once more before it leaves.
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

/// Each thread takes its next chunk, works on it, and then reduces all chunks whose turn it is. A finished chunk keeps
/// its slot until its turn. If all slots wait for one delayed chunk, the other threads wait too.
void share_slots(int threads, int count, int stretch, SlotCall call, SlotCall then, void* both) {
  const int stretches = (count + stretch - 1) / stretch;
  const int workers = std::min({threads, stretches, most_threads});
  Line line(stretches, stretches_under_way(std::min(threads, most_threads)), workers);
  std::atomic<bool> failed = false;
  together(workers, [&](int thread) {
    const Failing failing(failed);
    const auto pass = [&](SlotCall to, int s) {
      to(both, s * stretch, std::min(count, (s + 1) * stretch), thread, s % line.slots);
    };
    Wait wait(thread == 0 ? &crew().losses() : nullptr);  // the caller is thread 0, whose waits are recorded
    for (int s = line.claim(thread); s < stretches && !failed; s = line.claim(thread)) {
      if (s >= 0) {
        pass(call, s);
        line.worked[static_cast<std::size_t>(s % line.slots)] = s + 1;
      }
      line.take_up([&](int turn) { pass(then, turn); });
      s < 0 ? wait.look() : wait.end();
    }
  });
}

}  // namespace trilith
