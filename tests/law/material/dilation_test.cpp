#include <doctest/doctest.h>

#include <cmath>

#include "law/material/mohr_coulomb.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near_zero;

// With principal plastic strains 1 + sin and -(1 - sin) of the dilation angle, the growth of volume over the largest
// shear strain is this sine (Rowe, 1962).
TEST_CASE("the plastic growth of volume over the plastic shear strain is the sine of the dilation angle") {
  for (const double dilation : {0.0, 0.2, 0.5}) {
    CAPTURE(dilation);
    const MohrCoulomb law{30e9, 0.2, 1e6, 0.6, dilation};
    const PlasticMemory after = law.respond(Plane::strain, PlaneVector(-1e-4, -1e-4, 1e-3), {}).memory;
    const double shear = std::hypot(after.xx - after.yy, after.xy), volume = after.xx + after.yy + after.zz;
    REQUIRE(shear > 1e-4);
    CHECK(near_zero(volume / shear - std::sin(dilation), 1e-9));
  }
}
