// Laws with the opposite sign of displacement.
#include "law/bearing/mirrored.hpp"

#include <doctest/doctest.h>

#include "geometry/plane/random_convex.hpp"
#include "law/bearing/direction_samples.hpp"
#include "near.hpp"

namespace trilith::testing {
namespace {

/// Along a random path and its mirror image, a law and its mirror have opposite forces and equal energies.
template <class L>
void check_mirror(const L& law) {
  CAPTURE(describe(law));
  std::mt19937_64 bits(3);
  const auto other = mirrored(law);
  DirectionMemory memory, opposite;
  double d = 0, work = 0;
  for (int i = 0; i < 400; ++i) {
    const double step = random_between(bits, -0.02, 0.02), dt = 1e-3;
    d += step;
    const DirectionResponse a = law.respond({d, step / dt, dt, 1e4, step / dt}, memory);
    const DirectionResponse b = other.respond({-d, -step / dt, dt, 1e4, -step / dt}, opposite);
    CHECK(near(b.force(), -a.force(), 1e-12));
    CHECK(near(b.stored, a.stored, 1e-12));
    CHECK(near(b.lost_inner + b.lost_damping, a.lost_inner + a.lost_damping, 1e-12));
    memory = a.memory, opposite = b.memory, work += std::abs(a.force() * step);
  }
  CHECK(work > 0);
}

TEST_CASE("a mirrored bearing law gives the force of the law for the opposite displacement") {
  DirectionLaws::for_each([]<class L>() {
    for (L law : samples<L>(usual_in_bearings)) {
      check_mirror(law);
      if constexpr (requires { law.side; })
        for (const double side : {-1.0, 1.0}) law.side = side, check_mirror(law);
    }
  });
}

TEST_CASE("a table that is not even is mirrored at its middle") {
  const Table law{{-0.05, -0.01, 0, 0.02, 0.06}, {-4e3, -3e3, 0, 1e3, 2e3}, 0};
  const Table other = mirrored(law);
  CHECK(other.displacement == std::vector{-0.06, -0.02, -0.0, 0.01, 0.05});
  CHECK(other.force == std::vector{-2e3, -1e3, -0.0, 3e3, 4e3});
  CHECK_NOTHROW(other.check());
}

}  // namespace
}  // namespace trilith::testing
