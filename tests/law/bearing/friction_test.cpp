// Sliders whose friction depends on speed and load, flat and on a dish.
#include "law/bearing/friction.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "law/bearing/led.hpp"
#include "law/bearing/pendulum.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

TEST_CASE("friction changes from rest to fast sliding as 1 - exp(-rate v)") {
  const double slow = 0.04, fast = 0.12, load = 2e5;
  for (const double rate : {20.0, 50.0, 100.0})
    for (const double speed : {1e-6, 0.005, 0.02, 0.1, 2.0}) {
      LedLaw<Friction> led{{slow, 1e9, 0, fast, rate, 1, 0}, 1e-3, load};
      for (int i = 0; i < 3; ++i) led.to(led.at - 1e-3);  // beyond the slack, against the following motion
      led.dt = 1e-3 / speed;
      for (int i = 0; i < 3; ++i) led.to(led.at + 1e-3);
      CHECK(near(led.now.force(), load * (fast - (fast - slow) * std::exp(-rate * speed)), 1e-12));
      CHECK(std::abs(led.unbooked()) <= 1e-12 * led.work);
    }
}

TEST_CASE("friction of a power of the load is mu N at its reference and less than in proportion above it") {
  const double mu = 0.1, reference = 1e6, exponent = 0.85;
  for (const double load : {1e3, 1e6, 4e6}) {
    LedLaw<Friction> led{{mu, 1e10, 0, 0, 50, exponent, reference}, 1e-3, load};
    led.along(0.01);
    CHECK(near(led.now.force(), mu * load * std::pow(load / reference, exponent - 1), 1e-12));
  }
  LedLaw<Friction> lifted{{mu, 1e10, 0, 0, 50, exponent, reference}, 1e-3, 0};
  lifted.along(0.01);
  CHECK(lifted.now.force() == 0);
}

TEST_CASE("without fast friction and load exponent the bits do not depend on speed or reference load") {
  LedLaw<Friction> plain{{0.3, 1e7, 20}, 1e-3, 5e4}, set{{0.3, 1e7, 20, 0, 80, 1, 3e5}, 1e-3, 5e4};
  LedLaw<Pendulum> dish{{2, 0.3, 1e7, 20}, 1e-3, 5e4}, set_dish{{2, 0.3, 1e7, 20, 0, 80, 1, 3e5}, 1e-3, 5e4};
  CHECK(plain.law.dashpot() == 20);
  CHECK(set.law.dashpot() == 20);
  for (const double d : {0.1, -0.07, 0.02}) {
    plain.along(d), set.along(d), dish.along(d), set_dish.along(d);
    CHECK(plain.now.force() == set.now.force());
    CHECK(plain.lost == set.lost);
    CHECK(dish.now.force() == set_dish.now.force());
  }
}

TEST_CASE("a load exponent without its reference load is rejected with the name of the law") {
  CHECK_NOTHROW((Friction{0.1, 1e7, 0, 0, 50, 0.85, 1e6}.check()));
  CHECK_THROWS_WITH_AS((Friction{0.1, 1e7, 0, 0, 50, 0.85, 0}.check()), doctest::Contains("friction: load_exponent"),
                       InputError);
  CHECK_THROWS_WITH_AS((Pendulum{2, 0.1, 1e7, 0, 0, 50, 0.85, 0}.check()), doctest::Contains("pendulum: load_exponent"),
                       InputError);
}

TEST_CASE("D3, R4 in one direction: at its reach a pendulum carries N d / R and its friction against the motion") {
  const double radius = 2, mu = 0.05, weight = 1e6, reach = 0.2;
  LedLaw<Pendulum> led{{radius, mu, 1e9, 0}, 1e-3, weight};
  led.now = led.law.respond({0, 0, 0, weight}, {});  // placed under its load
  led.along(reach), led.along(-reach), led.along(reach);
  CHECK(near(led.now.force(), 100e3 + 50e3, 1e-9));
  led.along(reach - 1e-3);
  CHECK(near(led.now.force(), 99.5e3 - 50e3, 1e-9));
  led.along(reach);
  const double before = led.lost;
  led.along(-reach, 4000), led.along(reach, 4000);  // steps that end where sliding begins
  MESSAGE("D3 loop " << led.lost - before << " J, expected 40000 J");
  CHECK(near(led.lost - before, 4 * mu * weight * (reach - mu * weight / 1e9), 1e-9));
  CHECK(near(led.lost - before, 40e3, 0.01));
}

TEST_CASE("R6: the amplitude of a released weight on a pendulum falls by 2 mu R per half swing and ends within mu R") {
  const double radius = 2, mu = 0.02, mass = 1e5, gravity = 9.80665, from = 0.22, dt = 2e-5;
  MassOn<Pendulum> m{mass, dt, {{radius, mu, 1e9, 0}}, from};
  m.compression = mass * gravity;
  m.now[0] = std::get<0>(m.laws).respond({from, 0, 0, m.compression}, Pendulum::begin_at(from));
  std::vector<double> turns, times;
  for (double last = -1; m.time < 8;) {
    m.step();
    if (last * m.v < 0 && turns.size() < 3) turns.push_back(m.x), times.push_back(m.time);
    if (m.v != 0) last = m.v;
  }
  REQUIRE(turns.size() == 3);
  MESSAGE("R6 turns at " << turns[0] << ", " << turns[1] << ", " << turns[2] << " m; expected -.14, .06, .02; after "
                         << times[0] << " s and " << times[1] - times[0] << " s, expected 1.41875 s; at last " << m.x);
  CHECK(near(turns[0], -0.14, 0.01));
  CHECK(near(turns[1], 0.06, 0.01));
  CHECK(near(turns[2], 0.02, 0.01));
  CHECK(near(m.x, 0.02, 0.01));
  CHECK(near_zero(m.v, 3e-3));  // within the slack before sliding, without a dashpot
  CHECK(near(times[0], 1.41875, 0.01));
  CHECK(near(times[1] - times[0], 1.41875, 0.01));
}

TEST_CASE("a slider without load moves and does not yield, with load it yields once it slides") {
  const auto yields = [](double load, double path) {
    LedLaw<Friction> led{{0.1, 1e9, 0, 0, 50, 1, 0}, 1e-3, load};
    LedLaw<Pendulum> on_dish{{1, 0.1, 1e9, 0, 0, 50, 1, 0, 0}, 1e-3, load};
    led.to(path), on_dish.to(path);
    const HorizontalMotion motion{{path, path}, {path / 1e-3, path / 1e-3}, 1e-3, load};
    const bool both = Friction{0.1, 1e9, 0, 0, 50, 1, 0}.respond_horizontal(motion, {}).yielding;
    CHECK(led.now.yielding == on_dish.now.yielding);
    CHECK(led.now.yielding == both);
    return led.now.yielding;
  };
  CHECK(!yields(0, 1e-15));
  CHECK(!yields(0, 0.1));
  CHECK(!yields(1e5, 0.99e-5 / std::sqrt(2.0)));  // below 0.1 N over the stiffness, along both axes too
  CHECK(yields(1e5, 1.01e-5));
}
