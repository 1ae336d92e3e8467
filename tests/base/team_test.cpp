// Loops shared by threads: every item once, ordered parts in order, errors passed on.
#include "base/team.hpp"

#include <doctest/doctest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace trilith;

TEST_CASE("a parallel loop visits every item once, for any number of threads and any chunk size") {
  for (const int threads : {1, 2, 3, 8})
    for (const int stretch : {1, 7, 64})
      for (const int count : {0, 1, 7, 1000}) {
        std::vector<int> seen(static_cast<std::size_t>(count));
        std::atomic<bool> good = true;
        share(threads, count, stretch, [&](int first, int last, int thread) {
          if (thread < 0 || thread >= threads || first >= last) good = false;
          for (int i = first; i < last; ++i) ++seen[static_cast<std::size_t>(i)];
        });
        CHECK(good);
        for (const int n : seen) CHECK(n == 1);
      }
}

TEST_CASE("an ordered reduction after a parallel loop has the sum of one thread to the bit") {
  constexpr int count = 5000;
  const auto term = [](int i) { return 1.0 / (1 + i * i % 97); };
  double expected = 0;
  for (int i = 0; i < count; ++i) expected += term(i);
  for (const int threads : {1, 2, 4})
    for (const int stretch : {1, 16, 333}) {
      std::vector<double> room(static_cast<std::size_t>(stretches_under_way(threads) * stretch));
      double sum = 0;
      int next = 0;
      share_in_order(
          threads, count, stretch,
          [&](int first, int last, int /*thread*/, int slot) {
            for (int i = first; i < last; ++i) room[static_cast<std::size_t>(slot * stretch + i - first)] = term(i);
          },
          [&](int first, int last, int slot) {
            CHECK(first == next);
            next = last;
            for (int i = first; i < last; ++i) sum += room[static_cast<std::size_t>(slot * stretch + i - first)];
          });
      CHECK(next == count);
      CHECK(sum == expected);
    }
}

TEST_CASE("an exception in a parallel loop reaches the caller") {
  for (const int threads : {1, 3}) {
    CHECK_THROWS_AS(share(threads, 100, 1,
                          [](int first, int, int) {
                            if (first == 42 || first == 0) throw std::runtime_error("item");
                          }),
                    std::runtime_error);
    int after = 0;
    share(threads, 10, 10, [&](int, int, int) { ++after; });
    CHECK(after == 1);
  }
}

TEST_CASE("an object requested by several threads is created once for all") {
  constexpr int things = 97, asked = 20000;
  for (const int threads : {1, 2, 4}) {
    std::vector<std::uint8_t> made(things, 0);
    std::vector<int> thing(things, 0);
    std::atomic<int> missing = 0;
    share(threads, asked, 3, [&](int first, int last, int /*thread*/) {
      for (int i = first; i < last; ++i) {
        const auto k = static_cast<std::size_t>(i * 31 % things);
        make_once(threads, made[k], [&] { ++thing[k]; });
        if (thing[k] != 1) ++missing;
      }
    });
    CHECK(missing == 0);
    CHECK(std::accumulate(thing.begin(), thing.end(), 0) == things);
  }
}

TEST_CASE("an object whose creation failed is created at the next request") {
  for (const int threads : {1, 2}) {
    std::uint8_t made = 0;
    int thing = 0;
    CHECK_THROWS_AS(make_once(threads, made, [] { throw std::runtime_error("item"); }), std::runtime_error);
    make_once(threads, made, [&] { ++thing; });
    make_once(threads, made, [&] { ++thing; });
    CHECK(thing == 1);
  }
}

TEST_CASE("a thread that waits long for another works alone for a while") {
  using Clock = std::chrono::steady_clock;
  using std::chrono::milliseconds;
  const std::thread::id asking = std::this_thread::get_id();
  // A loop in which the other thread, if it takes part, is delayed as on a busy machine; true if it took part.
  const auto company_came = [&](milliseconds held_up) {
    std::atomic<bool> came = false;
    share(2, 64, 1, [&](int, int, int) {
      if (std::this_thread::get_id() != asking && !came.exchange(true)) std::this_thread::sleep_for(held_up);
      const Clock::time_point end = Clock::now() + std::chrono::microseconds(20);
      while (Clock::now() < end) {
      }
    });
    return came.load();
  };
  const Clock::time_point begin = Clock::now();
  const auto wait_for_company = [&](milliseconds held_up) {
    while (Clock::now() - begin < std::chrono::seconds(60))
      if (company_came(held_up)) return true;
    return false;
  };
  REQUIRE(wait_for_company(milliseconds(50)));
  const Clock::time_point alone = Clock::now();
  while (Clock::now() - alone < milliseconds(10)) CHECK(!company_came(milliseconds(0)));
  CHECK(wait_for_company(milliseconds(0)));
}
