// Steel fibres against closed forms.
#include <doctest/doctest.h>

#include <cmath>

#include "law/material/uniaxial_led.hpp"
#include "near.hpp"

namespace trilith {
namespace {

using testing::LedFibre;
using testing::near;
using testing::near_zero;

constexpr double modulus = 2e11, yield_stress = 4e8, yield_strain = yield_stress / modulus;

/// The Menegotto-Pinto curve from a reversal to a point.
double curve_of(double e, double e_r, double s_r, double e_0, double s_0, double b, double r) {
  const double x = (e - e_r) / (e_0 - e_r);
  return s_r + (s_0 - s_r) * (b * x + (1 - b) * x / std::pow(1 + std::pow(std::abs(x), r), 1 / r));
}

}  // namespace

TEST_CASE("bilinear steel: first line, second line, and the loop of kinematic hardening") {
  const double b = 0.05, reach = 5 * yield_strain;
  LedFibre<BilinearSteel> led{{modulus, yield_stress, b, 0}};
  led.along(reach);
  const double top = yield_stress * (1 + b * 4);
  CHECK(near(led.now.stress(), top, 1e-12));
  led.along(-reach);
  CHECK(near(led.now.stress(), -top, 1e-12));
  const double lost = led.lost;
  led.along(reach), led.along(-reach);
  // A steady loop: 2 yield across, on both of its long sides (2 reach - 2 yield strains of strain, minus b of it).
  const double area = 4 * yield_stress * (1 - b) * (reach - yield_strain);
  MESSAGE("kinematic loop " << led.lost - lost << " J/m3, closed form " << area);
  CHECK(near(led.lost - lost, area, 1e-3));
}

TEST_CASE("bilinear steel with isotropic hardening yields in compression where it left off in tension") {
  const double b = 0.1, plastic_gain = modulus * b / (1 - b);
  for (const double share : {0.0, 0.4, 1.0}) {
    LedFibre<BilinearSteel> led{{modulus, yield_stress, b, share}};
    led.along(4 * yield_strain);
    const double top = led.now.stress(), flow = (top - yield_stress) / plastic_gain;
    const double across = 2 * (yield_stress + share * plastic_gain * flow);
    led.along(led.at - across / modulus * 0.999999);
    CHECK(led.now.tangent == modulus);
    led.along(led.at - across / modulus * 0.000002);
    CHECK(near(led.now.tangent, b * modulus, 1e-12));
    CHECK(near(top - led.now.stress(), across, 1e-5));
  }
}

TEST_CASE("Menegotto and Pinto: each curve is their equation, from reversal to reversal") {
  const MenegottoPinto law{modulus, yield_stress, 0.02, 20, 0.925, 0.15, 0, 1};
  LedFibre<MenegottoPinto> led{law};
  for (int i = 1; i <= 50; ++i) {
    led.to(0.2 * i * yield_strain);
    CHECK(near(led.now.stress(), curve_of(led.at, 0, 0, yield_strain, yield_stress, 0.02, 20), 1e-12));
  }
  // Down: the lines from the reversal and of hardening in compression meet at (e_0, s_0).
  const double e_r = led.at, s_r = led.now.stress();
  const double e_0 = (-yield_stress * 0.98 - s_r + modulus * e_r) / (modulus * 0.98),
               s_0 = -yield_stress + 0.02 * modulus * (e_0 + yield_strain);
  CHECK(near(s_0, s_r + modulus * (e_0 - e_r), 1e-12));
  const double x = (std::abs(-yield_strain - e_0)) / yield_strain, r = 20 * (1 - 0.925 * x / (0.15 + x));
  for (int i = 1; i <= 80; ++i) {
    led.to(e_r - 0.2 * i * yield_strain);
    CHECK(near_zero(led.now.stress() - curve_of(led.at, e_r, s_r, e_0, s_0, 0.02, r), 1e-12 * yield_stress));
  }
  // Up again: the farthest strain in tension is e_r.
  const double e_2 = led.at, s_2 = led.now.stress();
  const double e_3 = (yield_stress * 0.98 - s_2 + modulus * e_2) / (modulus * 0.98),
               s_3 = yield_stress + 0.02 * modulus * (e_3 - yield_strain);
  const double y = std::abs(e_r - e_3) / yield_strain, q = 20 * (1 - 0.925 * y / (0.15 + y));
  for (int i = 1; i <= 80; ++i) {
    led.to(e_2 + 0.2 * i * yield_strain);
    CHECK(near_zero(led.now.stress() - curve_of(led.at, e_2, s_2, e_3, s_3, 0.02, q), 1e-12 * yield_stress));
  }
}

TEST_CASE("Menegotto and Pinto: the curve approaches its hardening line, shifted with a3") {
  for (const double a3 : {0.0, 0.05}) {
    LedFibre<MenegottoPinto> led{{modulus, yield_stress, 0.01, 20, 0.9, 0.15, a3, 2}};
    led.along(8 * yield_strain), led.along(-100 * yield_strain, 4000);
    const double shift = a3 * (8 - 2), line = yield_stress * (1 + shift + 0.01 * 99);
    CHECK(near(-led.now.stress(), line, 0.002));
  }
}

TEST_CASE("Menegotto and Pinto with a sharp corner is near bilinear steel, however large the strain") {
  LedFibre<MenegottoPinto> sharp{{modulus, yield_stress, 0.02, 100, 0, 0.15, 0, 1}};
  LedFibre<BilinearSteel> straight{{modulus, yield_stress, 0.02, 0}};
  for (const double e : {0.8, 4.0, -4.0, 6.0, 3e4, -3e4}) {
    sharp.along(e * yield_strain), straight.along(e * yield_strain);
    CHECK(near_zero(sharp.now.stress() - straight.now.stress(), 1e-6 * yield_stress * std::max(1.0, std::abs(e))));
  }
}

TEST_CASE("inconsistent parameters of steel are rejected") {
  CHECK_THROWS_AS((MenegottoPinto{modulus, yield_stress, 0.01, 10, 0.95, 0.15, 0, 1}.check()), InputError);
  CHECK_NOTHROW((MenegottoPinto{modulus, yield_stress, 0.01, 20, 0.925, 0.15, 0, 1}.check()));
  CHECK_THROWS_AS(check_parameters(BilinearSteel{modulus, 0, 0, 0}), InputError);
}

}  // namespace trilith
