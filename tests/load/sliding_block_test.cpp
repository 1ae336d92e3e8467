// The sliding block of Newmark (Geotechnique 15, 1965) on the motions as read: tests reader, scaling and sign together.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "load/motion.hpp"
#include "load/motion_read.hpp"
#include "load/record_folder.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Slip of a rigid block in one direction while the ground acceleration exceeds its limit or it still slides [m].
/// `yield`: largest acceleration of the block without slip [m/s2].
double one_way_slip(const GroundMotion& motion, double yield) {
  const double h = 1e-4;
  double slip = 0;
  double speed = 0;
  for (double t = h / 2; t < motion.end_time(); t += h) {
    const double next = std::max(0.0, speed + h * (motion.acceleration(t) - yield));
    slip += h * (speed + next) / 2;
    speed = next;
  }
  return slip;
}

}  // namespace

TEST_CASE("S3: one-way slip of a rigid block under Takatori scaled to 0.4 g, both signs") {
  const auto folder = record_folder();
  if (!folder) return;
  const GroundMotion motion =
      read_motion(*folder / "kobe_1995_takatori_090.csv").scaled_to_peak(0.4 * standard_gravity);
  const double slips[] = {
      one_way_slip(motion, 0.1 * standard_gravity), one_way_slip(motion.reversed(), 0.1 * standard_gravity),
      one_way_slip(motion, 0.2 * standard_gravity), one_way_slip(motion.reversed(), 0.2 * standard_gravity)};
  MESSAGE("slips ", slips[0] * 100, " ", slips[1] * 100, " ", slips[2] * 100, " ", slips[3] * 100, " cm");
  CHECK(near(slips[0], 0.72419, 0.015));
  CHECK(near(slips[1], 0.62859, 0.015));
  CHECK(near(slips[2], 0.12860, 0.015));
  CHECK(near(slips[3], 0.06662, 0.015));
}
