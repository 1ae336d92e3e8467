#include <doctest/doctest.h>

#include <cmath>

#include "load/ramp.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;
using testing::near_zero;

TEST_CASE("a gentle motion ends at rest at its distance and is even about its middle") {
  for (const double distance : {0.3, -0.3}) {
    CAPTURE(distance);
    const GroundMotion motion = gentle_motion(distance, 0.5, 0);
    const double end = motion.duration();
    CHECK(near(motion.at(end).displacement, distance, 1e-9));
    CHECK(near_zero(motion.at(end).velocity, 1e-9));
    for (const double share : {0.05, 0.1, 0.3, 0.45}) {
      CAPTURE(share);
      const MotionAt first = motion.at(share * end), last = motion.at((1 - share) * end);
      CHECK(near(first.velocity, last.velocity, 1e-6));
      CHECK(near(first.displacement + last.displacement, distance, 1e-6));
    }
    // It runs at this speed between the middles of its two ends, which are 80 % of the time apart.
    CHECK(near(gentle_speed(motion), std::abs(distance) / (0.8 * end), 1e-6));
  }
}
