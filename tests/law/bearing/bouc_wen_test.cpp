// Smooth hysteresis of Bouc and Wen: closed forms, limits, loops.
#include "law/bearing/bouc_wen.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "law/bearing/led.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double stiffness = 2e6, yield_force = 1e4, yield_reach = yield_force / stiffness;

/// A law with prescribed displacements; `work` is the work of the mean forces of each step.
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

TEST_CASE("with the exponent 1 the force approaches its yield_force as 1 - exp(-d/Y)") {
  for (const double shape : {0.5, 0.8, 1.0}) {
    BoucWenLead lead{{stiffness, yield_force, 0, 1, shape, 0}};
    for (const double d : {0.3, 1.0, 2.5}) {
      lead.to(d * yield_reach);
      CHECK(near(lead.now.force(), yield_force * (1 - std::exp(-d)), 1e-6));
    }
  }
}

TEST_CASE("with the exponent 2 it is the hyperbolic tangent") {
  BoucWenLead lead{{stiffness, yield_force, 0, 2, 0.5, 0}};
  for (const double d : {0.3, 1.0, 2.5}) {
    lead.to(d * yield_reach);
    CHECK(near(lead.now.force(), yield_force * std::tanh(d), 1e-6));
  }
}

TEST_CASE("a high exponent approaches the corner of the bilinear spring, from below") {
  BoucWenLead lead{{stiffness, yield_force, 0.1, 30, 0.5, 0}};
  lead.to(0.8 * yield_reach);
  CHECK(near(lead.now.force(), 0.8 * yield_force, 1e-3));
  lead.to(5 * yield_reach);
  const double bilinear = 0.1 * stiffness * 5 * yield_reach + 0.9 * yield_force;
  CHECK(lead.now.force() <= bilinear * (1 + 1e-12));
  CHECK(near(lead.now.force(), bilinear, 1e-3));
}

TEST_CASE("unloading has the initial stiffness with shape 0.5, and twice that from yield with shape 1") {
  for (const auto& [shape, times] : {std::pair(0.5, 1.0), std::pair(0.75, 1.5), std::pair(1.0, 2.0)}) {
    BoucWenLead lead{{stiffness, yield_force, 0, 2, shape, 0}};
    lead.to(10 * yield_reach);
    const double from = lead.now.force();
    lead.to(lead.at - 1e-3 * yield_reach, 4);
    CHECK(near((from - lead.now.force()) / (1e-3 * yield_reach), times * stiffness, 2e-3));
    CHECK(lead.law.tangent() >= times * stiffness * (1 - 1e-12));
  }
}

TEST_CASE("closed loops dissipate their area, and a coarse step gives the same force") {
  BoucWenLead fine{{stiffness, yield_force, 0.05, 2, 0.6, 0}}, coarse = fine;
  for (BoucWenLead* lead : {&fine, &coarse})
    for (const double d : {3.0, -3.0, 3.0}) lead->to(d * yield_reach, lead == &fine ? 2000 : 20);
  CHECK(near(coarse.now.force(), fine.now.force(), 1e-4));
  for (const BoucWenLead* lead : {&fine, &coarse}) CHECK(near(lead->work, lead->lost + lead->now.stored, 1e-9));
  CHECK(fine.lost > 0);
  CHECK(fine.lost < 3 * 6 * yield_reach * 1.2 * yield_force);
}

TEST_CASE("R1: forces and loops of a sine, wide and small, with the exponents 1 and 2") {
  struct Row {
    double exponent, amplitude, first, loop, force, tail;
  };
  for (const Row& row : {Row{1, 0.1, 3060.02, 3150.00, 19000.0, 1}, Row{2, 0.1, 3142.85, 3205.23, 19000.0, 1},
                         Row{1, 0.02, 0, 295.44, 10572.7, 0.952522}}) {
    const BoucWen law{1e6, 1e4, 0.1, row.exponent, 0.5, 0};
    LedLaw<BoucWen> first{law}, steady{law};
    const double at_first = first.sine(row.amplitude, 2, 1, 400), loop = steady.sine(row.amplitude, 2, 10, 400);
    steady.along(row.amplitude, 100);
    MESSAGE("R1 n = " << row.exponent << ", X = " << row.amplitude << " m: first " << at_first << " J, steady " << loop
                      << " J, force " << steady.most_force << " N, z " << steady.now.memory.inner / 0.01);
    if (row.first > 0) CHECK(near(at_first, row.first, 0.002));
    CHECK(near(loop, row.loop, 0.002));
    CHECK(near(steady.most_force, row.force, 0.002));
    CHECK(near(steady.now.memory.inner / 0.01, row.tail, 0.002));
  }
}

TEST_CASE("R2: a slender loop") {
  const BoucWen law{2e7, 1e5, 0.05, 1, 0.9, 0};
  LedLaw<BoucWen> first{law}, steady{law};
  const double at_first = first.sine(0.05, 1, 1, 400), loop = steady.sine(0.05, 1, 5, 400);
  MESSAGE("R2 first " << at_first << " J, steady " << loop << " J, force " << steady.most_force << " N");
  CHECK(near(at_first, 16562.1, 0.003));
  CHECK(near(loop, 17037.0, 0.003));
  CHECK(near(steady.most_force, 145000, 0.003));
}

TEST_CASE("degradation of strength and stiffness follows the dissipated energy") {
  for (const double n : {1.0, 2.0, 5.0})
    for (const double shape : {0.5, 0.8, 1.0}) {
      LedLaw<BoucWen> led{{stiffness, yield_force, 0.1, n, shape, 0, 0.02, 0.05}};
      for (int i = 0; i < 10; ++i) led.along(4 * yield_reach, 2000), led.along(-4 * yield_reach, 2000);
      led.along(-20 * yield_reach, 2000);
      const double e = led.lost / (yield_force * yield_reach), nu = 1 + 0.02 * e, eta = 1 + 0.05 * e;
      CHECK(e > 20);
      // On its falling strength: z lags behind by a share of the fall over one reach.
      const double z = (led.now.force() - 0.1 * stiffness * led.at) / (0.9 * yield_force);
      CHECK(near(-z, std::pow(nu, -1 / n), 0.03));
      CHECK(-z >= std::pow(nu, -1 / n) * (1 - 1e-9));
      // From rest at z = 0 it continues with the initial stiffness over eta.
      LedLaw<BoucWen> worn{led.law};
      worn.now.memory.compression = led.now.memory.compression;
      worn.along(1e-5 * yield_reach, 4);
      CHECK(near(worn.now.force() / worn.at, stiffness * (0.1 + 0.9 / eta), 1e-4));
    }
}

TEST_CASE("a degrading law closes its energy balance to rounding and dissipates at every step, also coarse ones") {
  for (const double shape : {0.5, 0.8, 1.0}) {
    LedLaw<BoucWen> fine{{stiffness, yield_force, 0.05, 2, shape, 0, 0.03, 0.06}}, coarse = fine;
    for (int i = 0; i < 8; ++i) {
      const double d = (i % 2 == 0 ? 3 : -2) * yield_reach;
      fine.along(d, 4000), coarse.along(d, 200);
      CHECK(near(coarse.now.force(), fine.now.force(), 0.01));
    }
    for (const auto* led : {&fine, &coarse}) {
      CHECK(near_zero(led->unbooked(), 1e-12 * led->work));
      CHECK(led->least_loss >= -1e-9 * led->lost);  // a step across z = 0 has an error of third order
    }
  }
}

TEST_CASE("a degrading law follows its equations of z and of the dissipated energy") {
  const double a = 0.1, loss = 0.03, softening = 0.06, reach = 4;  // displacements in units of Y, energies in units of
                                                                   // yield Y
  for (const double n : {1.0, 3.0})
    for (const double b : {0.5, 0.8}) {
      LedLaw<BoucWen> led{{stiffness, yield_force, a, n, b, 0, loss, softening}};
      double z = 0, e = 0, u = 0;
      const auto slopes = [&](double at, double given, double sign) {
        const double eta = 1 + softening * given, bend = (1 + loss * given) * std::pow(std::abs(at), n);
        const double dz = (1 - bend * (b * (at * sign < 0 ? -1 : 1) + 1 - b)) / eta;
        return std::pair(dz, (1 - a) * at * (1 - eta * dz) / (1 + 0.5 * (1 - a) * softening * at * at));
      };
      for (int i = 1; i <= 6000; ++i) {
        const double next = reach * std::sin(2 * M_PI * i / 1000.0), sign = next < u ? -1 : 1;
        const int parts = 10;
        for (int k = 0; k < parts; ++k) {  // midpoint rule
          const double h = (next - u) / parts;
          const auto [dz, de] = slopes(z, e, sign);
          const auto [mz, me] = slopes(z + 0.5 * h * dz, e + 0.5 * h * de, sign);
          z += h * mz, e += h * me;
        }
        u = next;
        led.to(u * yield_reach);
        CHECK(near_zero(led.now.memory.inner / yield_reach - z, 1e-3));
      }
      CHECK(near(led.lost / (yield_force * yield_reach), e, 1e-3));
      CHECK(e > 30);
    }
}

TEST_CASE("the tangent of a degrading law bounds its force through any degradation") {
  for (const double n : {1.0, 2.0, 6.0})
    for (const double shape : {0.5, 0.8, 1.0})
      for (const double loss : {0.02, 0.3, 2.0}) {
        LedLaw<BoucWen> led{{stiffness, yield_force, 0.1, n, shape, 0, loss, 0.5 * loss}};
        for (int i = 0; i < 1200; ++i) {
          const double before = led.now.force(), from = led.at;
          led.to(5 * yield_reach * (0.3 + 0.7 * i / 1200) * std::sin(2 * M_PI * i / 150.0));
          CHECK(std::abs(led.now.force() - before) <= led.law.tangent() * std::abs(led.at - from) * (1 + 1e-9) + 1e-9);
        }
      }
}

TEST_CASE("a law without degradation stores no energy history") {
  LedLaw<BoucWen> led{{stiffness, yield_force, 0.05, 2, 0.6, 0}};
  led.along(4 * yield_reach);
  CHECK(led.lost > 0);
  CHECK(led.now.memory.compression == 0);
}
