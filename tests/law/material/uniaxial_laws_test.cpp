// Invariants of every fibre law of the list.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "geometry/plane/random_convex.hpp"
#include "law/material/uniaxial_led.hpp"
#include "near.hpp"

namespace trilith {
namespace {

using testing::LedFibre;
using testing::near;
using testing::near_zero;

template <class F>
void for_each_fibre_law(F&& f) {
  UniaxialLaws::for_each([&]<class L>() {
    const std::vector<L> all = testing::fibre_samples<L>();
    CHECK(all.size() >= 1);
    for (const L& law : all) {
      INFO(describe(law));
      f(law);
    }
  });
}

/// A random number, often at an end of its range.
template <class L>
double any_fibre_number(const Parameter<L>& p, std::mt19937_64& bits) {
  const double most = p.most < unbounded ? p.most : std::pow(10, random_between(bits, -8, 12));
  const double number = p.least + std::clamp(random_between(bits, -0.3, 1.3), 0.0, 1.0) * (most - p.least);
  return p.allows(number) ? number : most;
}

template <class L>
bool is_sound_fibre(const L& law) {
  if constexpr (requires { law.check(); }) {
    try {
      law.check();
    } catch (const InputError&) {
      return false;
    }
  }
  return true;
}

/// Random strains, small and large, some twice.
double next_strain(double at, int i, std::mt19937_64& bits) {
  if (i % 11 == 0) return at;
  const double size = std::pow(10, random_between(bits, -5, -2.3));
  return std::clamp(at + random_between(bits, -size, size), -0.02, 0.02);
}

}  // namespace

TEST_CASE("stored plus dissipated energy of a fibre is its work, for any strains and steps") {
  std::mt19937_64 bits(3);
  for_each_fibre_law([&](const auto& law) {
    using L = std::decay_t<decltype(law)>;
    for (int round = 0; round < 20; ++round) {
      LedFibre<L> led{law};
      double most_work = 0;
      for (int i = 0; i < 400; ++i) {
        led.to(next_strain(led.at, i, bits));
        most_work = std::max(most_work, std::abs(led.work));
        REQUIRE(std::isfinite(led.now.stress()));
        CHECK(near_zero(led.now.stored - law.stored(led.now.memory), 1e-12 * led.now.stored));
        CHECK(led.now.stored >= 0);
      }
      CHECK(near_zero(led.unbooked(), 1e-11 * most_work));
      if (L::loses_at_every_step) CHECK(led.least_loss >= -1e-11 * led.most_stored);
    }
  });
}

TEST_CASE("strain loops dissipate energy at every instant, or up to 1e-4 of the stored energy") {
  std::mt19937_64 bits(4);
  for_each_fibre_law([&](const auto& law) {
    for (int round = 0; round < 20; ++round) {
      LedFibre<std::decay_t<decltype(law)>> led{law};
      const double a = random_between(bits, -0.006, 0.006), b = random_between(bits, -0.006, 0.006);
      using L = std::decay_t<decltype(law)>;
      double before = 0;
      for (int loop = 0; loop < 4; ++loop) {
        led.along(a), led.along(b);
        CHECK(led.lost - before >= (L::loses_at_every_step ? -1e-12 : -1e-4) * led.most_stored);
        before = led.lost;
      }
    }
  });
}

TEST_CASE("the tangent of a fibre matches finite differences and is at most the stiffest") {
  std::mt19937_64 bits(5);
  for_each_fibre_law([&](const auto& law) {
    LedFibre<std::decay_t<decltype(law)>> led{law};
    int seen = 0, corners = 0;
    const double h = 1e-10;
    for (int i = 1; i < 2000; ++i) {
      const auto before = led.now.memory;
      const double strain = next_strain(led.at, i, bits);
      led.to(strain);
      CHECK(led.now.tangent <= law.tangent() * (1 + 1e-12));
      const double at = led.now.stress(), up = law.respond(strain + h, before).stress() - at,
                   down = at - law.respond(strain - h, before).stress();
      // At rest the law may reverse, and at a corner the differences are on two branches.
      if (strain == before[last_strain] || std::abs(up - down) > 1e-5 * law.tangent() * h) {
        ++corners;
        continue;
      }
      ++seen;
      CHECK(near_zero((up + down) / (2 * h) - led.now.tangent, 1e-6 * law.tangent()));
    }
    CHECK(seen > 1600);
    CHECK(corners < 400);
  });
}

TEST_CASE("a fibre keeps its state, and its stress on unloading stays within its tangent") {
  std::mt19937_64 bits(6);
  for_each_fibre_law([&](const auto& law) {
    LedFibre<std::decay_t<decltype(law)>> led{law};
    for (int i = 1; i < 500; ++i) {
      led.to(next_strain(led.at, i, bits));
      const auto again = law.respond(led.at, led.now.memory);
      CHECK(near_zero(again.stress() - led.now.stress(), 1e-12 * law.tangent() * 0.01));
      CHECK(near_zero(again.dissipated, 1e-12 * led.most_stored));
    }
  });
}

TEST_CASE("a new fibre has no stress, and begins with a tangent that is not above its stiffest") {
  for_each_fibre_law([&](const auto& law) {
    const auto r = law.respond(0, {});
    CHECK(r.stress() == 0);
    CHECK(r.stored == 0);
    CHECK(r.dissipated == 0);
    CHECK(near(law.respond(-1e-9, {}).tangent, law.tangent(), 1e-5));
  });
}

TEST_CASE("a fibre law with any allowed parameters gives finite numbers for any strain") {
  std::mt19937_64 bits(13);
  UniaxialLaws::for_each([&]<class L>() {
    int sound = 0;
    for (int round = 0; round < 3000; ++round) {
      L law = testing::sample<L>(testing::usual_in_fibres);
      for (const Parameter<L>& p : L::parameters())
        if (random_between(bits, 0, 1) < 0.5) law.*(p.member) = any_fibre_number(p, bits);
      if (!is_sound_fibre(law)) continue;
      ++sound;
      LedFibre<L> led{law};
      for (int i = 0; i < 40; ++i) {
        const double size = std::pow(10, random_between(bits, -12, 0.5));
        led.to(i % 7 == 0 ? led.at : i % 5 == 0 ? 0 : random_between(bits, -size, size));
        const bool numbers = std::isfinite(led.now.stress() + led.now.tangent + led.now.stored + led.now.dissipated);
        if (!numbers || !(led.now.tangent <= law.tangent() * (1 + 1e-9)) || !(led.now.stored >= 0)) {
          FAIL_CHECK(describe(law), ": ", led.now.stress(), " Pa, ", led.now.tangent, " Pa at ", led.at);
          break;
        }
      }
    }
    CHECK(sound > 100);
  });
}

}  // namespace trilith
