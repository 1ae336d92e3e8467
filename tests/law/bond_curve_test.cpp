#include "law/contact/bond_curve.hpp"

#include <doctest/doctest.h>

#include "law/contact/cohesive.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;

namespace {

const Cohesive mortar{1e10, 4e9, 0.6, 0, 3e5, 1e5, 12, 90};

}  // namespace

TEST_CASE("the work along a bond curve is the integral of its traction") {
  const BondCurve curve{1e-4, 5e-4, 2e5, 3e4, 1e-3, 0};
  constexpr int steps = 100;
  for (const double end : {0.4e-4, 1e-4, 3e-4, 5e-4, 8e-4}) {
    CAPTURE(end);
    // The mean of the ends is exact on each line; the corners at 1e-4 and 5e-4 are ends of steps.
    double sum = 0;
    const double step = end / steps;
    for (int i = 0; i < steps; ++i) sum += 0.5 * step * (curve.traction(i * step) + curve.traction((i + 1) * step));
    CHECK(near(curve.work(end), sum, 1e-3));
  }
}

TEST_CASE("a softening bond without friction spends its fracture energies in tension and in shear") {
  const double thickness = 0.3;
  const Cohesive::Kernel kernel(mortar, thickness, 1e-4);
  const BondCurve opening = tension_curve(kernel, 1), sliding = shear_curve(kernel, 1, 0, 0);
  CHECK(near(opening.work(opening.last), mortar.energy_tension * thickness, 1e-12));
  CHECK(near(opening.energy, mortar.energy_tension * thickness, 1e-12));
  CHECK(near(sliding.work(sliding.last), mortar.energy_shear * thickness, 1e-12));
  CHECK(near(sliding.energy, mortar.energy_shear * thickness, 1e-12));
}
