// Concrete fibres against the equations of their envelopes, and their cycles.
#include <doctest/doctest.h>

#include <cmath>

#include "law/material/uniaxial_led.hpp"
#include "near.hpp"

namespace trilith {
namespace {

using testing::LedFibre;
using testing::near;
using testing::near_zero;

constexpr double fc = 30e6;

template <class L>
double plastic_after(LedFibre<L> led) {
  led.along(0, 4000);
  double low = -1, high = 0;  // bounds of the closing strain, at which the stress is 0
  for (int i = 0; i < 100; ++i) {
    const double e = 0.5 * (low + high);
    (led.law.respond(e, led.now.memory).stress() < 0 ? low : high) = e;
  }
  return high;
}

}  // namespace

TEST_CASE("Kent and Park: parabola, straight softening, rest, with and without confinement") {
  for (const double k : {1.0, 1.3}) {
    LedFibre<KentPark> led{{fc, 0.002, 0.008, 0.2, k, 0, 0}};
    for (int i = 1; i <= 100; ++i) {
      const double e = 1e-4 * i, x = e / (k * 0.002);
      led.to(-e);
      const double down = k * fc * (1 - 0.8 * (e - k * 0.002) / (0.008 - k * 0.002));
      const double expected = x <= 1 ? k * fc * (2 * x - x * x) : e <= 0.008 ? down : 0.2 * k * fc;
      CHECK(near(-led.now.stress(), expected, 1e-12));
    }
  }
}

TEST_CASE("Mander: the curve of Popovics up to the ultimate strain, the rest beyond") {
  const double young = 27e9, k = 1.25, e_c = 0.002 * (1 + 5 * (k - 1)), r = young / (young - k * fc / e_c);
  LedFibre<Mander> led{{fc, young, 0.002, 0.02, 0.1, k, 0, 0}};
  for (int i = 1; i <= 100; ++i) {
    const double e = 2.5e-4 * i, x = e / e_c;
    led.to(-e);
    const double curve = k * fc * x * r / (r - 1 + std::pow(x, r));
    CHECK(near(-led.now.stress(), e <= 0.02 * (1 + 1e-12) ? curve : 0.1 * k * fc, 1e-12));
  }
  led.along(0);
  LedFibre<Mander> peak{led.law};
  peak.to(-e_c);
  CHECK(near(-peak.now.stress(), k * fc, 1e-12));
  CHECK(near_zero(peak.now.tangent, 1e-9 * young));
}

TEST_CASE("concrete unloads along one line to the plastic strain of Karsan and Jirsa, and loads along it again") {
  for (const double ratio : {0.8, 1.5, 2.5}) {
    LedFibre<KentPark> led{{fc, 0.002, 0.01, 0.2, 1, 0, 0}};
    led.along(-ratio * 0.002);
    const double share = ratio < 2 ? 0.145 * ratio * ratio + 0.13 * ratio : 0.84 + 0.707 * (ratio - 2);
    CHECK(near(plastic_after(led), -share * 0.002, 1e-9));
    const double top = led.now.stress(), at = led.at, lost = led.lost;
    led.along(0.5 * (at - share * 0.002));
    CHECK(near(led.now.stress(), 0.5 * top, 1e-9));
    led.along(at);
    CHECK(near(led.now.stress(), top, 1e-12));
    CHECK(near_zero(led.lost - lost, 1e-12 * lost));
  }
}

TEST_CASE("a small compression unloads along the initial slope") {
  LedFibre<KentPark> led{{fc, 0.002, 0.01, 0.2, 1, 0, 0}};
  led.along(-0.2 * 0.002);
  led.along(-0.19 * 0.002, 1);
  CHECK(near(led.now.tangent, 2 * fc / 0.002, 1e-12));
}

TEST_CASE("a crack opens along its softening line, closes to the origin, and has dissipated its energy") {
  const double tension = 3e6, end = 5e-4, young = 2 * fc / 0.002, first = tension / young;
  LedFibre<KentPark> led{{fc, 0.002, 0.006, 0.2, 1, tension, end}};
  led.along(first, 10);
  CHECK(near(led.now.stress(), tension, 1e-12));
  led.along(0.5 * (first + end));
  CHECK(near(led.now.stress(), 0.5 * tension, 1e-12));
  led.along(0.25 * (first + end));
  CHECK(near(led.now.stress(), 0.25 * tension, 1e-12));
  led.along(0);
  CHECK(near_zero(led.now.stress(), 1e-12 * tension));
  led.along(2 * end, 4000);
  CHECK(led.now.stress() == 0);
  MESSAGE("crack " << led.lost << " J/m3, closed form " << 0.5 * tension * end);
  CHECK(near(led.lost, 0.5 * tension * end, 1e-3));
  led.along(-1e-4);  // closed: as without a crack
  CHECK(near(-led.now.stress(), fc * (0.1 - 0.0025), 1e-12));
}

TEST_CASE("concrete without tension has none, and without an end of tension it cracks at once") {
  LedFibre<KentPark> none{{fc, 0.002, 0.006, 0.2, 1, 0, 0}}, brittle{{fc, 0.002, 0.006, 0.2, 1, 3e6, 0}};
  none.along(1e-3), brittle.along(0.99 * 3e6 * 0.002 / (2 * fc));
  CHECK(none.now.stress() == 0);
  CHECK(near(brittle.now.stress(), 0.99 * 3e6, 1e-12));
  brittle.along(1.02 * 1e-4);
  CHECK(brittle.now.stress() == 0);
  brittle.along(0.5e-4);
  CHECK(brittle.now.stress() == 0);
}

TEST_CASE("the energy error of a step over the kink of a closed crack falls with the square of the step") {
  double before = 0;
  for (const int steps : {10, 20, 40, 80}) {
    LedFibre<KentPark> led{{fc, 0.002, 0.006, 0.2, 1, 3e6, 1e-3}};
    led.along(3e-4, 3000), led.along(-1.003e-4, 3000);
    led.least_loss = 0;
    led.along(2.997e-4, steps);
    const double back = -led.least_loss;
    CHECK(back > 0);
    if (before > 0) CHECK(back < 0.6 * before);
    before = back;
  }
  CHECK(before < 2.0);  // of 30 J/m3 stored in the crack
}

TEST_CASE("crushed concrete has lost its tension too") {
  LedFibre<KentPark> led{{fc, 0.002, 0.006, 0, 1, 3e6, 1e-3}};
  led.along(-0.007), led.along(0.001, 1000);
  CHECK(led.now.stress() == 0);
}

TEST_CASE("inconsistent parameters of concrete are rejected") {
  CHECK_THROWS_AS((KentPark{fc, 0.002, 0.0021, 0.2, 1.1, 0, 0}.check()), InputError);
  CHECK_THROWS_AS((KentPark{fc, 0.002, 0.006, 0.2, 1, 2 * fc, 0}.check()), InputError);
  CHECK_THROWS_AS((Mander{fc, 10e9, 0.002, 0.006, 0, 1, 0, 0}.check()), InputError);
  CHECK_NOTHROW(KentPark::sample().check());
  CHECK_NOTHROW(Mander::sample().check());
}

}  // namespace trilith

namespace trilith {
namespace {

/// Energy per area that a bar of `length`, one fibre, dissipates beyond its peak. It is the work of the stress on the
/// displacement, with the elastic energy at the peak.
template <class L>
double softening_energy(const L& law, double length, double last_strain, int steps = 200'000) {
  LedFibre<L> led{law};
  const double peak = law.peak_strain();
  led.to(-peak);
  double work = 0.5 * led.now.stress() * led.now.stress() / law.initial();
  for (int i = 1; i <= steps; ++i) {
    const double before = led.now.stress(), strain = (last_strain - peak) / steps;
    led.to(-(peak + i * strain));
    work += -0.5 * (before + led.now.stress()) * strain;
  }
  return length * (work - 0.5 * led.now.stress() * led.now.stress() / law.initial());
}

}  // namespace

TEST_CASE("with a fracture energy a bar of any length dissipates this energy as it softens") {
  constexpr double energy = 25e3;  // [J/m2]
  for (const double length : {0.05, 0.2, 0.6}) {
    KentPark kent{fc, 0.002, 0.006, 0.2, 1.1, 0, 0};
    kent.crush_energy = energy;
    const KentPark own = kent.for_length(length);
    CHECK(near(softening_energy(own, length, own.ultimate), energy, 1e-6));
    CHECK(own.crush_energy == 0);

    Mander mander{fc, 27e9, 0.002, 0.012, 0.1, 1.2, 0, 0};
    mander.crush_energy = energy;
    const Mander stretched = mander.for_length(length);
    const double end = stretched.peak_strain() + stretched.stretch * (mander.ultimate - mander.peak_strain());
    CHECK(near(softening_energy(stretched, length, end * (1 - 1e-12)), energy, 1e-5));
    CHECK(near(stretched.envelope(end * (1 + 1e-9)).stress, 0.1 * 1.2 * fc, 1e-12));
  }
}

TEST_CASE("the strain of Coleman and Spacone for 20 % residual stress") {
  KentPark law{fc, 0.002, 0.006, 0.2, 1, 0, 0};
  law.crush_energy = 20e3;
  const double length = 0.3, e20 = 20e3 / (0.6 * fc * length) - 0.8 * fc / law.initial() + 0.002;
  CHECK(near(law.for_length(length).ultimate, e20, 1e-12));
}

TEST_CASE("the tangent of a stretched envelope is its slope, and stretch 1 has the bits of the plain curve") {
  Mander law{fc, 27e9, 0.002, 0.012, 0.1, 1.2, 0, 0};
  for (const double stretch : {0.3, 1.0, 4.0}) {
    law.stretch = stretch;
    for (const double e : {0.001, 0.0035, 0.0045, 0.006}) {
      constexpr double h = 1e-7;
      const double slope = (law.envelope(e + h).stress - law.envelope(e - h).stress) / (2 * h);
      CHECK(std::abs(law.envelope(e).slope - slope) < 1e-4 * law.young);
    }
  }
}

TEST_CASE("a crack dissipates its fracture energy in beams of any length") {
  KentPark law{fc, 0.002, 0.006, 0.2, 1, 2e6, 0};
  law.energy_tension = 100;
  for (const double length : {0.05, 0.3, 1.0}) {
    const KentPark own = law.for_length(length);
    CHECK(near(0.5 * law.tension * own.tension_end * length, 100, 1e-12));
    LedFibre<KentPark> led{own};
    double work = 0;
    constexpr int steps = 20'000;
    for (int i = 1; i <= steps; ++i) {
      const double before = led.now.stress();
      led.to(own.tension_end * i / steps);
      work += 0.5 * (before + led.now.stress()) * own.tension_end / steps;
    }
    CHECK(near(length * work, 100, 1e-4));
  }
}

TEST_CASE("a beam that would snap back as it softens, and energies without effect, are rejected") {
  KentPark law{fc, 0.002, 0.006, 0.2, 1, 2e6, 0};
  law.crush_energy = 20e3;
  // The line falls straight down where the bar's own elastic energy is the fracture energy.
  const double longest = 20e3 / (0.6 * fc * 0.8 * fc / law.initial());
  CHECK_NOTHROW((void)law.for_length(0.999 * longest));
  CHECK_THROWS_WITH_AS((void)law.for_length(1.001 * longest), doctest::Contains("more divisions"), InputError);
  law.residual = 1;
  CHECK_THROWS_AS(law.check(), InputError);
  law.residual = 0.2, law.energy_tension = 100, law.tension_end = 1e-3;
  CHECK_THROWS_AS(law.check(), InputError);
  law.tension_end = 0, law.tension = 0;
  CHECK_THROWS_AS(law.check(), InputError);
  Mander mander{fc, 27e9, 0.002, 0.012, 0.1, 1.2, 0, 0};
  mander.crush_energy = 25e3, mander.stretch = 2;
  CHECK_THROWS_AS(mander.check(), InputError);
  mander.stretch = 1;
  CHECK_THROWS_WITH_AS((void)mander.for_length(50), doctest::Contains("more divisions"), InputError);
}

}  // namespace trilith
