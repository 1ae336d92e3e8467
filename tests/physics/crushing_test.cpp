// Mortar that crushes under moving blocks: stopping distance, compressed toes, energy ledger.
#include <algorithm>

#include "law/contact/cohesive.hpp"
#include "model/check/energy_check.hpp"
#include "near.hpp"
#include "physics/scene.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double kn = 1e10;  // [Pa/m]

/// Mortar with almost no bond strength, so that crushing alone acts.
Cohesive mortar(double compression, double depth, double beta = 0) {
  Cohesive law{kn, 0.5 * kn, 0.7, beta, 1e3, 1e3, 1e-2, 1e-2, 0, 0};
  law.compression = compression, law.crushing_depth = depth;
  return law;
}

/// A run with its energy ledger and the number of joints that began to crush.
struct Watched {
  EnergyCheck check;
  Energy first, last;
  int crushed = 0;
  bool begun = false;

  StageReport run(Simulation<2>& sim, double duration, double dt = 0) {
    RunListener<2> listener;
    listener.on_energy = [&](const Instant<2>&, const Energy& e) {
      if (!begun) first = e, begun = true;
      check.add(e, e.balance() - first.balance());
      last = e;
    };
    listener.on_event = [&](const Event& e, const Instant<2>&) {
      if (e.type != EventType::joint_crushed) return;
      ++crushed;
      CHECK(e.mode == JointMode::compression);
    };
    StageOptions options;
    options.duration = duration, options.dt = dt, options.energy_interval = 1e-4;
    return sim.run(options, listener);
  }
  [[nodiscard]] double of(EnergyTerm term) const { return last[term] - first[term]; }
};

}  // namespace

TEST_CASE("a block that falls on weak mortar penetrates by its energy over the strength") {
  for (const double turn : {0.0, 2.0}) {
    const double strength = 2e5, mass = 1000, speed = 2;
    Scene scene(mortar(strength, 0.05), turn);
    scene.fixed("base", rectangle({-1, -1}, {2, 0}));
    scene.block("block", rectangle({0, 1e-3}, {1, 0.5}), mass, {0, -speed});
    Simulation<2> sim = scene.start();
    Watched watched;
    watched.run(sim, 0.2, 1e-5);
    const double resist = strength - mass * standard_gravity, elastic = strength / kn;
    // The elastic penetration recovers and bounces the block; the crushed depth remains.
    const double v2 = speed * speed + 2 * standard_gravity * 1e-3;
    const double depth = (0.5 * mass * v2 + mass * standard_gravity * elastic - 0.5 * strength * elastic) / resist;
    CHECK(near(watched.of(EnergyTerm::contact_fracture), strength * depth, 2e-3));
    CHECK(watched.crushed == 1);
    settle(sim);
    const double low = scene.to_scene(corner_of(sim, "block", 0)).y();
    CHECK(near(low, -depth, 5e-3));
    CHECK(watched.check.share() < 1e-3);
  }
}

TEST_CASE("a crushing toe makes a tilted block topple earlier, by a third of the length that carries its weight") {
  const double width = 0.4, height = 1.2, mass = 1000;
  for (const double share : {0.02, 0.05, 0.10}) {
    const double weight = mass * standard_gravity, strength = weight / (share * width);
    const double upright = std::atan(width / height);
    Scene scene(mortar(strength, 5e-3, 2e-5));
    scene.fixed("base", rectangle({-1, -1}, {2, 0}));
    scene.block("block", rectangle({0, 0}, {width, height}), mass);
    Simulation<2> sim = scene.start();
    settle(sim);
    Gravity<2>& gravity = sim.edit_model().gravity;
    gravity.tilt_rate = 0.5 * degree, gravity.tilt_start = sim.state().time - 0.7 * upright / gravity.tilt_rate;
    RunListener<2> listener;
    double tilt = 0;
    listener.on_history = [&](const Instant<2>& now) {
      tilt = gravity.tilt_rate * (now.state.time - gravity.tilt_start);
      if (now.speed > 0.05) sim.stop();
    };
    StageOptions options;
    options.duration = 0.4 * upright / gravity.tilt_rate, options.history_interval = 2e-3;
    REQUIRE(sim.run(options, listener).end == StageEnd::stopped);
    const double carried = share * width * std::cos(upright);
    const double expected = (width - 2 * carried / 3) / height;
    MESSAGE("pressed on ", share, " of the width: topples at ", std::tan(tilt), ", by the law ", expected,
            ", without crushing ", width / height);
    CHECK(near(std::tan(tilt), expected, 0.02));
    CHECK(std::tan(tilt) < width / height);
  }
}

TEST_CASE("a block that tumbles over mortar it crushes creates no energy, whatever shapes meet") {
  for (const double angle : {0.0, 0.004, 0.02, 0.3, 1.1}) {
    CAPTURE(angle);
    Scene scene(mortar(5e5, 4e-3, 2e-6));
    scene.fixed("base", rectangle({-4, -1}, {4, 0}));
    Polygon corners;
    for (const Vec2& p : rectangle({-0.3, -0.5}, {0.3, 0.5})) corners.push_back(Vec2(0, 1.2) + Turn(angle).apply(p));
    BodySpec spec;
    spec.name = "block", spec.outline = corners, spec.mass = 800, spec.velocity = {1.5, -1}, spec.floating = true;
    scene.add(spec);
    Simulation<2> sim = scene.start();
    Watched watched;
    watched.run(sim, 1.5, 2e-5);  // steps short enough for the impacts
    MESSAGE("tilted by ", angle, ": residual ", 100 * watched.check.share(), " %, crushing took ",
            watched.of(EnergyTerm::contact_fracture), " J of ", watched.check.input());
    CHECK(watched.crushed >= 1);
    CHECK(watched.of(EnergyTerm::contact_fracture) > 0);
    CHECK(watched.check.share() < 0.002);
    for (const int corner : {0, 1, 2, 3}) CHECK(corner_of(sim, "block", corner).y() > -0.02);
  }
}

TEST_CASE("mortar stays crushed while the block that crushed it bounces") {
  Scene scene(mortar(2e5, 0.01));
  scene.fixed("base", rectangle({-1, -1}, {2, 0}));
  scene.block("block", rectangle({0, 1e-3}, {1, 0.5}), 1000, {0, -1});
  Simulation<2> sim = scene.start();
  run_for(sim, 0.02);
  const auto crushed = [&] {
    return std::any_of(sim.state().contacts.memory.begin(), sim.state().contacts.memory.end(),
                       [](const ContactMemory& m) { return (m.state & contact_kept) != 0; });
  };
  REQUIRE(crushed());
  run_for(sim, 0.2);  // after the bounce the faces are apart and the crushed depth is kept
  CHECK(crushed());
}
