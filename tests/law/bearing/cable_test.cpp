// Cables: taut and slack, prestressed, broken.
#include "law/bearing/cable.hpp"

#include <doctest/doctest.h>

#include "law/bearing/led.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Results of a mass on cables.
struct CableRun {
  double taut = 0, slack = 0;               ///< when [s]
  double peak = 0, at_peak = 0, force = 0;  ///< [m], [s], [N]
};

}  // namespace

TEST_CASE("R7 a: a mass that runs into a slack cable is caught and thrown back") {
  MassOn<Cable> m{1e3, 1e-6, {{1e6, 0.01, 0, 0, 0, 1}}};
  m.v = 0.5;
  CableRun seen;
  while (seen.slack == 0) {
    m.step();
    const bool taut = m.now[0].force() > 0;
    if (taut && seen.taut == 0) seen.taut = m.time;
    if (!taut && seen.taut > 0) seen.slack = m.time;
    seen.peak = std::max(seen.peak, m.x), seen.force = std::max(seen.force, m.now[0].force());
  }
  MESSAGE("R7 a: taut " << seen.taut << " s, peak " << seen.peak << " m, " << seen.force << " N, slack " << seen.slack);
  CHECK(near_zero(seen.taut - 0.02, 2e-6));
  CHECK(near(seen.peak, 0.025811, 0.002));
  CHECK(near(seen.force, 15811.4, 0.002));
  CHECK(near_zero(seen.slack - 0.119346, 2e-6));
  CHECK(near(m.v, -0.5, 1e-6));
}

TEST_CASE("R7 b: between two prestressed cables a mass swings on both, then on one") {
  const double dt = 1e-6;
  for (const double v0 : {0.5, 0.2}) {
    MassOn<Cable, Cable> m{1e3, dt, {{1e6, 0, 5e3, 0, 0, 1}, {1e6, 0, 5e3, 0, 0, -1}}};
    m.step();
    CHECK(near(m.now[0].force(), 5e3, 1e-5));
    CHECK(near(m.now[1].force(), -5e3, 1e-5));
    m.x = 0, m.v = v0, m.time = 0;
    CableRun seen;
    double period = 0, last = 0;
    while (period == 0) {
      last = m.x;
      m.step();
      if (m.now[1].force() == 0 && seen.slack == 0) seen.slack = m.time;
      if (m.x > seen.peak) seen.peak = m.x, seen.at_peak = m.time;
      seen.force = std::max(seen.force, m.now[0].force());
      if (last < 0 && m.x >= 0) period = m.time;
    }
    if (v0 < 0.2236) {
      CHECK(seen.slack == 0);
      CHECK(near(period, 0.140496, 0.002));
      continue;
    }
    MESSAGE("R7 b: slack " << seen.slack << " s, peak " << seen.peak << " m at " << seen.at_peak << " s, " << seen.force
                           << " N, period " << period << " s");
    CHECK(near_zero(seen.slack - 0.010367, 2e-6));
    CHECK(near(seen.peak, 0.0123205, 0.002));
    CHECK(near(seen.at_peak, 0.040577, 0.002));
    CHECK(near(seen.force, 17320.5, 0.002));
    CHECK(near(period, 0.162309, 0.002));
  }
}

TEST_CASE("R7 c: a push takes a mass into a slack cable") {
  const double dt = 1e-6;
  MassOn<Cable> m{1e3, dt, {{1e6, 0.005, 0, 0, 0, 1}}};
  CableRun seen;
  while (seen.slack == 0) {
    m.step(m.time < 0.1 ? 20e3 * std::sin(M_PI * m.time / 0.1) : 0);
    const bool taut = m.now[0].force() > 0;
    if (taut && seen.taut == 0) seen.taut = m.time;
    if (!taut && seen.taut > 0) seen.slack = m.time;
    if (m.x > seen.peak) seen.peak = m.x, seen.at_peak = m.time, seen.force = m.now[0].force();
  }
  MESSAGE("R7 c: taut " << seen.taut << " s, peak " << seen.peak << " m, " << seen.force << " N at " << seen.at_peak
                        << " s, slack " << seen.slack << " s");
  CHECK(near_zero(seen.taut - 0.037111, 2e-6));
  CHECK(near(seen.peak, 0.039876, 0.002));
  CHECK(near(seen.force, 34875.9, 0.002));
  CHECK(near(seen.at_peak, 0.103039, 0.002));
  CHECK(near_zero(seen.slack - 0.152712, 2e-6));
}

TEST_CASE("a cable breaks permanently at its strength and dissipates its stored energy") {
  const double k = 2e6, strength = 3e4;
  for (const double side : {1.0, -1.0})
    for (const double damping : {0.0, 1e4}) {
      LedLaw<Cable> led{{k, 0.01, 0, strength, damping, side}, 1e-3};
      led.along(side * (0.01 + 0.999 * strength / k));
      CHECK_FALSE(Cable::broken(led.now.memory));
      CHECK_FALSE(led.now.yielding);
      const double stored = led.now.stored, work = led.work, lost = led.lost;
      led.dt = 1e9;  // slowly, without the dashpot
      led.to(side * (0.01 + 1.001 * strength / k));
      CHECK(Cable::broken(led.now.memory));
      CHECK(led.now.yielding);
      CHECK(led.now.force() == 0);
      CHECK(led.now.stored == 0);
      CHECK(near(led.lost - lost, stored + (led.work - work), 1e-12));
      CHECK(near(stored, 0.5 * strength * strength / k, 3e-3));
      led.along(0), led.along(side * 0.05);
      CHECK(led.now.force() == 0);
      CHECK(led.now.yielding);
    }
}

TEST_CASE("a damped cable never pushes, and carries nothing while slack") {
  LedLaw<Cable> led{{1e5, 0.01, 0, 0, 1e5, 1}, 1e-3};
  led.along(0.0099);
  CHECK(led.now.force() == 0);
  led.along(0.03, 200);
  CHECK(led.now.force() > 2e3);
  for (int i = 0; i < 200; ++i) {
    led.to(led.at - 2e-4);
    CHECK(led.now.force() >= 0);
  }
  CHECK(led.now.force() == 0);
}

TEST_CASE("a cable that would break at its start is rejected") {
  CHECK_NOTHROW((Cable{1e6, 0, 5e3, 5e3, 0, 1}.check()));
  CHECK_NOTHROW((Cable{1e6, 0, 5e3, 0, 0, 1}.check()));
  CHECK_THROWS_AS((Cable{1e6, 0, 5e3, 4e3, 0, 1}.check()), InputError);
}
