// Laws with any allowed numbers and any motion: all results are finite.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "geometry/plane/random_convex.hpp"
#include "law/bearing/direction_samples.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// A random number, often at an end of its range.
template <class L>
double any_number(const Parameter<L>& p, std::mt19937_64& bits) {
  const double most = p.most < unbounded ? p.most : std::pow(10, random_between(bits, -8, 12));
  const double share = random_between(bits, -0.3, 1.3);
  const double number = p.least + std::min(1.0, std::max(0.0, share)) * (most - p.least);
  return p.allows(number) ? number : most;
}

template <class L>
bool is_sound(const L& law) {
  if constexpr (requires { law.check(); }) {
    try {
      law.check();
    } catch (const InputError&) {
      return false;
    }
  }
  return true;
}

/// The first member that is not finite, or null.
const char* not_finite(const DirectionResponse& r) {
  const std::pair<const char*, double> all[] = {{"force", r.force()},
                                                {"inner", r.memory.inner},
                                                {"travelled", r.memory.travelled},
                                                {"stored", r.stored},
                                                {"compression", r.memory.compression},
                                                {"lost_inner", r.lost_inner},
                                                {"lost_damping", r.lost_damping}};
  for (const auto& [name, value] : all)
    if (!std::isfinite(value)) return name;
  return nullptr;
}

template <class L>
void move_at_random(const L& law, std::mt19937_64& bits) {
  DirectionMemory memory;
  double d = 0;
  for (int i = 0; i < 60; ++i) {
    const double dt = i % 7 == 0 ? 0 : std::pow(10, random_between(bits, -9, -1));
    const double rate = i % 5 == 0 ? 0 : std::pow(10, random_between(bits, -12, 3)) * (i % 2 == 0 ? 1 : -1);
    d += rate * dt;
    const double load = i % 3 == 0 ? 0 : std::pow(10, random_between(bits, -6, 9));
    const DirectionResponse r = law.respond({d, rate, dt, load}, memory);
    if (const char* name = not_finite(r)) {
      FAIL_CHECK(describe(law), ": ", name, " at ", d, " m, ", rate, " m/s, step ", dt, " s");
      return;
    }
    memory = r.memory;
  }
}

}  // namespace

TEST_CASE("a bearing law with any allowed parameters gives finite numbers for any motion and bounds its step") {
  std::mt19937_64 bits(11);
  DirectionLaws::for_each([&]<class L>() {
    for (int round = 0; round < 300; ++round) {
      L law = sample<L>(usual_in_bearings);
      for (const Parameter<L>& p : L::parameters()) law.*(p.member) = any_number(p, bits);
      if (!is_sound(law)) continue;
      CHECK(std::isfinite(law.tangent()));
      CHECK(std::isfinite(law.dashpot()));
      CHECK(law.tangent() >= 0);
      CHECK(law.dashpot() >= 0);
      move_at_random(law, bits);
    }
  });
}
