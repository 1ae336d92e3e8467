// Shear keys: elastic, then broken permanently, with or without friction.
#include "law/bearing/shear_key.hpp"

#include <doctest/doctest.h>

#include "law/bearing/led.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double key_stiffness = 5e7, key_strength = 2e5, key_reach = key_strength / key_stiffness;

}  // namespace

TEST_CASE("a key is a spring up to its strength, on either side") {
  for (const double sign : {1.0, -1.0}) {
    LedLaw<ShearKey> led{{key_stiffness, key_strength, 0.3, 0}};
    for (const double d : {0.999, -0.999, 0.5}) {
      led.along(sign * d * key_reach);
      CHECK(near(led.now.force(), sign * d * key_strength, 1e-12));
      CHECK_FALSE(led.now.yielding);
      CHECK_FALSE(ShearKey::broken(led.now.memory));
      CHECK(led.lost == 0);
    }
    led.along(sign * 1.001 * key_reach);
    CHECK(near(led.now.force(), sign * 0.3 * key_strength, 1e-12));
    CHECK(led.now.yielding);
    CHECK(ShearKey::broken(led.now.memory));
  }
}

TEST_CASE("a broken key without friction dissipates its stored energy and carries no force") {
  LedLaw<ShearKey> led{{key_stiffness, key_strength, 0, 0}};
  led.along(1.0001 * key_reach, 20000);
  CHECK(near(led.lost, 0.5 * key_strength * key_strength / key_stiffness, 1e-3));
  CHECK(led.now.stored == 0);
  const double lost = led.lost;
  for (const double d : {3.0, 0.0, -2.0, 1.0}) {
    led.along(d * key_reach);
    CHECK(led.now.force() == 0);
  }
  CHECK(led.lost == lost);
  CHECK(std::abs(led.unbooked()) <= 1e-12 * led.work);
}

TEST_CASE("a key with friction rubs with its share once broken: a loop dissipates 4 r F (D - r F / k)") {
  for (const double residual : {0.1, 0.4, 1.0}) {
    LedLaw<ShearKey> led{{key_stiffness, key_strength, residual, 0}};
    const double reach = 5 * key_reach, rubs = residual * key_strength;
    led.along(reach), led.along(-reach), led.along(reach);
    CHECK(near(led.now.force(), rubs, 1e-12));
    const double before = led.lost;
    led.along(-reach), led.along(reach);
    CHECK(near(led.lost - before, 4 * rubs * (reach - rubs / key_stiffness), 1e-9));
    CHECK(led.least_loss >= 0);
    CHECK(std::abs(led.unbooked()) <= 1e-12 * led.work);
  }
}

TEST_CASE("the dashpot of a key fails with it") {
  LedLaw<ShearKey> led{{key_stiffness, key_strength, 0, 1e5}, 1e-3};
  led.along(0.9 * key_reach, 9);
  CHECK(near(led.now.force(), 0.9 * key_strength + 1e5 * 0.1 * key_reach / 1e-3, 1e-9));
  led.along(2 * key_reach, 11);
  CHECK(led.now.force() == 0);
  CHECK(std::abs(led.unbooked()) <= 1e-12 * led.work);
}
