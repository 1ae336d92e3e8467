// Joints of solids in space with crushing mortar: forces, crushed depth, and dissipation.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "contact/held_joint.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double bed_stiffness = 1e10;  // [Pa/m]

Cohesive crushing_mortar(double compression, double depth = 5e-3, double beta = 0) {
  Cohesive law = soft_mortar(bed_stiffness, 5e9, 0.7, 1e5, 1e5, 50, 50);
  law.compression = compression, law.crushing_depth = depth, law.beta = beta;
  return law;
}

/// Work put in minus stored and dissipated energy [J].
double residual(const HeldJoint& j) {
  return j.put_in + j.stored_at_first - j.stored() - j.fracture - j.friction - j.damping;
}

/// Mean elastic penetration over the full length of a strip with end penetrations c0 and c1, once its mortar is crushed
/// [m]. Its distribution is a trapezoid if the strip is fully closed, otherwise a triangle. The mean over the closed
/// length is `strength`, the penetration at the strength [m].
double crushed_mean(double c0, double c1, double strength) {
  const double high = std::max(c0, c1), low = std::min(c0, c1), slope = high - low;
  const double pressed_whole = 0.5 * (c0 + c1) - strength, pressed_at_end = high - 2 * strength;
  const double z = std::max({0.0, pressed_whole, pressed_at_end});
  const double h = std::max(0.0, high - z), l = low - z;
  return l >= 0 ? 0.5 * (h + l) : 0.5 * h * h / slope;
}

}  // namespace

TEST_CASE("the stress of a joint stays at its strength beyond it, and unloads with its stiffness") {
  const double strength = 2e6, x = 0.6, y = 0.4, elastic = strength / bed_stiffness, area = x * y;
  for (const double beta : {0.0, 1e-4}) {
    HeldJoint joint(crushing_mortar(strength, 5e-3, beta), x, y);
    joint.glide(Vec3(0, 0, -0.99 * elastic), Vec3::Zero(), 50);
    CHECK(joint.fracture == 0);
    CHECK(joint.joint().most_crushed() == 0);
    joint.glide(Vec3(0, 0, -11 * elastic), Vec3::Zero(), 500);
    joint.to(Vec3(0, 0, -11 * elastic));
    CHECK(near(joint.last.force.z(), strength * area, 1e-9));
    CHECK(near(joint.joint().most_crushed(), 10 * elastic, 1e-9));
    // The step in which crushing begins is partly elastic: at most the elastic energy of half a step is booked
    // differently.
    if (beta == 0) CHECK(near(joint.fracture, strength * area * 10 * elastic, 2e-5));
    joint.glide(Vec3(0, 0, -10.5 * elastic), Vec3::Zero(), 50), joint.to(Vec3(0, 0, -10.5 * elastic));
    CHECK(near(joint.last.force.z(), 0.5 * strength * area, 1e-9));
    CHECK(near_zero(residual(joint), 1e-6 * joint.put_in));
  }
}

TEST_CASE("mortar that is crushed over its whole depth keeps its stiffness") {
  const double strength = 1e6, elastic = strength / bed_stiffness, depth = 5 * elastic;
  HeldJoint joint(crushing_mortar(strength, depth));
  joint.glide(Vec3(0, 0, -9 * elastic), Vec3::Zero(), 400);
  CHECK(near(joint.joint().most_crushed(), depth, 1e-12));
  CHECK(near(joint.last.force.z(), 4 * strength, 1e-9));
  CHECK(near_zero(residual(joint), 1e-6 * joint.put_in));
}

TEST_CASE("a joint that is bent and pressed crushes patch by patch, none beyond its strength") {
  const double strength = 1e6, x = 0.8, y = 0.3, elastic = strength / bed_stiffness, slope = 12 * elastic / x;
  Cohesive weak = crushing_mortar(strength);
  weak.cohesion = weak.tension = 1, weak.energy_tension = weak.energy_shear = 1e-6;  // negligible bond
  HeldJoint joint(weak, x, y);
  joint.glide(Vec3(0, 0, 1e-5), Vec3::Zero(), 50);  // torn: the remaining bond carries nothing
  REQUIRE(joint.joint().bonds == 0);
  const double middle = 2 * elastic;
  joint.glide(Vec3(0, 0, -middle), Vec3(0, slope, 0), 2000);
  // The penetration is linear along x; the side of its larger end does not affect the sum.
  double expected = 0;
  for (int i = 0; i < patches_along; ++i) {
    const double from = (i / 4.0 - 0.5) * x, to = ((i + 1) / 4.0 - 0.5) * x;
    expected += bed_stiffness * y * x / 4 * crushed_mean(middle + slope * from, middle + slope * to, elastic);
  }
  CHECK(near(joint.last.force.z(), expected, 1e-6));
  CHECK(near_zero(residual(joint), 1e-5 * joint.put_in));
}

TEST_CASE("a joint bent cyclically while it crushes returns at most the energy put in") {
  for (const double beta : {0.0, 1e-5}) {
    HeldJoint joint(crushing_mortar(1e6, 2e-3, beta), 0.5, 0.4);
    const double d = 1e-4;
    double least = 0;
    for (const Vec3& turn : {Vec3(4 * d, 0, 0), Vec3(-4 * d, 3 * d, 0), Vec3(0, -6 * d, 0), Vec3(0, 0, 2 * d),
                             Vec3(5 * d, 5 * d, 0), Vec3(0, 0, 0)})
      for (const double down : {8 * d, 2 * d}) {
        joint.glide(Vec3(0, 0, -down), turn, 4000);
        least = std::min(least, joint.put_in - joint.stored());
        CHECK(near_zero(residual(joint), 2e-4 * joint.put_in));
      }
    CHECK(joint.fracture > 0);
    CHECK(least >= -1e-9);
  }
}
