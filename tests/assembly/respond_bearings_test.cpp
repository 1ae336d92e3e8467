// Bearings between bodies: invariants of a link at any points, and the state after its failure.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "assembly/evaluate.hpp"
#include "geometry/plane/random_convex.hpp"
#include "integrate/explicit/central_difference.hpp"
#include "near.hpp"
#include "physics/scene.hpp"

namespace trilith {
namespace {

using testing::box;
using testing::near;
using testing::Scene;

/// Two free bodies at a distance, without gravity, with the given link.
Model<2> linked_pair(BearingSpec link, double turn = 0) {
  Scene scene(Frictional{1e6, 1e6, 0.5, 0}, turn);
  scene.set_gravity({0, 0});
  BodySpec a, b;
  a.name = "a", a.outline = box(0, 0, 1, 0.6), a.mass = 120, a.velocity = {0.4, -0.1}, a.spin = 0.7;
  b.name = "b", b.outline = {{2, 0.1}, {3, 0}, {2.6, 1.2}}, b.mass = 75, b.velocity = {-0.5, 0.3}, b.spin = -1.1;
  scene.add(a), scene.add(b);
  link.name = "link", link.body_a = "a", link.body_b = "b";
  link.point_a = scene.to_world(link.point_a), link.point_b = scene.to_world(link.point_b);
  link.angle += turn;
  scene.builder.add_bearing(link);
  scene.builder.set_contact("*", "*", "none");
  return scene.builder.build();
}

struct Momentum {
  Vec2 linear = Vec2::Zero();
  double angular = 0;
};

Momentum momentum(const Model<2>& model, const State<2>& s) {
  Momentum sum;
  for (int n = 0; n < model.nodes(); ++n) {
    const Vec2 p = model.mass[n] * s.velocity[n];
    sum.linear += p;
    sum.angular += cross(s.position[n], p) + model.inertia[n] * s.spin[n];
  }
  return sum;
}

std::vector<BearingSpec> many_links() {
  std::vector<BearingSpec> links(4);
  links[0].point_a = {1, 0.3}, links[0].point_b = {2, 0.1};      // on both outlines, of finite length
  links[1].point_a = links[1].point_b = {1.6, 0.5};              // zero length, outside both bodies
  links[2].point_a = {0.5, 0.3}, links[2].point_b = {2.5, 0.5};  // inside both bodies
  links[3].point_a = {-0.6, 1.4}, links[3].point_b = {4, -1};    // outside by nearly the size of the bodies
  for (BearingSpec& l : links) {
    l.law = {Linear{4e3, 30}, ElasticPlastic{6e3, 200, 0.1, 10}, Linear{500, 5}};
    l.angle = 0.4;
  }
  links[1].law[along] = Gap{5e3, 0.02, 20, 0};
  links[2].law[axial] = Table{{-0.1, 0, 0.2}, {-500, 0, 700}, 3};
  links[3].law[along] = Pendulum{2, 0.1, 3e3, 0};
  return links;
}

TEST_CASE("a link keeps momentum and angular momentum, of any length and with points outside the bodies") {
  for (const BearingSpec& link : many_links()) {
    Simulation<2> sim(linked_pair(link));
    const Momentum before = momentum(sim.model(), sim.state());
    const double size = 120 * 0.5 * 3;
    testing::run_for(sim, 1e-3, 1e-3);  // a step of half an acceleration first
    for (int i = 0; i < 5; ++i) {
      testing::run_for(sim, 0.5, 1e-3);
      const Momentum now = momentum(sim.model(), sim.state());
      CHECK((now.linear - before.linear).norm() < 1e-10 * size);
      // Velocities are half a step behind positions: x and p belong to one instant up to dt/2 v, along p for each body.
      CHECK(std::abs(now.angular - before.angular) < 1e-9 * size);
    }
  }
}

TEST_CASE("a link's force is the same in a frame rotated by any angle") {
  for (const double turn : {17.0, 90.0, 203.0}) {
    const double angle = turn * testing::degree;
    for (const BearingSpec& link : many_links()) {
      Simulation<2> straight(linked_pair(link)), turned(linked_pair(link, angle));
      testing::run_for(straight, 1, 1e-3);
      testing::run_for(turned, 1, 1e-3);
      for (int n = 0; n < 2; ++n) {
        CHECK((Turn(angle).apply(straight.state().position[n]) - turned.state().position[n]).norm() < 1e-9);
        CHECK(near(straight.state().rotation[n], turned.state().rotation[n], 1e-8));
      }
    }
  }
}

TEST_CASE("a link rotated rigidly with its bodies has no force") {
  for (const BearingSpec& link : many_links()) {
    Model<2> model = linked_pair(link);
    State<2> state = initial_state(model);
    Work<2> work;
    const Turn turn(1.1);
    for (int n = 0; n < 2; ++n) {
      state.position[n] = turn.apply(state.position[n]) + Vec2(3, -2);
      state.rotation[n] = 1.1;
      state.velocity[n] = cross(0.9, Vec2(state.position[n] - Vec2(1, 1)));  // rotating together
      state.spin[n] = 0.9;
    }
    evaluate(model, state, work, 1e-3);
    CHECK(work.bearing_displacement[0].norm() < 1e-12);
    CHECK(work.bearing_force[0].norm() < 1e-8);
    CHECK(std::abs(work.bearing_moment[0]) < 1e-9);
  }
}

/// A block on a base, linked to it, and moved along it at a constant speed.
struct Pulled {
  Scene scene{Frictional{1e8, 5e7, 0.4, 2e-4}};
  Pulled() {
    scene.fixed("base", box(-2, -0.5, 3, 0));
    BodySpec block;  // fixed rotation: a link at a point alone would let it tip
    block.name = "block", block.outline = box(0, 0, 1, 0.5), block.mass = 1000, block.support[2] = Support::fixed;
    scene.add(block);
    scene.builder.overlap_allowed = 1e-3;
  }
  BearingSpec link() const {
    BearingSpec l;
    l.name = "first", l.body_a = "base", l.body_b = "block";
    l.point_a = l.point_b = {0.5, 0};
    l.law[along] = Linear{2e5, 0};
    l.limit[along] = 0.02;
    return l;
  }
  /// Moves the block for `duration` [s]; returns the events.
  std::vector<Event> pull(Simulation<2>& sim, double duration, double dt = 0) {
    const double speed = 0.1;
    std::vector<Event> events;
    RunListener<2> listener;
    listener.on_event = [&](const Event& e, const Instant<2>&) { events.push_back(e); };
    Model<2>& model = sim.edit_model();
    const int block = model.find_body("block");
    set_drive(model, block, 0,
              std::make_shared<GroundMotion>(std::vector<double>{0, 0}, duration + 1, MotionStart{speed, 0}),
              sim.state().time, sim.state().position[model.bodies[block].first_node].x());
    testing::run_for(sim, duration, dt, listener);
    return events;
  }
};

TEST_CASE(
    "the last force of a bearing acts for another half step, and the energy balance contains its work to rounding") {
  // Without contact and weight a block of 2,000 kg pulls a spring with a dashpot until it breaks. Without the half step
  // of the last force the residual would be F v dt / 2: about 2 % at steps of 4 ms.
  for (const bool implicitly : {false, true})
    for (const double dt : {4e-3, 1e-3}) {
      Scene scene(Frictional{1e8, 5e7, 0.4, 0});
      scene.builder.set_contact("*", "*", "none");
      scene.set_gravity({0, 0});
      scene.fixed("base", box(0, 0, 1, 1));
      scene.block("block", box(2, 0, 3, 1), 2000, {1, 0});
      BearingSpec spring;
      spring.name = "spring", spring.body_a = "base", spring.body_b = "block";
      spring.point_a = {1, 0.5}, spring.point_b = {2, 0.5};
      spring.law[along] = Linear{2e5, 2e3}, spring.limit[along] = 0.0523;
      scene.builder.add_bearing(spring);
      Simulation<2> sim = scene.start();
      StageOptions options;
      options.duration = 0.2, options.dt = dt, options.energy_interval = dt;
      if (implicitly) options.integrator = AlphaMethod::hht(0);
      std::vector<double> balance;
      RunListener<2> listener;
      listener.on_energy = [&](const Instant<2>&, const Energy& e) { balance.push_back(e.balance()); };
      sim.run(options, listener);
      CAPTURE(implicitly);
      CAPTURE(dt);
      REQUIRE(sim.state().bearing[0].status == BearingStatus::failed);
      REQUIRE(balance.size() > 20);
      CHECK(near(balance.back(), balance[2], 1e-12));
    }
}

TEST_CASE("a bearing fails at its limit and dissipates its stored energy") {
  Pulled p;
  p.scene.builder.set_contact("*", "*", "none");
  BearingSpec l = p.link();
  l.law[axial] = Linear{1e7, 0};
  p.scene.builder.add_bearing(l);
  Simulation<2> sim = p.scene.start();
  testing::settle(sim);
  p.pull(sim, 0.19);
  CHECK(sim.state().bearing[0].status == BearingStatus::intact);
  CHECK(near(-sim.work().bearing_force[0].x(), 2e5 * 0.019, 1e-3));
  p.pull(sim, 0.03, 1e-4);
  CHECK(sim.state().bearing[0].status == BearingStatus::failed);
  CHECK(sim.work().bearing_force[0].norm() == 0);
  const double weight = 1000 * standard_gravity;
  const double stored = 0.5 * 2e5 * 0.02 * 0.02 + 0.5 * weight * weight / 1e7;
  CHECK(near(sim.state().given[EnergyTerm::bearing_failure], stored, 2e-3));
}

TEST_CASE("a bearing becomes another one: a slider starts at the present position and then carries mu N") {
  Pulled p;
  p.scene.builder.set_contact("*", "*", "none");
  BearingSpec first = p.link(), second = p.link();
  first.law[axial] = second.law[axial] = Linear{1e8, 2e5};
  first.becomes_bearing = "second";
  second.name = "second", second.starts_waiting = true, second.limit[along] = unbounded;
  second.law[along] = Friction{0.3, 1e7, 0};
  p.scene.builder.add_bearing(first);
  p.scene.builder.add_bearing(second);
  Simulation<2> sim = p.scene.start();
  testing::settle(sim);
  CHECK(sim.state().bearing[1].status == BearingStatus::waiting);
  const std::vector<Event> events = p.pull(sim, 0.3, 1e-4);
  CHECK(sim.state().bearing[0].status == BearingStatus::changed);
  CHECK(sim.state().bearing[1].status == BearingStatus::yielded);
  CHECK(near(-sim.work().bearing_force[1].x(), 0.3 * 1000 * standard_gravity, 0.005));
  CHECK(near(sim.state().bearing[1].direction[along].travelled, 0.01 - 0.3 * 1000 * standard_gravity / 1e7, 0.01));
  int failed = 0, changed = 0;
  for (const Event& e : events) {
    failed += e.type == EventType::bearing_failed ? 1 : 0;
    changed += e.type == EventType::bearing_changed ? 1 : 0;
    if (e.type == EventType::bearing_failed) CHECK(near(e.value, 0.02, 0.01));
  }
  CHECK(failed == 1);
  CHECK(changed == 1);
}

TEST_CASE("a bearing becomes contact: the two bodies touch from then on, under the law named") {
  for (const double mu : {0.2, 0.5}) {
    Pulled p;
    p.scene.builder.add_law("worn", Frictional{1e8, 5e7, mu, 2e-4});
    BearingSpec l = p.link();
    l.law[axial] = Linear{1e8, 2e5};
    l.replaces_contact = true;
    l.contact_after = "worn";
    p.scene.builder.add_bearing(l);
    Simulation<2> sim = p.scene.start();
    testing::settle(sim);
    for (const ContactMemory& m : sim.state().contacts.memory) CHECK(m.empty());
    p.pull(sim, 0.3);
    const double moving = sim.state().given[EnergyTerm::contact_friction];
    p.pull(sim, 0.5);
    CHECK(sim.state().bearing[0].status == BearingStatus::changed);
    const double slid = 0.05, loss = sim.state().given[EnergyTerm::contact_friction] - moving;
    CHECK(near(loss / slid, mu * 1000 * standard_gravity, 0.01));
  }
}

TEST_CASE("a bearing placed at a point that is not a number is rejected") {
  Pulled p;
  BearingSpec l = p.link();
  l.point_b.x() = std::nan("");
  CHECK_THROWS_AS(p.scene.builder.add_bearing(l), InputError);
  l = p.link();
  l.limit[axial] = -1;
  CHECK_THROWS_AS(p.scene.builder.add_bearing(l), InputError);
  l = p.link();
  l.law[along] = Linear{-5, 0};
  CHECK_THROWS_AS(p.scene.builder.add_bearing(l), InputError);
}

}  // namespace
}  // namespace trilith
