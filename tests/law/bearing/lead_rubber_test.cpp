// Lead rubber bearing: the design loop of engineers, and the alternative inputs of its stiffness.
#include "law/bearing/lead_rubber.hpp"

#include <doctest/doctest.h>

#include "law/bearing/led.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

TEST_CASE("R3: a lead rubber bearing has its yield point, force, effective stiffness, loop and damping") {
  const double k1 = 10e6, k2 = 1e6, q = 90e3, reach = 0.15;
  LedLaw<LeadRubber> led{{q, k2, k1, 10, 0}};
  led.along(0.00999);
  CHECK_FALSE(led.now.yielding);
  CHECK(near(led.now.force(), 99.9e3, 1e-9));
  led.along(0.01001);
  CHECK(led.now.yielding);
  CHECK(near(led.now.force(), 100e3, 1e-3));
  led.along(reach), led.along(-reach), led.along(reach);
  CHECK(near(led.now.force(), 240e3, 1e-9));
  CHECK(near(led.now.force() / reach, 1.6e6, 1e-9));
  const double before = led.lost;
  led.along(0, 150);  // in steps that end where it yields
  CHECK(near(led.now.force(), 240e3 - 2 * 100e3 - k2 * (reach - 0.02), 1e-9));
  led.along(-reach, 150), led.along(reach, 300);
  MESSAGE("R3 loop " << led.lost - before << " J, expected 50400 J");
  CHECK(near(led.lost - before, 50.4e3, 1e-9));
  CHECK(near((led.lost - before) / (2 * M_PI * 1.6e6 * reach * reach), 0.22282, 1e-4));
  CHECK(std::abs(led.unbooked()) <= 1e-12 * led.work);
}

TEST_CASE("the first stiffness of a lead rubber bearing is as given, or its ratio to the second, to the bit") {
  LedLaw<LeadRubber> given{{9e4, 1e6, 8e6, 10, 300}}, by_ratio{{9e4, 1e6, 0, 8, 300}};
  CHECK(given.law.tangent() == 8e6);
  CHECK(by_ratio.law.tangent() == 8e6);
  for (const double d : {0.1, -0.07, 0.02}) {
    given.along(d), by_ratio.along(d);
    CHECK(given.now.force() == by_ratio.now.force());
  }
}

TEST_CASE("a first stiffness that is not above the second is rejected, with both") {
  CHECK_NOTHROW((LeadRubber{9e4, 1e6, 1.01e6, 10, 0}.check()));
  CHECK_NOTHROW((LeadRubber{9e4, 1e6, 0, 10, 0}.check()));
  CHECK_THROWS_AS((LeadRubber{9e4, 1e6, 1e6, 10, 0}.check()), InputError);
}
