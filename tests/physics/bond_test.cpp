// VALIDATION C7, C8: a bonded joint pulled and sheared.
#include <algorithm>

#include "near.hpp"
#include "physics/scene.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Force on a block and its displacement, at one instant.
struct Reading {
  double moved, force;  // [m], [N]
};

/// A joint of 1 m2 between a fixed base and a block with a prescribed displacement along one axis of the scene and no
/// rotation.
struct JointTest {
  Scene scene;
  Simulation<2> sim;
  int node;
  std::vector<Event> events;  ///< of bonds, during the prescribed motion

  /// `axis` 0: shear under `pressure` [Pa]; 1: tension.
  JointTest(const ContactLaw& law, int axis, double pressure, double turn)
      : scene(law, turn), sim(make(scene, axis, pressure)), node(node_of(sim.model(), "block")) {}

  static Simulation<2> make(Scene& scene, int axis, double pressure) {
    scene.set_gravity(Vec2::Zero());
    scene.fixed("base", rectangle({-1, -0.5}, {2, 0}));
    BodySpec spec;
    spec.name = "block", spec.outline = rectangle({0, 0}, {1, 0.5}), spec.mass = 100;
    spec.load = {0, -pressure};
    spec.support = {axis == 0 ? Support::fixed : Support::free, axis == 1 ? Support::fixed : Support::free,
                    Support::fixed};
    scene.add(spec);
    return scene.start();
  }

  /// Moves the block along `axis` by u(t) = size sin(2 pi t / period), for `cycles`.
  std::vector<Reading> lead(int axis, double size, double period, double cycles) {
    const double w = 2 * M_PI / period, end = cycles * period, start = sim.state().time;
    const auto motion = motion_of(
        end, period / 4000, [&](double t) { return -size * w * w * std::sin(w * t); }, size * w);
    const int body = sim.model().find_body("block");
    const double origin = sim.state().position[node][axis];
    set_drive(sim.edit_model(), body, axis, motion, start, origin);
    std::vector<Reading> readings;
    RunListener<2> listener = each_step([&](const Instant<2>& now) {
      readings.push_back(
          {motion->displacement(now.state.time - now.state.last_dt - start), -(now.work.force[node][axis])});
    });
    listener.on_event = [&](const Event& e, const Instant<2>&) {
      if (e.type == EventType::bond_cracked || e.type == EventType::bond_broken) events.push_back(e);
    };
    run_for(sim, end - 1e-6 * period, period / 20000, listener);
    return readings;
  }
};

/// The reading of the largest force.
Reading peak(const std::vector<Reading>& readings) {
  return *std::max_element(readings.begin(), readings.end(),
                           [](const Reading& a, const Reading& b) { return a.force < b.force; });
}

}  // namespace

TEST_CASE("C7: a cohesive joint carries its tensile strength, then nothing, and friction only once closed again") {
  for (const double by_point : {0.0, 1.0}) {
    const double ft = 19150, kn = 1e8;
    JointTest joint(Bonded{kn, 0.5 * kn, 0.7, 0, 1e5, ft, by_point}, 1, 0, 0);
    CHECK(joint.sim.state().contacts.memory.at(0).bonds == 3);
    const std::vector<Reading> r = joint.lead(1, 3e-4, 1.0, 1.5);
    const Reading most = peak(r);
    MESSAGE("C7 peak pull ", most.force, " N (19150) at ", most.moved, " m (1.915e-4)");
    CHECK(near(most.force, ft, 0.005));
    CHECK(near(most.moved, ft / kn, 0.005));
    const auto lost = std::find_if(r.begin(), r.end(), [&](const Reading& x) { return x.moved > 1.005 * ft / kn; });
    double after = 0, deepest = 0;
    for (auto it = lost; it != r.end(); ++it) {
      after = std::max(after, it->force);
      deepest = std::min(deepest, it->force);
    }
    CHECK(after == 0.0);  // no tension afterwards
    CHECK(near(deepest, -kn * 3e-4, 0.005));
    CHECK(joint.sim.state().contacts.memory.at(0).bonds == 0);
  }
}

TEST_CASE(
    "C7: the paper's mortar, whose tension is beyond the apex of its Coulomb line, carries its tension when pulled") {
  const double ft = 19150, kn = 1e8, mu = std::tan(35 * degree);
  CHECK(ft > 9768 / mu);
  for (const double by_point : {0.0, 1.0}) {
    JointTest joint(Bonded{kn, 0.5 * kn, mu, 0, 9768, ft, by_point}, 1, 0, 0);
    const Reading most = peak(joint.lead(1, 3e-4, 1.0, 0.5));
    MESSAGE("C7, paper's mortar: peak pull ", most.force, " N (19150) at ", most.moved, " m (1.915e-4)");
    CHECK(near(most.force, ft, 0.005));
    CHECK(near(most.moved, ft / kn, 0.005));
  }
}

TEST_CASE("C7: closed again after its loss, the joint resists by friction only") {
  const double kn = 1e8, mu = 0.7, pressure = 5e4;
  Bonded law{kn, 0.5 * kn, mu, 1e-4, 1e5, 19150, 0};
  JointTest joint(law, 1, pressure, 0);
  joint.lead(1, 3e-4, 1.0, 1.0);
  CHECK(joint.sim.state().contacts.memory.at(0).bonds == 0);
  Model<2>& model = joint.sim.edit_model();
  const int body = model.find_body("block");
  set_support(model, body, 1, Support::free);
  set_support(model, body, 0, Support::fixed);
  settle(joint.sim);
  const Reading most = peak(joint.lead(0, 3e-3, 4.0, 0.5));
  CHECK(near(most.force, mu * pressure, 0.005));
}

TEST_CASE("C8: direct shear reaches c + s tan(phi), then s tan(phi), and unloads along ks") {
  struct Case {
    double pressure, cohesion, degrees, kn, ks;
  };
  for (const Case c : {Case{5e4, 9768, 35, 1e8, 5e7}, Case{2e5, 4e4, 30, 4e8, 1e8}, Case{1e4, 9768, 20, 1e8, 1e8}})
    for (const double by_point : {0.0, 1.0}) {
      const double mu = std::tan(c.degrees * degree), slides = mu * c.pressure, breaks = c.cohesion + slides;
      JointTest joint(Bonded{c.kn, c.ks, mu, 1e-5, c.cohesion, 1e5, by_point}, 0, c.pressure, 0);
      settle(joint.sim);
      const double size = 4 * breaks / c.ks;
      const std::vector<Reading> r = joint.lead(0, size, 4.0, 0.5);
      const Reading most = peak(r);
      MESSAGE("C8 peak ", most.force, " Pa (", breaks, ") at ", most.moved, " m (", breaks / c.ks, ")");
      CHECK(near(most.force, breaks, 0.005));
      CHECK(near(most.moved, breaks / c.ks, 0.005));
      const auto turning =
          std::max_element(r.begin(), r.end(), [](const Reading& a, const Reading& b) { return a.moved < b.moved; });
      CHECK(near(turning->force, slides, 0.005));
      // Reversed by the elastic displacement: the force falls by ks times the displacement, through zero, to the
      // opposite limit.
      const auto back =
          std::find_if(turning, r.end(), [&](const Reading& x) { return x.moved < turning->moved - slides / c.ks; });
      CHECK(std::abs(back->force) < 0.01 * slides);
      const auto half = std::find_if(turning, r.end(),
                                     [&](const Reading& x) { return x.moved < turning->moved - 0.5 * slides / c.ks; });
      CHECK(near((turning->force - half->force) / (turning->moved - half->moved), c.ks, 0.005));
      CHECK(near(r.back().force, -slides, 0.005));
    }
}

TEST_CASE("a bond's failure is an event with its mode, its time and the force it carried") {
  const double ft = 19150, kn = 1e8, c = 3e4, pressure = 5e4, mu = 0.7;
  JointTest pulled(Bonded{kn, 0.5 * kn, mu, 0, 1e5, ft, 0}, 1, 0, 0);
  pulled.lead(1, 3e-4, 1.0, 0.25);
  REQUIRE(pulled.events.size() == 1);
  CHECK(pulled.events[0].type == EventType::bond_broken);
  CHECK(pulled.events[0].mode == JointMode::tension);
  CHECK(near(pulled.events[0].value, ft, 0.005));
  CHECK(near(pulled.events[0].time, std::asin(ft / kn / 3e-4) / (2 * M_PI), 0.005));
  JointTest sheared(Bonded{kn, 0.5 * kn, mu, 1e-5, c, 1e6, 0}, 0, pressure, 0);
  settle(sheared.sim);
  sheared.lead(0, 4 * (c + mu * pressure) / (0.5 * kn), 4.0, 0.25);
  REQUIRE(sheared.events.size() == 1);
  CHECK(sheared.events[0].mode == JointMode::shear);
  CHECK(near(sheared.events[0].value, std::hypot(c + mu * pressure, pressure), 0.005));
}

TEST_CASE("a softening bond names its first damage and its loss") {
  const double ft = 19150, kn = 1e8;
  const Cohesive law{kn, 0.5 * kn, 0.7, 0, 3e4, ft, 10, 50, 0, 0};
  JointTest joint(law, 1, 0, 0);
  const std::vector<Reading> r = joint.lead(1, 2e-3, 1.0, 0.25);
  CHECK(near(peak(r).force, ft, 0.005));
  REQUIRE(joint.events.size() == 2);
  CHECK(joint.events[0].type == EventType::bond_cracked);
  CHECK(joint.events[0].mode == JointMode::tension);
  CHECK(near(joint.events[0].value, ft, 0.01));
  CHECK(joint.events[1].type == EventType::bond_broken);
  CHECK(near(joint.events[1].time, std::asin(2 * 10 / ft / 2e-3) / (2 * M_PI), 0.01));
}
