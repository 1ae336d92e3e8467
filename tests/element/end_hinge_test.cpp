// Plastic hinges at the ends of a beam: elastic limit, backbone, normal force, energies, tangents.
#include "element/beam/end_hinge.hpp"

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <cmath>
#include <random>

#include "element/led_hinges.hpp"
#include "geometry/plane/random_convex.hpp"
#include "near.hpp"

namespace trilith {
namespace {

using testing::hinge_beam;
using testing::LedHinges;
using testing::near;
using testing::near_zero;

constexpr double full_moment = 1e5, full_normal = 4.8e6;

HingeLaw plain_hinge() {
  return HingeLaw::sample();
}
HingeLaw pressed_hinge() {
  HingeLaw law = plain_hinge();
  law.tension = full_normal;
  return law;
}
/// A law with every option.
HingeLaw rich_hinge() {
  HingeLaw law = plain_hinge();
  law.hogging = 0.8 * full_moment, law.hardening = 4e5, law.isotropic = 0.4;
  law.capping = 0.02, law.softening = 0.05, law.residual = 0.2, law.wear = 0.5;
  law.tension = full_normal, law.compression = 1.2 * full_normal;
  return law;
}
HingeLaw tabled_hinge() {
  HingeLaw law = plain_hinge();
  law.force = {-6e6, -2e6, 0, 1e6}, law.share = {0, 1.4, 1, 0};
  return law;
}

/// Moment on an end, positive if the bottom fibres are in tension.
double sagging_of(const BeamStress& s, int end) {
  return end == 0 ? -s[1] : s[2];
}

/// Excess of an end's moment over its law, relative to the sagging moment; at most 0.
double beyond(const HingeLaw& law, const EndHingeMemory& before, const EndHingeMemory& after, int end) {
  const double reach = after.reach[end];
  const double kept = before.gone[end] != 0 ? 0.0 : law.kept(reach) * law.worn(before.dissipated[end]);
  const double c = law.beside(after.normal).share, m = after.moment[end], x = kept * law.back(after.turned[end]);
  return std::max(m - x - kept * law.width(1, reach) * c, x - m - kept * law.width(-1, reach) * c) / law.sagging;
}

BeamStrain random_strain(std::mt19937_64& bits, double size) {
  return {random_between(bits, -0.01, 0.01) * size, random_between(bits, -0.08, 0.08) * size,
          random_between(bits, -0.08, 0.08) * size};
}

}  // namespace

TEST_CASE("below yield a beam with hinges is the elastic beam, pinned or not") {
  std::mt19937_64 bits(1);
  for (const std::array<bool, 2>& pinned : {std::array{false, false}, {true, false}, {false, true}, {true, true}}) {
    const BeamStiffness k = hinge_beam(true, pinned);
    for (int i = 0; i < 20; ++i) {
      LedHinges led{k, {rich_hinge(), pressed_hinge()}};
      const BeamStrain d = random_strain(bits, 0.05);
      led.to(d);
      const BeamStress expected = stress_of(k, d);
      for (int n = 0; n < 3; ++n) CHECK(near_zero(led.now.stress[n] - expected[n], 1e-9 * full_moment));
      CHECK(near(led.now.stored, stored_in(k, d), 1e-12));
      CHECK(led.now.dissipated == 0);
      CHECK_FALSE(led.now.yielding);
      for (const int end : {0, 1}) CHECK(status_of(led.now.memory, end) == HingeStatus::elastic);
    }
  }
}

TEST_CASE("a bent end follows its backbone: yield, hardening, capping, softening, residual, failure") {
  HingeLaw law = plain_hinge();
  law.hardening = 4e5, law.isotropic = 0.3, law.capping = 0.02, law.softening = 0.06, law.residual = 0.25,
  law.ultimate = 0.12;
  CHECK_NOTHROW(law.check());
  const BeamStiffness k = hinge_beam(false, {true, false});
  LedHinges led{k, {law, law}};
  const double top = full_moment + 4e5 * 0.02;
  int lost_at = 0;
  for (int i = 1; i <= 400; ++i) {
    led.to({0, 0, 0.0004 * i});
    const double p = led.now.memory.turned[1], m = led.now.stress[2];
    if (lost_at == 0) CHECK(near(m, k.bend[2] * (0.0004 * i - p), 1e-12));
    if (p == 0 || lost_at > 0) continue;
    const double down = std::max(0.25, 1 - 0.75 * (p - 0.02) / 0.06);
    CHECK(near(m, p <= 0.02 ? full_moment + 4e5 * p : top * down, 1e-10));
    CHECK(status_of(led.now.memory, 0) == HingeStatus::elastic);
    if (status_of(led.now.memory, 1) == HingeStatus::lost) lost_at = i;
    CHECK((p > 0.12) == (lost_at > 0));
  }
  REQUIRE(lost_at > 0);
  CHECK(led.now.stress[2] == 0);
  CHECK(status_of(led.now.memory, 1) == HingeStatus::lost);
  CHECK(near_zero(led.unbooked(), 1e-12 * led.work));
  CHECK(near_zero(led.now.stored, 1e-9));
  // Dissipation: the area under the backbone, up to the ultimate rotation.
  const double area = 0.5 * (full_moment + top) * 0.02 + 0.5 * 1.25 * top * 0.06 + 0.25 * top * 0.04;
  MESSAGE("backbone: given off " << led.lost << " J, area under it " << area);
  CHECK(near(led.lost, area, 0.01));
}

TEST_CASE("both ends under equal bending carry the yield moment, in either direction") {
  for (const double way : {1.0, -1.0})
    for (const double other : {1.0, -1.0}) {
      HingeLaw law = plain_hinge();
      law.hogging = 0.6 * full_moment;
      LedHinges led{hinge_beam(false), {law, law}};
      led.along({0, -0.1 * way, 0.1 * other}, 10);
      CHECK(near(sagging_of(led.now.stress, 0), way > 0 ? full_moment : -0.6 * full_moment, 1e-12));
      CHECK(near(sagging_of(led.now.stress, 1), other > 0 ? full_moment : -0.6 * full_moment, 1e-12));
      CHECK(led.now.settled);
    }
}

TEST_CASE("a loop with kinematic hardening has the area of its parallelogram") {
  HingeLaw law = plain_hinge();
  law.hardening = 5e5;
  const BeamStiffness k = hinge_beam(false, {true, false});
  LedHinges led{k, {law, law}};
  led.along({0, 0, 0.1}), led.along({0, 0, -0.1});
  const double before = led.lost, p = std::abs(led.now.memory.turned[1]);
  led.along({0, 0, 0.1}), led.along({0, 0, -0.1});
  const double area = 4 * full_moment * p;
  MESSAGE("loop " << led.lost - before << " J, closed form " << area);
  CHECK(near(led.lost - before, area, 5e-3));
  CHECK(near(std::abs(led.now.stress[2]), full_moment + 5e5 * p, 1e-12));
}

TEST_CASE("moment and normal force stay on |M|/Mp + (N/Np)^2 = 1, and flow is normal to it") {
  for (const double stretch : {0.001, 0.003, 0.006, 0.009}) {
    LedHinges led{hinge_beam(false), {pressed_hinge(), pressed_hinge()}};
    led.along({stretch, -0.08, 0.08}, 1000);
    const EndHingeMemory& m = led.now.memory;
    const double n = m.normal / full_normal;
    for (const int end : {0, 1}) CHECK(near_zero(m.moment[end] / full_moment + n * n - 1, 1e-11));
    // One more step, proportional: both plastic strains flow by dp_u = 2 n (Mp/Np) dp.
    LedHinges next = led;
    next.to({stretch * 1.01, -0.08 * 1.01, 0.08 * 1.01});
    const double turned = next.now.memory.turned[0] - m.turned[0] + next.now.memory.turned[1] - m.turned[1];
    const double slope = 2 * next.now.memory.normal / full_normal * full_moment / full_normal;
    CHECK(near(next.now.memory.stretch - m.stretch, slope * turned, 1e-8));
  }
}

TEST_CASE("pure tension yields at the tip of the surface, and bending then moves along the surface") {
  for (const HingeLaw& law : {pressed_hinge(), tabled_hinge()}) {
    LedHinges led{hinge_beam(true), {law, law}};
    led.along({0.02, 0, 0}, 20);
    CHECK(near(led.now.stress[0], law.most_normal(), 1e-12));
    CHECK(led.now.settled);
    CHECK(near_zero(led.now.stress[1], 1e-6));
    led.along({0.02, -0.05, 0.05}, 100);
    CHECK(led.now.stress[0] < 0.99 * law.most_normal());
    CHECK(led.now.stress[2] > 0.01 * full_moment);
    led.along({-0.06, -0.05, 0.05}, 100);
    CHECK(led.now.stress[0] < 0);
    CHECK(led.least_loss >= -1e-9 * led.lost);
  }
}

TEST_CASE("the returned stress maximises plastic work among admissible stresses") {
  std::mt19937_64 bits(5);
  for (const HingeLaw& law : {pressed_hinge(), tabled_hinge()})
    for (int round = 0; round < 200; ++round) {
      LedHinges led{hinge_beam(false), {law, law}};
      led.to(random_strain(bits, 1)), led.to(random_strain(bits, 1));
      const EndHingeMemory before = led.now.memory;
      led.to(random_strain(bits, 1));
      const EndHingeMemory& m = led.now.memory;
      const double stretch = m.stretch - before.stretch, first = m.turned[0] - before.turned[0],
                   second = m.turned[1] - before.turned[1];
      const double work = m.normal * stretch + m.moment[0] * first + m.moment[1] * second;
      for (int i = 0; i < 30; ++i) {
        const double n = random_between(bits, law.least_normal(), law.most_normal());
        const double c = law.beside(n).share * full_moment;
        const double other = n * stretch + random_between(bits, -c, c) * first + random_between(bits, -c, c) * second;
        CHECK(work >= other - 1e-9 * std::abs(work));
      }
    }
}

TEST_CASE("strain steps of any size end on admissible finite stresses") {
  std::mt19937_64 bits(6);
  HingeLaw last = rich_hinge();
  last.ultimate = 0.3, last.residual = 0;
  for (const HingeLaw& law : {plain_hinge(), pressed_hinge(), rich_hinge(), tabled_hinge(), last})
    for (int round = 0; round < 60; ++round) {
      LedHinges led{hinge_beam(round % 2 == 0), {law, round % 3 == 0 ? law : rich_hinge()}};
      for (int i = 0; i < 60; ++i) {
        const EndHingeMemory before = led.now.memory;
        const double size = std::pow(10, random_between(bits, -4, i % 10 == 0 ? 1 : -0.5));
        BeamStrain d = random_strain(bits, size);
        for (int k = 0; k < 3; ++k) d[k] += 0.5 * led.at[k];
        led.to(d);
        REQUIRE(std::isfinite(led.now.stress[0] + led.now.stress[1] + led.now.stress[2] + led.now.dissipated));
        REQUIRE(led.now.tangent.allFinite());
        if (law.has_axial()) CHECK(led.now.settled);
        if (!led.now.settled) continue;
        for (const int end : {0, 1}) CHECK(beyond(led.law[end], before, led.now.memory, end) < 1e-8);
        CHECK(led.now.stored >= 0);
      }
    }
}

TEST_CASE("work on a beam with hinges is stored or dissipated, by every kind of step") {
  std::mt19937_64 bits(7);
  for (const HingeLaw& law : {plain_hinge(), pressed_hinge(), rich_hinge(), tabled_hinge()}) {
    LedHinges led{hinge_beam(false), {law, law}};
    double most = 0, least = 0;
    for (int i = 0; i < 60; ++i) {
      led.least_loss = 0, led.along(random_strain(bits, 1), i % 3 == 0 ? 1 : 100), most = std::max(most, led.work);
      if (i % 3 != 0) least = std::min(least, led.least_loss);
    }
    MESSAGE("hinge: missing " << led.unbooked() / most << " of the work, least loss of short steps " << least / most);
    CHECK(near_zero(led.unbooked(), 1e-12 * most));
    CHECK(least >= -1e-12 * most);
  }
  double before = 0;
  for (const int steps : {50, 100, 200}) {
    LedHinges led{hinge_beam(true), {pressed_hinge(), pressed_hinge()}};
    for (const BeamStrain& d : {BeamStrain{5e-3, 0.06, 0.03}, {-5e-3, -0.03, 0.06}, {0, 0, 0}}) led.along(d, steps);
    const double off = std::abs(led.unbooked()) / led.work;
    MESSAGE("with the bow, " << steps << " steps: missing " << off << " of the work");
    CHECK(off < 1e-3);
    if (before > 0) CHECK(off < 0.35 * before);
    before = off;
  }
}

TEST_CASE("a hinge that stretches as it rotates leaves a stronger hinge at the other end elastic") {
  HingeLaw strong = pressed_hinge();
  strong.sagging *= 100, strong.hogging *= 100, strong.tension *= 100;
  for (const int weak : {0, 1}) {
    LedHinges led{hinge_beam(false), {strong, strong}};
    led.law[static_cast<std::size_t>(weak)] = pressed_hinge();
    led.along({3e-3, weak == 0 ? 0.06 : 0, weak == 1 ? 0.06 : 0});
    CHECK(led.now.memory.stretch != 0);
    CHECK(status_of(led.now.memory, weak) == HingeStatus::yielded);
    CHECK(status_of(led.now.memory, 1 - weak) == HingeStatus::elastic);
  }
  LedHinges both{hinge_beam(false), {pressed_hinge(), pressed_hinge()}};  // pure tension: each end takes half
  both.along({0.1, 0, 0});
  for (const int end : {0, 1}) CHECK(status_of(both.now.memory, end) == HingeStatus::yielded);
}

TEST_CASE("the tangent of a beam with hinges matches finite differences on every branch") {
  std::mt19937_64 bits(9);
  for (const HingeLaw& law : {plain_hinge(), pressed_hinge(), rich_hinge(), tabled_hinge()}) {
    int seen = 0, corners = 0;
    for (int round = 0; round < 150; ++round) {
      LedHinges led{hinge_beam(true), {law, law}};
      led.to(random_strain(bits, 0.3)), led.to(random_strain(bits, 1));
      const BeamStrain d = random_strain(bits, 1);
      const EndHingeResponse r = led.probe(d);
      const Eigen::Vector3d scale(1e-8, 1e-7, 1e-7);
      Eigen::Matrix3d k, kinks;
      for (int c = 0; c < 3; ++c) {
        BeamStrain up = d, down = d;
        up[c] += scale[c], down[c] -= scale[c];
        const EndHingeResponse a = led.probe(up), b = led.probe(down);
        for (int row = 0; row < 3; ++row) {
          k(row, c) = (a.stress[row] - b.stress[row]) / (2 * scale[c]);
          kinks(row, c) = (a.stress[row] + b.stress[row] - 2 * r.stress[row]) / scale[c];
        }
      }
      const Eigen::Vector3d size(1, 1 / testing::hinge_span, 1 / testing::hinge_span);
      const auto norm = [&](const Eigen::Matrix3d& m) { return (size.asDiagonal() * m * size.asDiagonal()).norm(); };
      const double whole = hinge_beam(true).axial;
      if (norm(kinks) > 1e-4 * whole) {
        ++corners;
        continue;
      }
      ++seen;
      CHECK(near_zero(norm(k - r.tangent) / whole, 1e-6));
    }
    CHECK(seen > 130);
  }
}

TEST_CASE("degradation reduces strength by the dissipated energy") {
  HingeLaw law = plain_hinge();
  law.wear = 2, law.residual = 0.1;
  LedHinges led{hinge_beam(false, {true, false}), {law, law}};
  for (int i = 0; i < 4; ++i) led.along({0, 0, i % 2 == 0 ? 0.1 : -0.1}, 2000);
  const double left = 1 - 0.9 * led.now.memory.dissipated[1] / (2 * full_moment);
  CHECK(left < 0.8);
  CHECK(near(std::abs(led.now.stress[2]), left * full_moment, 1e-3));
  CHECK(near(led.lost, led.now.memory.dissipated[1], 1e-9));
}

TEST_CASE("invalid hinges are rejected") {
  HingeLaw law = plain_hinge();
  law.capping = 0.02;
  CHECK_THROWS_AS(law.check(), InputError);
  law.softening = 0.01;
  CHECK_NOTHROW(law.check());
  CHECK_THROWS_AS(check_softening(law, 2e6), InputError);
  CHECK_NOTHROW(check_softening(law, 2e7));
  law.ultimate = 0.01;
  CHECK_THROWS_AS(law.check(), InputError);
  for (double HingeLaw::*idle : {&HingeLaw::softening, &HingeLaw::residual}) {
    law = plain_hinge(), law.*idle = 0.1;
    CHECK_THROWS_AS(law.check(), InputError);  // no start of softening
  }
  law = plain_hinge(), law.compression = 1e6;
  CHECK_THROWS_AS(law.check(), InputError);
  law = tabled_hinge(), law.share[1] = 0.1;
  CHECK_THROWS_AS(law.check(), InputError);
}

}  // namespace trilith
