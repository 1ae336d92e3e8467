// Automatic number of threads of a step: the fastest one, with invented times.
#include "run/thread_choice.hpp"

#include <doctest/doctest.h>

#include <functional>

#include "near.hpp"

using namespace trilith;

namespace {

/// Steps of a machine on which one step takes `seconds`(threads) [s]; returns the total [s].
double go(ThreadChoice& choice, int steps, const std::function<double(int)>& seconds) {
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double took = seconds(choice.threads());
    choice.took(took), sum += took;
  }
  return sum;
}

}  // namespace

TEST_CASE("a requested number of threads is used whatever its gain") {
  ThreadChoice three = ThreadChoice::always(3);
  CHECK_FALSE(three.is_open());
  go(three, 5000, [](int threads) {
    CHECK(threads == 3);
    return threads;
  });
  CHECK(three.chosen() == 3);
  CHECK(three.gain() == 0);  // not timed
  CHECK_FALSE(ThreadChoice::up_to(1).is_open());
}

TEST_CASE("a second thread is used where it is faster and not otherwise") {
  for (const double gain : {0.5, 0.9, 1.03, 1.1, 1.8}) {
    CAPTURE(gain);
    ThreadChoice choice = ThreadChoice::up_to(2);
    CHECK(choice.threads() == 2);
    CHECK(choice.gain() == 0);  // unknown
    const auto machine = [&](int threads) { return threads == 2 ? 1 / gain : 1; };
    go(choice, 100, machine);
    const bool pays = gain > 1.05;
    CHECK(choice.chosen() == (pays ? 2 : 1));
    CHECK(near(choice.gain(), pays ? gain : 1, 1e-12));
    // A trial costs almost nothing, however slow the other choice is.
    const double best = pays ? 1 / gain : 1;
    CHECK(go(choice, 100000, machine) < 1.005 * 100000 * best);
  }
}

TEST_CASE("the search finds the number of threads beyond which there is no gain") {
  // Of sixteen threads six are the best; in steps of a power of two 4 and 8 are equally good.
  const auto machine = [](int threads) { return 1.0 / threads + 0.02 * threads; };
  ThreadChoice choice = ThreadChoice::up_to(16);
  go(choice, 20000, machine);
  CHECK((choice.chosen() == 4 || choice.chosen() == 8));
  ThreadChoice odd = ThreadChoice::up_to(12);
  go(odd, 20000, [](int threads) { return 1.0 / threads; });
  CHECK(odd.chosen() == 12);
  CHECK(odd.gain() == 0);  // nothing was timed below 8
}

TEST_CASE("threads are released while the machine is busy and used again afterwards") {
  ThreadChoice choice = ThreadChoice::up_to(2);
  const auto quiet = [](int threads) { return threads == 2 ? 0.6 : 1; };
  const auto busy = [](int threads) { return threads == 2 ? 2.0 : 1; };
  go(choice, 50000, quiet);
  CHECK(choice.chosen() == 2);
  go(choice, 20000, busy);
  CHECK(choice.chosen() == 1);
  CHECK(choice.gain() == 1);
  go(choice, 20000, quiet);
  CHECK(choice.chosen() == 2);
}

TEST_CASE("single slow steps do not change the number of threads") {
  ThreadChoice choice = ThreadChoice::up_to(2);
  int step = 0;
  go(choice, 20000, [&](int threads) { return (++step % 7 == 0 ? 50.0 : 1.0) * (threads == 2 ? 0.7 : 1); });
  CHECK(choice.chosen() == 2);
}
