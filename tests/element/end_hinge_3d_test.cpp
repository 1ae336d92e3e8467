// Plastic hinges at the ends of a beam in space: agreement with the plane about one axis, the yield surface of both
// moments and N, flow, energies, tangents, steps of any size.
#include "element/beam/end_hinge_3d.hpp"

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
using testing::near;
using testing::near_zero;

constexpr double about_z = 1e5, about_y = 6e4, full_pull = 4.8e6;

HingeLaw plain_hinge_3d(double contour = 2) {
  HingeLaw law = HingeLaw::sample();
  law.sagging = about_z, law.across = about_y, law.contour = contour;
  return law;
}
HingeLaw pressed_hinge_3d(double contour = 1.7) {
  HingeLaw law = plain_hinge_3d(contour);
  law.tension = full_pull;
  return law;
}
/// A law with every option.
HingeLaw rich_hinge_3d(double contour = 1.5) {
  HingeLaw law = plain_hinge_3d(contour);
  law.hogging = 0.8 * about_z, law.hardening = 4e5, law.isotropic = 0.4;
  law.capping = 0.02, law.softening = 0.05, law.residual = 0.2, law.wear = 0.5;
  law.tension = full_pull, law.compression = 1.2 * full_pull;
  return law;
}
HingeLaw tabled_hinge_3d() {
  HingeLaw law = plain_hinge_3d(1.2);
  law.force = {-6e6, -2e6, 0, 1e6}, law.share = {0, 1.4, 1, 0};
  return law;
}

/// Steel of 0.1 m x 0.2 m; the stiffness about y is `weaker` times the stiffness about z.
BeamStiffness3 space_beam(bool bowed, double weaker = 0.8) {
  BeamStiffness3 k;
  k.bend = {hinge_beam(bowed), hinge_beam(bowed)};
  k.axial = k.bend[1].axial, k.torsion = 2e5;
  for (double& v : k.bend[0].bend) v *= weaker;
  return k;
}

struct LedHinges3 {
  BeamStiffness3 stiffness;
  std::array<HingeLaw, 2> law;
  EndHingeResponse3 now = {};
  BeamStrain3 at = {};
  double work = 0, lost = 0, least_loss = 0;

  [[nodiscard]] EndHingeResponse3 probe(const BeamStrain3& d) const {
    return respond(stiffness, {&law[0], &law[1]}, d, now.memory);
  }
  void to(const BeamStrain3& d) {
    const EndHingeResponse3 r = probe(d);
    for (std::size_t k = 0; k < 6; ++k) work += 0.5 * (r.stress[k] + now.stress[k]) * (d[k] - at[k]);
    lost += r.dissipated, least_loss = std::min(least_loss, r.dissipated);
    at = d, now = r;
  }
  void along(const BeamStrain3& d, int steps = 200) {
    const BeamStrain3 from = at;
    for (int i = 1; i <= steps; ++i) {
      BeamStrain3 next;
      for (std::size_t k = 0; k < 6; ++k) next[k] = from[k] + (d[k] - from[k]) * i / steps;
      to(next);
    }
  }
  [[nodiscard]] double unbooked() const { return work - now.stored - lost; }
};

BeamStrain3 random_strain_3d(std::mt19937_64& bits, double size) {
  BeamStrain3 d;
  d[0] = random_between(bits, -0.01, 0.01) * size, d[5] = random_between(bits, -0.02, 0.02) * size;
  for (const std::size_t k : {1, 2, 3, 4}) d[k] = random_between(bits, -0.08, 0.08) * size;
  return d;
}

/// A strain of the plane as one about z, or rotated about the beam's axis by `angle`.
BeamStrain3 turned_strain(const BeamStrain& d, double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  return {d[0], s * d[1], c * d[1], s * d[2], c * d[2], 0};
}

}  // namespace

TEST_CASE("below yield a beam in space with hinges is the elastic beam") {
  std::mt19937_64 bits(1);
  const BeamStiffness3 k = space_beam(true);
  for (int i = 0; i < 20; ++i) {
    LedHinges3 led{k, {rich_hinge_3d(), pressed_hinge_3d()}};
    const BeamStrain3 d = random_strain_3d(bits, 0.03);
    led.to(d);
    const BeamStress3 expected = stress_of(k, d);
    for (std::size_t n = 0; n < 6; ++n) CHECK(near_zero(led.now.stress[n] - expected[n], 1e-9 * about_z));
    CHECK(near(led.now.stored, stored_in(k, d), 1e-12));
    CHECK(led.now.dissipated == 0);
    for (const int end : {0, 1}) CHECK(status_of(led.now.memory, end) == HingeStatus::elastic);
  }
}

TEST_CASE("bent about z alone, a hinge in space is the plane's, whatever its law") {
  std::mt19937_64 bits(2);
  HingeLaw losing = rich_hinge_3d();
  losing.residual = 0, losing.ultimate = 0.06, losing.wear = 0;
  for (const HingeLaw& law : {plain_hinge_3d(), pressed_hinge_3d(), rich_hinge_3d(), tabled_hinge_3d(), losing})
    for (int round = 0; round < 10; ++round) {
      testing::LedHinges flat{hinge_beam(true), {law, law}};
      LedHinges3 deep{space_beam(true), {law, law}};
      for (int i = 0; i < 12; ++i) {
        const BeamStrain d{random_between(bits, -0.01, 0.01), random_between(bits, -0.08, 0.08),
                           random_between(bits, -0.08, 0.08)};
        flat.along(d, 20), deep.along(turned_strain(d, 0), 20);
        if (!flat.now.settled) break;
        REQUIRE(deep.now.settled);
        const double size = 1e-8 * (about_z + std::abs(flat.now.stress[1]));
        CHECK(near_zero(deep.now.stress[0] - flat.now.stress[0], 1e-8 * full_pull));
        CHECK(near_zero(deep.now.stress[2] - flat.now.stress[1], size));
        CHECK(near_zero(deep.now.stress[4] - flat.now.stress[2], size));
        CHECK(near_zero(deep.now.stress[1], size));
        CHECK(near_zero(deep.lost - flat.lost, 1e-8 * flat.lost + 1e-9));
        for (const int end : {0, 1}) CHECK(status_of(deep.now.memory, end) == status_of(flat.now.memory, end));
      }
    }
}

TEST_CASE("a round hinge bent in any plane equals the hinge of the plane") {
  std::mt19937_64 bits(3);
  HingeLaw law = rich_hinge_3d(2);
  law.hogging = 0, law.across = law.sagging;
  for (int round = 0; round < 20; ++round) {
    const double angle = random_between(bits, -3, 3);
    testing::LedHinges flat{hinge_beam(true), {law, law}};
    LedHinges3 deep{space_beam(true, 1), {law, law}};
    for (int i = 0; i < 8; ++i) {
      const BeamStrain d{random_between(bits, -0.01, 0.01), random_between(bits, -0.08, 0.08),
                         random_between(bits, -0.08, 0.08)};
      flat.along(d, 20), deep.along(turned_strain(d, angle), 20);
      const BeamStress3 expected = turned_strain(flat.now.stress, angle);
      CHECK(near_zero(deep.now.stress[0] - expected[0], 1e-9 * full_pull));
      for (const std::size_t k : {1, 2, 3, 4}) CHECK(near_zero(deep.now.stress[k] - expected[k], 1e-9 * about_z));
      CHECK(near(deep.lost, flat.lost, 1e-9));
    }
  }
}

TEST_CASE("about y a hinge is the plane's with all strengths across over sagging times as large") {
  HingeLaw law = rich_hinge_3d(), other = law;
  law.hogging = 0;
  const double s = law.across / law.sagging;
  // Rotations about y are scaled by sqrt(s): capping, softening and wear use this measure.
  other = law, other.sagging *= s, other.hardening *= s;
  other.capping /= std::sqrt(s), other.softening /= std::sqrt(s), other.wear /= s;
  other.isotropic = law.isotropic;
  // Hi r grows with sqrt(s) of the rotation about y, its width with s Hi: only kinematic hardening compares exactly.
  law.isotropic = other.isotropic = 0;
  testing::LedHinges flat{hinge_beam(true), {other, other}};
  LedHinges3 deep{space_beam(true, 1), {law, law}};
  for (const BeamStrain& d : {BeamStrain{2e-3, -0.06, 0.05}, {-1e-3, 0.05, -0.02}, {1e-3, 0.02, 0.08}}) {
    flat.along(d), deep.along(turned_strain(d, M_PI / 2));
    for (const std::size_t k : {1, 2})
      CHECK(near_zero(deep.now.stress[2 * k - 1] - flat.now.stress[k], 1e-8 * about_z));
    CHECK(near(deep.lost, flat.lost, 1e-8));
  }
}

TEST_CASE("moments about both axes and N reach the surface together, and stay on it") {
  for (const double contour : {1.15, 1.5, 1.7, 2.0})
    for (const double stretch : {0.0, 0.001, 0.004})
      for (const double angle : {0.1, 0.6, 1.1, 1.5}) {
        const HingeLaw law = pressed_hinge_3d(contour);
        LedHinges3 led{space_beam(false), {law, law}};
        const BeamStrain3 d = turned_strain({stretch, -0.6, 0.6}, angle);
        led.along(d, 400);
        const EndHingeMemory3& m = led.now.memory;
        const double n = m.normal / full_pull;
        for (const std::size_t end : {0, 1}) {
          const double y = std::abs(m.moment[end][0]) / about_y, z = std::abs(m.moment[end][1]) / about_z;
          CHECK(near(std::pow(y, contour) + std::pow(z, contour), std::pow(1 - n * n, contour), 1e-10));
        }
        CHECK(led.now.settled);
        // Far beyond yield the flow is along the rotation, so the moments are at the point whose surface normal is
        // along it: m_i = W_i u_i^(b - 1) with u_i = W_i n_i / h.
        const double b = contour / (contour - 1), sy = about_y * std::sin(angle), sz = about_z * std::cos(angle);
        const double h = std::pow(std::pow(sy, b) + std::pow(sz, b), 1 / b);
        const double expected = (1 - n * n) * about_z * std::pow(sz / h, b - 1);
        CHECK(near_zero(std::abs(m.moment[1][1]) - expected, 0.02 * about_z));
      }
}

TEST_CASE("the contour of 1.7 approximates the full plastic rectangle") {
  // A neutral axis through two opposite sides of a rectangle: m_y + 3/4 m_z^2 = 1 for m_z up to 2/3, over the plastic
  // moments; both branches meet at 2/3 each.
  for (const double z : {0.2, 0.4, 0.6, 2.0 / 3}) {
    const double y = 1 - 0.75 * z * z;
    const double size = std::pow(std::pow(y, 1.7) + std::pow(z, 1.7), 1 / 1.7);
    CHECK(near(size, 1, 0.021));
  }
}

TEST_CASE("in space pure tension yields at the tip of the surface, and bending then moves along the surface") {
  for (const HingeLaw& law : {pressed_hinge_3d(), tabled_hinge_3d()}) {
    LedHinges3 led{space_beam(true), {law, law}};
    led.along({0.02, 0, 0, 0, 0, 0}, 20);
    CHECK(near(led.now.stress[0], law.most_normal(), 1e-12));
    CHECK(led.now.settled);
    led.along({0.02, 0.04, -0.05, -0.03, 0.05, 0}, 100);
    CHECK(led.now.stress[0] < 0.99 * law.most_normal());
    led.along({-0.06, 0.04, -0.05, -0.03, 0.05, 0}, 100);
    CHECK(led.now.stress[0] < 0);
    CHECK(led.least_loss >= -1e-9 * led.lost);
  }
}

TEST_CASE("in space the returned stress maximises plastic work among admissible stresses") {
  std::mt19937_64 bits(5);
  for (const HingeLaw& law : {plain_hinge_3d(1.3), pressed_hinge_3d(), tabled_hinge_3d()})
    for (int round = 0; round < 100; ++round) {
      LedHinges3 led{space_beam(false), {law, law}};
      led.to(random_strain_3d(bits, 1)), led.to(random_strain_3d(bits, 1));
      const EndHingeMemory3 before = led.now.memory;
      led.to(random_strain_3d(bits, 1));
      REQUIRE(led.now.settled);
      const EndHingeMemory3& m = led.now.memory;
      const auto work_of = [&](double n, const std::array<std::array<double, 2>, 2>& moment) {
        double sum = n * (m.stretch - before.stretch);
        for (const std::size_t end : {0, 1})
          for (const std::size_t axis : {0, 1})
            sum += moment[end][axis] * (m.turned[end][axis] - before.turned[end][axis]);
        return sum;
      };
      const double work = work_of(m.normal, m.moment);
      for (int i = 0; i < 30; ++i) {
        const double n = law.has_axial() ? random_between(bits, law.least_normal(), law.most_normal()) : m.normal;
        std::array<std::array<double, 2>, 2> other;
        for (auto& moment : other) {
          const double angle = random_between(bits, -3.2, 3.2), y = std::cos(angle), z = std::sin(angle);
          const double size =
              std::pow(std::pow(std::abs(y), law.contour) + std::pow(std::abs(z), law.contour), 1 / law.contour);
          const double c = law.beside(n).share / size;
          moment = {c * y * about_y, c * z * about_z};
        }
        CHECK(work >= work_of(n, other) - 1e-9 * std::abs(work));
      }
    }
}

TEST_CASE("strain steps of any size in space end on admissible finite stresses") {
  std::mt19937_64 bits(6);
  HingeLaw last = rich_hinge_3d();
  last.ultimate = 0.3, last.residual = 0;
  int steps = 0, unsettled = 0;
  for (const HingeLaw& law : {plain_hinge_3d(), plain_hinge_3d(1.1), pressed_hinge_3d(), rich_hinge_3d(),
                              rich_hinge_3d(2), tabled_hinge_3d(), last})
    for (int round = 0; round < 40; ++round) {
      LedHinges3 led{space_beam(round % 2 == 0), {law, round % 3 == 0 ? law : rich_hinge_3d()}};
      for (int i = 0; i < 60; ++i) {
        const EndHingeMemory3 before = led.now.memory;
        const double size = std::pow(10, random_between(bits, -4, i % 10 == 0 ? 1 : -0.5));
        BeamStrain3 d = random_strain_3d(bits, size);
        for (std::size_t k = 0; k < 6; ++k) d[k] += 0.5 * led.at[k];
        led.to(d);
        for (const double s : led.now.stress) REQUIRE(std::isfinite(s));
        REQUIRE(std::isfinite(led.now.dissipated));
        REQUIRE(led.now.tangent.allFinite());
        // Without an N part of the surface nothing prevents compression beyond the beam's buckling load.
        const bool bounded = led.law[0].has_axial() && led.law[1].has_axial();
        steps += bounded ? 1 : 0, unsettled += bounded && !led.now.settled ? 1 : 0;
        if (!led.now.settled) continue;
        for (const int end : {0, 1}) {
          const auto e = static_cast<std::size_t>(end);
          if (before.gone[e] != 0) {
            CHECK(near_zero(std::hypot(led.now.memory.moment[e][0], led.now.memory.moment[e][1]), 1e-6 * about_z));
            continue;
          }
          const double share = led.law[e].beside(led.now.memory.normal).share;
          const double worn = led.law[e].worn(before.dissipated[e]),
                       kept = worn * led.law[e].kept(led.now.memory.reach[e]);
          // Excess over the full strength.
          if (share > 1e-6) CHECK((gauge_of(led.law[e], led.now.memory, end, worn) - 1) * share * kept < 1e-8);
        }
        CHECK(led.now.stored >= 0);
      }
    }
  MESSAGE("steps of any size: ", unsettled, " of ", steps, " did not settle");
  CHECK(unsettled == 0);
}

TEST_CASE("work on a beam in space with hinges is stored or dissipated, by every kind of step") {
  std::mt19937_64 bits(7);
  for (const HingeLaw& law : {plain_hinge_3d(1.4), pressed_hinge_3d(), rich_hinge_3d(), tabled_hinge_3d()}) {
    LedHinges3 led{space_beam(false), {law, law}};
    double most = 0, least = 0;
    for (int i = 0; i < 60; ++i) {
      led.least_loss = 0, led.along(random_strain_3d(bits, 1), i % 3 == 0 ? 1 : 100), most = std::max(most, led.work);
      if (i % 3 != 0) least = std::min(least, led.least_loss);
    }
    MESSAGE("hinge in space: missing ", led.unbooked() / most, " of the work, least loss of short steps ",
            least / most);
    CHECK(near_zero(led.unbooked(), 1e-11 * most));
    CHECK(least >= -1e-12 * most);
  }
}

TEST_CASE("a circular path of rotations beyond yield dissipates the work along the yield surface") {
  // Equal strength about both axes, without hardening: on the surface the moment follows the rotation's direction, and
  // the work of a round is the circumference of the plastic rotation times the moment.
  HingeLaw law = plain_hinge_3d(2);
  law.across = law.sagging;
  BeamStiffness3 k = space_beam(false, 1);
  LedHinges3 led{k, {HingeLaw::never(), law}};
  const double radius = 0.1;
  led.along({0, 0, 0, radius, 0, 0}, 1000);
  const auto round = [&](int steps) {
    for (int i = 1; i <= steps; ++i) {
      const double a = 2 * M_PI * i / steps;
      led.to({0, 0, 0, radius * std::cos(a), radius * std::sin(a), 0});
    }
  };
  round(4000);
  const double before = led.lost;
  round(4000);
  // The elastic part is M/K; the plastic rotation lags behind at a right angle: its radius is sqrt(r^2 - (M/K)^2).
  const double elastic = about_z / k.bend[0].bend[2], inner = std::sqrt(radius * radius - elastic * elastic);
  MESSAGE("a round: ", led.lost - before, " J, closed form ", 2 * M_PI * inner * about_z);
  CHECK(near(led.lost - before, 2 * M_PI * inner * about_z, 1e-4));
}

TEST_CASE("the tangent of a beam in space with hinges matches finite differences on every branch") {
  std::mt19937_64 bits(9);
  for (const HingeLaw& law :
       {plain_hinge_3d(), pressed_hinge_3d(), rich_hinge_3d(), rich_hinge_3d(2), tabled_hinge_3d()}) {
    int seen = 0, corners = 0;
    for (int round = 0; round < 100; ++round) {
      LedHinges3 led{space_beam(true), {law, law}};
      led.to(random_strain_3d(bits, 0.3)), led.to(random_strain_3d(bits, 1));
      const BeamStrain3 d = random_strain_3d(bits, 1);
      const EndHingeResponse3 r = led.probe(d);
      using Matrix6 = Eigen::Matrix<double, 6, 6>;
      Matrix6 k, kinks;
      Eigen::Matrix<double, 6, 1> size = Eigen::Matrix<double, 6, 1>::Constant(1 / testing::hinge_span);
      size[0] = 1;
      for (std::size_t c = 0; c < 6; ++c) {
        const double by = c == 0 ? 1e-8 : 1e-7;
        BeamStrain3 up = d, down = d;
        up[c] += by, down[c] -= by;
        const EndHingeResponse3 a = led.probe(up), b = led.probe(down);
        for (std::size_t row = 0; row < 6; ++row) {
          const auto i = static_cast<Eigen::Index>(row), j = static_cast<Eigen::Index>(c);
          k(i, j) = (a.stress[row] - b.stress[row]) / (2 * by);
          kinks(i, j) = (a.stress[row] + b.stress[row] - 2 * r.stress[row]) / by;
        }
      }
      const auto norm = [&](const Matrix6& m) { return (size.asDiagonal() * m * size.asDiagonal()).norm(); };
      const double whole = hinge_beam(true).axial;
      if (norm(kinks) > 1e-4 * whole) {
        ++corners;
        continue;
      }
      ++seen;
      CHECK(near_zero(norm(k - r.tangent) / whole, 2e-6));
    }
    MESSAGE("tangents: ", seen, " compared, ", corners, " at corners");
    CHECK(seen > 80);
  }
}

TEST_CASE("a beam in space that is removed by its failed hinge dissipates its stored energy") {
  HingeLaw law = pressed_hinge_3d();
  law.ultimate = 0.02, law.removes = true;
  CHECK_NOTHROW(law.check());
  LedHinges3 led{space_beam(false), {law, law}};
  led.along({1e-3, 0.03, -0.04, -0.03, 0.05, 0.01}, 300);
  CHECK(status_of(led.now.memory, 1) == HingeStatus::removed);
  for (const double s : led.now.stress) CHECK(s == 0);
  CHECK(led.now.stored == 0);
}

}  // namespace trilith
