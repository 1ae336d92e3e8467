// Smooth hysteresis of Bouc and Wen: closed forms, limits, loops.
#include "bearing/bouc_wen.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double stiffness = 2e6, yield_force = 1e4, yield_reach = yield_force / stiffness;

/// Led along displacements; `work` is that of the mean forces of each step.
struct BoucWenLead {
  BoucWen law;
  DirectionResponse now = {};
  double at = 0, work = 0, lost = 0;

  void to(double d, int steps = 400) {
    const double dt = 1e-3, from = at;
    for (int i = 1; i <= steps; ++i) {
      const double next = from + (d - from) * i / steps;
      const DirectionResponse r = law.respond({next, (next - at) / dt, dt, 0}, now.memory);
      work += 0.5 * (r.force() + now.force()) * (next - at);
      lost += r.lost_inner + r.lost_damping;
      CHECK(r.lost_inner >= -1e-12 * yield_force * yield_reach);
      now = r, at = next;
    }
  }
};

}  // namespace

TEST_CASE("with the exponent 1 the force goes to its yield_force as 1 - exp(-d/Y)") {
  for (const double shape : {0.5, 0.8, 1.0}) {
    BoucWenLead lead{{stiffness, yield_force, 0, 1, shape, 0}};
    for (const double d : {0.3, 1.0, 2.5}) {
      lead.to(d * yield_reach);
      CHECK(near(lead.now.force(), yield_force * (1 - std::exp(-d)), 1e-6));
    }
  }
}

TEST_CASE("with the exponent 2 it goes as the hyperbolic tangent") {
  BoucWenLead lead{{stiffness, yield_force, 0, 2, 0.5, 0}};
  for (const double d : {0.3, 1.0, 2.5}) {
    lead.to(d * yield_reach);
    CHECK(near(lead.now.force(), yield_force * std::tanh(d), 1e-6));
  }
}

TEST_CASE("a high exponent comes near the corner of the bilinear spring, from below") {
  BoucWenLead lead{{stiffness, yield_force, 0.1, 30, 0.5, 0}};
  lead.to(0.8 * yield_reach);
  CHECK(near(lead.now.force(), 0.8 * yield_force, 1e-3));
  lead.to(5 * yield_reach);
  const double bilinear = 0.1 * stiffness * 5 * yield_reach + 0.9 * yield_force;
  CHECK(lead.now.force() <= bilinear * (1 + 1e-12));
  CHECK(near(lead.now.force(), bilinear, 1e-3));
}

TEST_CASE("unloading is as stiff as at first with shape 0.5, twice as stiff from yield with shape 1") {
  for (const auto& [shape, times] : {std::pair(0.5, 1.0), std::pair(0.75, 1.5), std::pair(1.0, 2.0)}) {
    BoucWenLead lead{{stiffness, yield_force, 0, 2, shape, 0}};
    lead.to(10 * yield_reach);
    const double from = lead.now.force();
    lead.to(lead.at - 1e-3 * yield_reach, 4);
    CHECK(near((from - lead.now.force()) / (1e-3 * yield_reach), times * stiffness, 2e-3));
    CHECK(lead.law.tangent() >= times * stiffness * (1 - 1e-12));
  }
}

TEST_CASE("closed loops give off their area, and a coarse step no other force") {
  BoucWenLead fine{{stiffness, yield_force, 0.05, 2, 0.6, 0}}, coarse = fine;
  for (BoucWenLead* lead : {&fine, &coarse})
    for (const double d : {3.0, -3.0, 3.0}) lead->to(d * yield_reach, lead == &fine ? 2000 : 20);
  CHECK(near(coarse.now.force(), fine.now.force(), 1e-4));
  for (const BoucWenLead* lead : {&fine, &coarse}) CHECK(near(lead->work, lead->lost + lead->now.stored, 1e-9));
  CHECK(fine.lost > 0);
  CHECK(fine.lost < 3 * 6 * yield_reach * 1.2 * yield_force);
}
