// Bending capacity of a softening joint in space: about both axes and both ways, of long and square areas, with axial
// load, against the integral of the law over the depth.
#include <doctest/doctest.h>

#include <cmath>

#include "contact/held_joint.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// A law of mode I in units of its strength and of the opening at its peak; `last`: the opening at which it ends.
struct LawShape {
  double last;
  [[nodiscard]] double stress(double opening) const {
    return opening <= 1 ? opening : std::max(0.0, (last - opening) / (last - 1));
  }
};

/// Largest moment(turn) for increasing turns.
template <class F>
double largest(double to, int steps, F&& moment) {
  double most = 0;
  for (int i = 1; i <= steps; ++i) most = std::max(most, moment(i * to / steps));
  return most;
}

constexpr int turns = 160;
/// The turn up to which joints are bent, in openings at the peak over the depth.
double last_turn(const LawShape& law, double axial) {
  return 1.5 * law.last + 8 * std::abs(axial);
}

/// Capacity by strips, over the capacity of an elastic joint that breaks at its edge. `axial`: mean stress over the
/// strength.
double capacity_by_strips(const LawShape& law, double axial) {
  constexpr int strips = 2000;
  const auto sums = [&](double middle, double turn) {
    double force = 0, moment = 0;
    for (int i = 0; i < strips; ++i) {
      const double x = (i + 0.5) / strips - 0.5, stress = law.stress(middle + turn * x) / strips;
      force += stress, moment += stress * x;
    }
    return std::pair(force, moment);
  };
  double from = axial;
  return 6 * largest(last_turn(law, axial), turns, [&](double turn) {
           double low = from - 0.1, high = from + 0.5 * turn + 0.1;
           for (int k = 0; k < 40; ++k) {
             const double middle = 0.5 * (low + high);
             (sums(middle, turn).first < axial ? low : high) = middle;
           }
           from = low;
           return sums(low, turn).second;
         });
}

/// Capacity of a joint with the sides x and y that is bent about `axis` (0: x, 1: y) in the direction `sign`.
double capacity_of_joint(const LawShape& shape, double x, double y, int axis, int sign, double axial) {
  const double kn = 1e10, strength = 3e5, peak = strength / kn, depth = axis == 0 ? y : x, area = x * y;
  HeldJoint joint(soft_mortar(kn, 1e10, 0.7, 1e8, strength, 0.5 * strength * shape.last * peak, 1e5), x, y);
  double lift = axial * peak;
  joint.to(Vec3(0, 0, lift));
  const double most = largest(last_turn(shape, axial) * peak / depth, turns, [&](double turn) {
    Vec3 turned = Vec3::Zero();
    turned[axis] = sign * turn;
    double low = lift - 0.1 * peak, high = lift + 0.5 * depth * turn + 0.1 * peak;
    for (int k = 0; k < 40; ++k) {
      HeldJoint trial = joint;
      const double middle = 0.5 * (low + high);
      (-trial.to(Vec3(0, 0, middle), turned).force.z() < axial * strength * area ? low : high) = middle;
    }
    lift = low;
    joint.to(Vec3(0, 0, lift), turned);
    return std::abs(joint.last.moment[axis]);
  });
  return most / (strength * area * depth / 6);
}

}  // namespace

TEST_CASE("bending capacity of softening mortar about both axes, both ways, long and square, with axial load") {
  for (const double last : {10.0, 50.0})
    for (const double axial : {0.0, -0.5}) {
      const LawShape law{last};
      const double expected = capacity_by_strips(law, axial);
      for (const double aspect : {1.0, 2.0, 5.0})
        for (const int axis : {0, 1})
          for (const int sign : {1, -1}) {
            CAPTURE(last);
            CAPTURE(axial);
            CAPTURE(aspect);
            CAPTURE(axis);
            CAPTURE(sign);
            CHECK(near(capacity_of_joint(law, 0.2 * aspect, 0.2, axis, sign, axial), expected, 7e-3));
          }
    }
}
