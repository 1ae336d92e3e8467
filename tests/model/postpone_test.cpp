#include "model/postpone.hpp"

#include <doctest/doctest.h>

#include "load/ramp.hpp"

using namespace trilith;

TEST_CASE("a postponed model has the same load curves, motions and tilt, shifted by the delay") {
  constexpr double by = 3, begins = 1, lasts = 2;
  Model<2> model;
  PointLoad<2> load;
  load.curve = ramp_curve(begins, 0, 1, lasts, false);
  model.loads.of<PointLoad<2>>().push_back(load);
  model.drives.push_back({0, 0, 0, begins, std::make_shared<GroundMotion>(ramp_motion(0.1, lasts))});
  model.gravity.tilt_start = begins, model.gravity.tilt_end = begins + lasts;
  Model<2> later = model;
  postpone_courses(later, by);
  for (const double time : {0.0, 1.5, 2.0, 2.75, 3.5}) {
    CAPTURE(time);
    CHECK(later.loads.of<PointLoad<2>>()[0].curve.at(time + by) == load.curve.at(time));
    CHECK(has_courses_to_come(later, time + by) == has_courses_to_come(model, time));
  }
  later.drives.clear();
  CHECK(has_courses_to_come(later, begins + lasts + by - 1e-6));
  CHECK_FALSE(has_courses_to_come(later, begins + lasts + by + 1e-6));
  CHECK(later.gravity.tilt_start == begins + by);
  CHECK(later.gravity.tilt_end == begins + lasts + by);
}
