// Softening mortar: closed forms of a single joint, energies, mixed-mode paths, and rejected declarations.
#include <doctest/doctest.h>

#include <algorithm>

#include "contact/mortar_joint.hpp"
#include "law/contact/cohesive.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

using Joint = MortarJoint;
constexpr double kn = Joint::kn, ks = Joint::ks, mu = Joint::mu, cohesion = Joint::cohesion, tension = Joint::tension,
                 gi = Joint::gi, gii = Joint::gii;

}  // namespace

TEST_CASE("a softening joint pulled apart peaks at its strength, falls in a line and dissipates its fracture energy") {
  Joint joint;
  double peak = 0, at_peak = 0;
  const double first = tension / kn, last = 2 * gi / tension;
  joint.lead(1.2 * last, 0, 20000, [&] {
    if (joint.normal > peak) peak = joint.normal, at_peak = joint.gap;
    if (joint.gap > first && joint.gap < last)
      CHECK(near_zero(joint.normal - tension * (last - joint.gap) / (last - first), 1e-9 * tension));
  });
  CHECK(near(peak, tension, 1e-3));
  CHECK(near(at_peak, first, 5e-3));
  CHECK(joint.normal == 0.0);
  CHECK_FALSE((joint.memory.bonds[0] || joint.memory.bonds[1]));
  CHECK(near(joint.fracture, gi, 0.005));
  CHECK(near(joint.work, gi, 0.005));
}

TEST_CASE(
    "an open joint unloads to the origin, closes with full stiffness, and on reloading continues on the softening "
    "line") {
  Joint joint;
  const double first = tension / kn, last = 2 * gi / tension, half = 0.5 * (first + last);
  joint.lead(half, 0, 5000);
  const double at_half = joint.normal, lost = joint.fracture;
  CHECK(near(at_half, 0.5 * tension, 1e-6));
  joint.lead(0.5 * half, 0, 100);
  CHECK(near(joint.normal, 0.5 * at_half, 1e-9));
  joint.lead(-1e-4, 0, 100);
  CHECK(near(joint.normal, -kn * 1e-4, 1e-9));
  joint.lead(half, 0, 1000);
  CHECK(near(joint.normal, at_half, 1e-9));
  CHECK(near(joint.fracture, lost, 1e-9));
  joint.lead(1.01 * last, 0, 10000);
  CHECK(near(joint.fracture, gi, 0.005));
}

TEST_CASE(
    "a softening joint sheared under pressure peaks at c + mu sigma and leaves friction, and its cohesion takes G_II") {
  for (const double pressure : {0.0, 5e4, 4e5}) {
    Joint joint;
    const double gap = -pressure / kn, last = 2 * gii / cohesion;
    joint.lead(gap, 0, 100);
    double peak = 0, at_peak = 0;
    joint.lead(gap, 3 * last, 60000, [&] {
      if (joint.shear > peak) peak = joint.shear, at_peak = joint.slip;
    });
    CAPTURE(pressure);
    CHECK(near(peak, cohesion + mu * pressure, 1e-3));
    CHECK(near(at_peak, (cohesion + mu * pressure) / ks, 0.005));
    CHECK(near(joint.shear, mu * pressure, 1e-9));
    CHECK(near(joint.fracture, gii, 0.005));
    const double slid = 3 * last - mu * pressure / ks;
    CHECK((pressure > 0 ? near(joint.friction, mu * pressure * slid, 0.005) : near_zero(joint.friction, 1e-12 * gii)));
    // Reversal: along ks, then sliding the other way by friction.
    const double turned_at = joint.slip;
    joint.lead(gap, turned_at - mu * pressure / ks, 100);
    CHECK(std::abs(joint.shear) < 1e-6 * (mu * pressure + 1));
    joint.lead(gap, turned_at - 3 * mu * pressure / ks, 1000);
    CHECK(near(joint.shear, -mu * pressure, 1e-9));
  }
}

TEST_CASE("half softened in shear, a joint has lost the same share of its tension") {
  Joint joint;
  const double last = 2 * gii / cohesion;
  joint.lead(0, cohesion / ks + 0.4 * last, 20000);
  const double left = joint.shear / cohesion;
  CHECK(left > 0.2);
  CHECK(left < 0.9);
  CHECK(near(joint.damage(), 1 - left, 1e-9));
  joint.lead(0, joint.slip - joint.shear / ks, 100);
  CHECK(std::abs(joint.shear) < 1e-6 * cohesion);
  double peak = 0;
  const double slip = joint.slip;
  joint.lead(2 * gi / tension, slip, 20000, [&] { peak = std::max(peak, joint.normal); });
  CHECK(peak <= left * tension * (1 + 1e-9));
  CHECK(peak > 0.995 * left * tension);
}

TEST_CASE("on mixed and cyclic paths work equals dissipated plus stored energy") {
  struct Stop {
    double gap, slip;
  };
  const double o = 2 * gi / tension, s = 2 * gii / cohesion;
  const std::vector<std::vector<Stop>> paths{{{0.3 * o, 0.3 * s}, {1.1 * o, 2.0 * s}},
                                             {{0.5 * o, 0}, {0.5 * o, 1.5 * s}, {-1e-4, 1.5 * s}, {-1e-4, -s}},
                                             {{-2e-4, 0}, {-2e-4, 0.7 * s}, {0.4 * o, 0.7 * s}, {-1e-4, 0}, {o, 3 * s}},
                                             {{0.1 * o, 0.8 * s}, {0, -0.5 * s}, {0.3 * o, 0.2 * s}, {0, 0}}};
  for (const double angle : {0.0, 0.7, 3.0})
    for (const auto& path : paths) {
      Joint joint;
      joint.turn = Turn(angle);
      double fracture_before = 0, most = 0;
      for (const Stop& stop : path)
        joint.lead(stop.gap, stop.slip, 20000, [&] {
          CHECK(joint.fracture >= fracture_before - 1e-12);
          fracture_before = joint.fracture;
          most = std::max(most, joint.work);
        });
      const double given = joint.fracture + joint.friction + joint.damping;
      CHECK(std::abs(joint.work - given - joint.stored()) < 2e-3 * most);
      CHECK(joint.fracture <= std::max(gi, gii) * 1.005);
    }
}

TEST_CASE("a softening joint does not depend on the direction") {
  Joint plain, turned_joint;
  turned_joint.turn = Turn(2.2);
  for (Joint* j : {&plain, &turned_joint}) j->lead(1e-4, 4e-4, 1000), j->lead(-1e-4, 9e-4, 1000);
  CHECK(near(plain.normal, turned_joint.normal, 1e-8));
  CHECK(near(plain.shear, turned_joint.shear, 1e-8));
  CHECK(near(plain.fracture, turned_joint.fracture, 1e-8));
}

TEST_CASE(
    "held shut, a sliding joint with dilation presses by kn tan(psi) slip up to its limit, for no gain of energy") {
  Joint joint;
  joint.law.dilation = 0.1, joint.law.dilation_slip = 5e-4;
  joint.lead(-1e-5, 0, 100);
  joint.lead(-1e-5, 4e-3, 40000);
  CHECK(near(-joint.normal, kn * (1e-5 + 0.1 * 5e-4), 1e-3));
  CHECK(near(joint.shear, mu * -joint.normal, 1e-3));
  CHECK(joint.friction > 0);
  const double pressed = 0.5 * joint.normal * joint.normal / kn;
  const double shear = 0.5 * joint.shear * joint.shear / ks;
  CHECK(near(joint.work, joint.fracture + joint.friction + pressed + shear, 0.005));
}

TEST_CASE("a fracture energy below the energy stored at the strength is rejected with the least possible value") {
  const Cohesive sound{kn, ks, mu, 0, cohesion, tension, gi, gii, 0, 0};
  CHECK_NOTHROW(sound.check());
  Cohesive weak = sound;
  weak.energy_tension = 4;
  CHECK_THROWS_WITH_AS(weak.check(), doctest::Contains("energy_tension is 4 J/m2, must be above tension^2/(2 kn) = 5"),
                       InputError);
  weak = sound;
  weak.energy_shear = 40;
  CHECK_THROWS_WITH_AS(weak.check(), doctest::Contains("energy_shear is 40 J/m2, must be above cohesion^2/(2 ks) = 50"),
                       InputError);
}
