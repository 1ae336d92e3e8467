// Laws of the directions of a bearing: common invariants, and the closed form of each.
#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "geometry/plane/random_convex.hpp"
#include "law/bearing/direction_samples.hpp"
#include "near.hpp"
#include "physics/scene.hpp"

namespace trilith {
namespace {

using testing::direction_samples;
using testing::DirectionSample;
using testing::near;

DirectionResponse respond(const DirectionLaw& law, const DirectionMotion& motion, const DirectionMemory& before) {
  return std::visit(
      [&](const auto& l) {
        if constexpr (std::is_same_v<std::decay_t<decltype(l)>, std::monostate>)
          return DirectionResponse{};
        else
          return l.respond(motion, before);
      },
      law);
}

/// A law with prescribed displacements in equal time steps, with its energies.
struct Led {
  DirectionLaw law;
  double dt = 1e-3, compression = 0;
  double displacement = 0;
  DirectionResponse last = {};
  double work = 0, lost = 0, largest_force = 0;

  void to(double d) {
    const DirectionResponse next = respond(law, {d, (d - displacement) / dt, dt, compression}, last.memory);
    work += 0.5 * (next.force() + last.force()) * (d - displacement);
    lost += next.lost_inner + next.lost_damping;
    largest_force = std::max(largest_force, std::abs(next.force()));
    displacement = d;
    last = next;
  }
  /// In `steps` equal steps.
  void along(double d, int steps = 200) {
    const double from = displacement;
    for (int i = 1; i <= steps; ++i) to(from + (d - from) * i / steps);
  }
};

/// A smooth random walk between -0.05 and 0.05 m, back to its start.
std::vector<double> random_path(std::uint64_t seed, int cycles, int steps) {
  std::mt19937_64 bits(seed);
  std::vector<double> path;
  double from = 0;
  for (int c = 0; c < cycles; ++c) {
    const double to = c + 1 == cycles ? 0 : random_between(bits, -0.05, 0.05);
    for (int i = 1; i <= steps; ++i) path.push_back(from + (to - from) * 0.5 * (1 - std::cos(M_PI * i / steps)));
    from = to;
  }
  return path;
}

/// Energy stored in a law as it is placed [J].
double prestress(const DirectionLaw& law) {
  return std::visit(
      [](const auto& l) {
        if constexpr (requires { l.pretension; })
          return std::max(0.0, l.pretension - l.stiffness * l.slack);
        else
          return 0.0;
      },
      law);
}

TEST_CASE("without motion every law has only its initial force and no energy") {
  for (const DirectionSample& n : direction_samples(100)) {
    Led led{n.law, 1e-3, 5e4};
    for (int i = 0; i < 3; ++i) led.to(0);
    INFO(n.name);
    const double placed = prestress(n.law);
    CHECK(std::abs(led.last.force() - placed) <= 1e-12 * placed);
    CHECK((led.last.stored > 0) == (placed > 0));
    CHECK(led.lost == 0);
  }
}

/// Energy balance of a law over a path.
struct Books {
  double most = 0, least_lost = 0, error = 0;  // [J]
  Books(const DirectionLaw& law, const std::vector<double>& path) {
    Led led{law, 1e-3, 5e4};
    const double at_rest = respond(law, {0, 0, 1e-3, 5e4}, {}).stored;
    led.last = respond(law, {0, 0, 0, 5e4}, {});
    for (const double d : path) {
      led.to(d);
      most = std::max(most, std::abs(led.work) + led.lost);
      least_lost = std::min(least_lost, led.lost);
      error = std::max(error, std::abs(led.work - (led.last.stored - at_rest) - led.lost));
    }
  }
};

TEST_CASE("in random cyclic motion work equals stored plus dissipated energy for every law") {
  for (const double damping : {0.0, 2e3})
    for (const DirectionSample& n : direction_samples(damping))
      for (const std::uint64_t seed : {1, 2, 3}) {
        INFO(n.name, ", seed ", seed);
        const Books books(n.law, random_path(seed, 40, 400));
        CHECK(books.error <= 1e-4 * books.most);
        CHECK(books.least_lost >= -1e-9 * books.most);
      }
}

TEST_CASE("the energy balance of every law closes to rounding, or with the square of the step") {
  for (const DirectionSample& n : direction_samples(0)) {
    const Books coarse(n.law, random_path(5, 20, 100)), fine(n.law, random_path(5, 20, 1600));
    INFO(n.name, ": ", coarse.error, " J and ", fine.error, " J");
    CHECK((coarse.error <= 1e-12 * coarse.most || fine.error < coarse.error / 50));
  }
}

TEST_CASE("energy balances of springs, bilinear springs, sliders, keys and dampers close to rounding") {
  for (const double damping : {0.0, 2e3})
    for (const DirectionLaw& law :
         {DirectionLaw(Linear{2e5, damping}), DirectionLaw(ElasticPlastic{2e5, 3e3, 0, damping}),
          DirectionLaw(ElasticPlastic{2e5, 3e3, 0.2, damping}), DirectionLaw(Friction{0.3, 1e6, damping}),
          DirectionLaw(Pendulum{2, 0.05, 1e6, damping}), DirectionLaw(Friction{0.03, 1e6, damping, 0.1, 30, 0.9, 1e5}),
          DirectionLaw(Pendulum{2, 0.03, 1e6, damping, 0.1, 30, 0.9, 1e5}),
          DirectionLaw(LeadRubber{3e3, 2e4, 0, 10, damping}), DirectionLaw(ShearKey{2e5, 3e3, 0.2, damping}),
          DirectionLaw(Viscous{2e4, 1, 0.4, 1e-3}), DirectionLaw(Maxwell{2e5, 2e4, 1, 1}),
          DirectionLaw(Maxwell{2e5, 2e4, 1, 0.4})})
      for (const std::uint64_t seed : {1, 2, 3}) {
        const Books books(law, random_path(seed, 40, 400));
        CHECK(books.error <= 1e-12 * books.most);
      }
}

/// Largest force per displacement and per velocity within a step.
struct Slopes {
  double tangent = 0, dashpot = 0;
  Slopes(const DirectionLaw& law, double compression) {
    std::visit(
        [&]<class L>(const L& l) {
          if constexpr (!std::is_same_v<L, std::monostate>) tangent = l.tangent(), dashpot = l.dashpot();
          // The dish's part is not part of the law itself.
          if constexpr (requires { l.radius; }) tangent += compression / l.radius;
        },
        law);
  }
};

bool broken(const DirectionLaw& law, const DirectionMemory& memory) {
  return std::visit(
      [&](const auto& l) {
        if constexpr (requires { l.broken(memory); })
          return l.broken(memory);
        else
          return false;
      },
      law);
}

TEST_CASE("tangent and dashpot of a law bound the change of its force in a step, except at failure") {
  const double compression = 5e4;
  for (const DirectionSample& n : direction_samples(0)) {
    const Slopes slopes(n.law, compression);
    Led led{n.law, 1e-3, compression};
    led.last = respond(n.law, {0, 0, 0, compression}, {});
    INFO(n.name);
    for (const double d : random_path(9, 20, 300)) {
      const double from = led.displacement;
      const DirectionMemory before = led.last.memory;
      // Relative to standing still: a damper's force remains without motion.
      const double still = respond(n.law, {from, 0, led.dt, compression}, before).force();
      led.to(d);
      if (broken(n.law, led.last.memory) && !broken(n.law, before)) continue;
      const double moved = std::abs(d - from), most = slopes.tangent * moved + slopes.dashpot * moved / led.dt;
      CHECK(std::abs(led.last.force() - still) <= most * (1 + 1e-9) + 1e-9);
    }
  }
}

TEST_CASE("a linear spring with a dashpot gives k d + c v and loses c v^2 in time") {
  Led led{Linear{1000, 50}, 0.01};
  led.along(0.1, 100);  // at 0.1 m/s
  CHECK(near(led.last.force(), 1000 * 0.1 + 50 * 0.1, 1e-12));
  CHECK(near(led.last.stored, 5, 1e-12));
  CHECK(near(led.lost, 50 * 0.01 * 1.0, 0.006));  // minus half a step at the start
}

TEST_CASE("a bilinear spring yields at its force, hardens with its share and yields back after twice the force") {
  for (const double share : {0.0, 0.1, 0.35}) {
    const double k = 1e6, fy = 2e4, dy = fy / k;
    Led led{ElasticPlastic{k, fy, share, 0}};
    led.along(dy * 0.999);
    CHECK_FALSE(led.last.yielding);
    led.along(5 * dy);
    CHECK(led.last.yielding);
    CHECK(near(led.last.force(), fy + share * k * 4 * dy, 1e-9));
    const double top = led.last.force();
    led.along(3.01 * dy);
    CHECK_FALSE(led.last.yielding);
    CHECK(near(led.last.force(), top - 1.99 * fy, 1e-9));
    led.along(1 * dy);
    CHECK(led.last.yielding);
    CHECK(near(led.last.force(), top - 2 * fy - share * k * 2 * dy, 1e-9));
    // A closed loop between -5 dy and 5 dy dissipates 4 fy (1 - share) (D - dy).
    led.along(-5 * dy), led.along(5 * dy);
    const double before = led.lost;
    led.along(-5 * dy), led.along(5 * dy);
    CHECK(near(led.lost - before, 4 * fy * (1 - share) * 4 * dy, 1e-9));
  }
}

TEST_CASE("a gap has no force inside its opening and a spring beyond it, on both sides or on the given one") {
  for (const double side : {0.0, 1.0, -1.0}) {
    Led led{Gap{1e5, 0.02, 0, side}};
    led.along(0.019);
    CHECK(led.last.force() == 0);
    led.along(0.05);
    CHECK(std::abs(led.last.force() - (side >= 0 ? 3000 : 0)) < 1e-9);
    CHECK(std::abs(led.last.stored - (side >= 0 ? 45 : 0)) < 1e-9);
    led.along(-0.05);
    CHECK(std::abs(led.last.force() + (side <= 0 ? 3000 : 0)) < 1e-9);
  }
}

TEST_CASE("the dashpot of a gap never pulls") {
  Led led{Gap{1e4, 0.01, 1e5, 0}, 1e-3};
  led.along(0.03, 300);
  for (int i = 0; i < 200; ++i) {
    led.to(led.displacement - 2e-4);
    CHECK(led.last.force() >= 0);
  }
}

TEST_CASE("a table is linear between its points, held beyond its ends, and stores its integral") {
  const Table table{{-0.05, -0.01, 0.02, 0.06}, {-4e3, -3e3, 1e3, 2e3}, 0};
  for (std::size_t i = 0; i < table.force.size(); ++i) CHECK(table.force_at(table.displacement[i]) == table.force[i]);
  CHECK(near(table.force_at(0.04), 1500, 1e-6));
  CHECK(near(table.force_at(-0.03), -3500, 1e-6));
  CHECK(table.force_at(-1) == -4e3);
  CHECK(table.force_at(1) == 2e3);
  CHECK(table.energy_at(0) == 0);
  for (const double d : {-0.2, -0.05, -0.02, -0.005, 0.013, 0.02, 0.05, 0.3}) {
    const int n = 200000;
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += table.force_at(d * (i + 0.5) / n) * d / n;
    CHECK(near(table.energy_at(d), sum, 1e-7));
  }
  CHECK(near(table.tangent(), 4e3 / 0.03, 1e-6));
}

TEST_CASE("a rising table never falls, at and between its points and beyond its ends") {
  std::mt19937_64 bits(3);
  for (int round = 0; round < 50; ++round) {
    Table table;
    double d = random_between(bits, -0.2, -0.1), f = random_between(bits, -5, 0);
    while (d < 0.1) {
      table.displacement.push_back(d), table.force.push_back(f);
      d += random_between(bits, 1e-4, 0.1), f += random_between(bits, 0, 3);
    }
    table.displacement.push_back(d), table.force.push_back(f);
    CHECK_NOTHROW(table.check());
    double last = table.force_at(-1);
    for (int i = 0; i <= 4000; ++i) {
      const double now = table.force_at(-0.5 + i * 2.5e-4);
      CHECK(now >= last);
      last = now;
    }
  }
}

TEST_CASE("a slider carries mu N at most, and a loop loses 4 mu N (D - mu N/k)") {
  const double mu = 0.3, n = 5e4, k = 1e7, slack = mu * n / k, d = 0.05;
  Led led{Friction{mu, k, 0}, 1e-3, n};
  led.along(0.5 * slack);
  CHECK(near(led.last.force(), 0.5 * mu * n, 1e-9));
  led.along(d), led.along(-d), led.along(d);
  const double before = led.lost;
  led.along(-d);
  CHECK(near(led.last.force(), -mu * n, 1e-12));
  led.along(d);
  CHECK(near(led.largest_force, mu * n, 1e-12));
  CHECK(near(led.lost - before, 4 * mu * n * (d - slack), 1e-9));
  led.compression = 0;  // lifted off
  led.to(0.9 * d);
  CHECK(led.last.force() == 0);
}

TEST_CASE("a slider that is activated late carries no force until it moves") {
  Led led{Friction{0.3, 1e7, 0}, 1e-3, 5e4, 0.25};
  led.last.memory = Friction::begin_at(0.25);
  led.to(0.25);
  CHECK(led.last.force() == 0);
  CHECK(led.lost == 0);
  led.along(0.3);
  CHECK(near(led.last.force(), 0.3 * 5e4, 1e-12));
}

TEST_CASE("the energy balances of slider and pendulum close under a changing compression") {
  for (const DirectionLaw& law : {DirectionLaw(Friction{0.3, 1e6, 100}), DirectionLaw(Pendulum{2, 0.05, 1e6, 100}),
                                  DirectionLaw(Pendulum{2, 0.05, 1e6, 100, 0.12, 50, 0.8, 3e4})}) {
    Led led{law, 1e-3, 5e4};
    std::mt19937_64 bits(4);
    double most = 0;
    for (const double d : random_path(6, 30, 200)) {
      led.compression = 5e4 * random_between(bits, 0, 2);
      led.to(d);
      most = std::max(most, std::abs(led.work) + std::abs(led.lost));
      CHECK(std::abs(led.work - led.last.stored - led.lost) <= 1e-10 * most);
    }
  }
}

TEST_CASE("every parameter of every law outside its range is rejected, by name") {
  int refused = 0;
  DirectionLaws::for_each([&]<class L>() {
    const L sound = testing::sample<L>(testing::usual_in_bearings);
    for (const L& law : testing::samples<L>(testing::usual_in_bearings)) CHECK_NOTHROW(check_parameters(law));
    for (const Parameter<L>& p : L::parameters()) {
      std::vector<double> bad{std::nan(""), unbounded, -unbounded, p.least - 0.5};
      if (!p.includes_least) bad.push_back(p.least);
      if (p.most < unbounded) bad.push_back(p.most * 1.01);
      for (const double v : bad) {
        L law = sound;
        law.*(p.member) = v;
        try {
          check_parameters(law);
          FAIL_CHECK(L::name, ": ", p.name, " = ", v, " was taken");
        } catch (const InputError& e) {
          ++refused;
          CHECK(std::string(e.what()).find(p.name) != std::string::npos);
        }
      }
    }
  });
  MESSAGE(refused << " refused");
}

TEST_CASE("a table without two rising points about 0 is rejected, with the point") {
  const auto message = [](const Table& table) {
    try {
      table.check();
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  CHECK(message({{}, {}, 0}).find("at least 2 points") != std::string::npos);
  CHECK(message({{0}, {0}, 0}).find("at least 2 points") != std::string::npos);
  CHECK(message({{0, 1}, {0}, 0}).find("2 displacements and 1 forces") != std::string::npos);
  CHECK(message({{0, 0}, {0, 1}, 0}).find("point 2") != std::string::npos);
  CHECK(message({{0, 2, 1}, {0, 1, 2}, 0}).find("point 3") != std::string::npos);
  CHECK(message({{0, std::nan("")}, {0, 1}, 0}).find("point 2") != std::string::npos);
  CHECK(message({{0, 1}, {0, unbounded}, 0}).find("point 2") != std::string::npos);
  CHECK(message({{0.1, 1}, {0, 1}, 0}).find("must include 0") != std::string::npos);
  CHECK(message({{-1, -0.1}, {0, 1}, 0}).find("must include 0") != std::string::npos);
  CHECK(message({{-1, 0}, {0, 1}, 0}).empty());
}

}  // namespace
}  // namespace trilith
