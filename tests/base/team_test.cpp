// Loops that threads share: every item once, in order what must be, and errors passed on.
#include "base/team.hpp"

#include <doctest/doctest.h>

#include <array>
#include <atomic>
#include <numeric>
#include <stdexcept>
#include <vector>

using namespace trilith;

TEST_CASE("a shared loop comes to every item once, whatever the number of threads and the stretch") {
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

TEST_CASE("what follows a shared loop in order has the sum of one thread to the bit") {
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

TEST_CASE("what an item of a shared loop throws comes to the one who asked") {
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
