// Rigid solids in contact by implicit steps: sliding, rocking, standing and toppling agree with explicit steps although
// the steps are far longer. Invariants of every implicit stage (VALIDATION I12 with T30, T1).
#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <tuple>

#include "model/space_builder/solid_model_builder.hpp"
#include "near.hpp"
#include "physics/space/space_implicit.hpp"
#include "statics/equilibrium.hpp"

namespace trilith::testing {
namespace {

Polyhedron floor_of_solids() {
  return box_solid(Vec3(-3, -3, -0.5), Vec3(3, 3, 0));
}

/// One block on the floor, or a stack, under gravity tilted by an angle [rad] towards an azimuth [rad].
Model<3> stacked(const Vec3& sides, int count, double angle, double azimuth, const Frictional& law,
                 const Vec3& velocity = Vec3::Zero()) {
  SpaceBuilder builder;
  builder.gravity(tilted_gravity(angle, azimuth));
  builder.add(fixed_stone("floor", floor_of_solids()));
  for (int i = 0; i < count; ++i) {
    SolidBody block = stone("block " + std::to_string(i + 1), box_at(sides, Vec3(0, 0, (i + 0.5) * sides.z())));
    block.velocity = velocity;
    builder.add(block);
  }
  builder.contact(0, 0, law, "joint");
  return builder.build();
}

TEST_CASE("with implicit steps a block slides down a slope and stops on a flatter one at the exact place") {
  const double mu = 0.3, azimuth = 0.7;
  const Vec3 down(std::cos(azimuth), std::sin(azimuth), 0);
  for (const double degrees : {25.0, 10.0}) {
    const double angle = radians(degrees), g = standard_gravity;
    const Vec3 kick = degrees > 20 ? Vec3(Vec3::Zero()) : Vec3(0.5 * down);
    Simulation<3> sim(stacked(Vec3(0.5, 0.5, 0.5), 1, angle, azimuth, frictional(1e9, 1e9, mu, 2e-4), kick));
    CHECK(sim.run(careful_steps(0.2, 5e-3)).end == StageEnd::time);
    const Vec3 early = sim.state().velocity[1];
    CHECK(sim.run(careful_steps(0.4, 5e-3)).end == StageEnd::time);
    const double gain = g * (std::sin(angle) - mu * std::cos(angle));
    if (degrees > 20) {
      const Vec3 gained = (sim.state().velocity[1] - early) / 0.4;
      CHECK(near(gained.dot(down), gain, 5e-3));
      CHECK(near_zero((gained - gained.dot(down) * down).norm(), 5e-3));
    } else {
      CHECK(sim.state().velocity[1].norm() < 1e-3);
      CHECK(near(sim.state().position[1].head<2>().norm(), 0.5 * 0.25 / -gain, 0.02));
    }
    sim.refresh();
    const double moved = sim.model().mass[1] * g * 0.5;
    CHECK(near_zero(sim.energy().balance() - sim.model().mass[1] * 0.5 * kick.squaredNorm(), 2e-3 * moved));
  }
}

TEST_CASE("I12: with implicit steps of 1 ms a block released on one corner falls flat at the exact time") {
  const double alpha = std::atan(std::sqrt(0.08) / 0.6), radius = std::sqrt(0.08 + 0.36);
  const double about_pivot = (0.4 * 0.4 + 1.2 * 1.2) / 12 + radius * radius;  // moment of inertia over the mass [m2]
  for (const auto& [part, time, rate] :
       {std::tuple(0.25, 0.23855, 0.96906), std::tuple(0.5, 0.39321, 1.27205), std::tuple(0.75, 0.61422, 1.42437)}) {
    const double share = part;
    SpaceBuilder builder;
    builder.gravity(Vec3(0, 0, -standard_gravity));
    builder.add(fixed_stone("floor", floor_of_solids()));
    const Vec3 across = Vec3(-1, 1, 0).normalized(), pivot(0.2, 0.2, 0);
    const UnitQuaternion lean = rotation_by(share * alpha * across);
    const Vec3 centre = pivot + Turn3(lean).apply(Vec3(0, 0, 0.6) - pivot) - Vec3(0, 0, 1e-4);
    builder.add(stone("block", box_at(Vec3(0.4, 0.4, 1.2), centre, lean)));
    builder.contact(0, 0, frictional(1e14, 1e14, 2, 1e-5), "corner");
    Simulation<3> sim(builder.build());
    double last_angle = share * alpha, last_time = 0, lands = 0, speed = 0, aside = 0, highest = -1e300;
    const Vec3 third = cross(across, Vec3(Vec3::UnitZ()));
    StageOptions stage = careful_steps(1.1 * time, 1e-3);
    stage.energy_interval = 1e-3;
    RunListener<3> listener = after_each_step([&](const Instant<3>& now) {
      const Vec3 turned = angle_of(now.state.rotation[1] * inverse(now.model.start_rotation[1]));
      const double left = share * alpha + across.dot(turned);
      if (lands == 0 && left <= 0) lands = last_time + (now.state.time - last_time) * last_angle / (last_angle - left);
      // At the landing, up to one step ahead: by the pendulum's energy.
      if (lands == 0 && left > 2e-4)
        speed = std::sqrt(now.state.spin[1].squaredNorm() +
                          2 * left * standard_gravity * radius * std::sin(alpha - 0.5 * left) / about_pivot);
      if (lands == 0) aside = std::max({aside, std::abs(third.dot(turned)), std::abs(turned.z())});
      last_angle = left, last_time = now.state.time;
    });
    double first = 0;
    bool begun = false;
    listener.on_energy = [&](const Instant<3>&, const Energy& e) {
      const double all = e[EnergyTerm::kinetic] + e[EnergyTerm::gravity] + e[EnergyTerm::contact_elastic];
      if (!begun) first = all, begun = true;
      highest = std::max(highest, all - first);
    };
    const StageReport report = sim.run(stage, listener);
    INFO(report.reason);
    MESSAGE("I12, T30 q " << share << ": flat at " << lands << " s (" << time << "), " << speed << " rad/s (" << rate
                          << "), aside " << aside << " rad, " << report.steps << " steps, energy above its start "
                          << highest << " J");
    CHECK(report.end == StageEnd::time);
    CHECK(near(lands, time, 0.01));
    CHECK(near(speed, rate, 0.01));
    CHECK(aside < 1e-4);
    CHECK(highest < 1e-6 * sim.model().mass[1] * standard_gravity * 0.66332);
  }
}

TEST_CASE("a stack that was kicked slides the same with implicit and explicit steps") {
  // A stack of three blocks, each rotated relative to the one below.
  const auto model = [] {
    SpaceBuilder builder;
    builder.gravity(Vec3(0, 0, -standard_gravity));
    builder.add(fixed_stone("floor", floor_of_solids()));
    for (int i = 0; i < 3; ++i) {
      SolidBody block = stone("block " + std::to_string(i + 1),
                              box_at({0.4, 0.5, 0.3}, {0, 0, 0.15 + 0.3 * i}, rotation_by({0, 0, 0.2 * i})));
      block.velocity = {0.3 + 0.2 * i, 0.2 + 0.1 * i, 0};
      builder.add(block);
    }
    builder.contact(0, 0, frictional(1e9, 5e8, 0.4, 2e-4), "joint");
    return builder.build();
  };
  Simulation<3> soft(model()), fine(model());
  const StageReport fast = soft.run(careful_steps(1, 5e-3)), slow = fine.run(explicit_steps(1));
  INFO(fast.reason);
  CHECK(fast.end == StageEnd::time);
  for (const std::size_t n : {1, 2, 3}) {
    const Vec3 a = soft.state().position[n] - soft.model().start_position[n],
               b = fine.state().position[n] - fine.model().start_position[n];
    CHECK((a - b).norm() < 0.02 * b.norm());
  }
  MESSAGE("top went " << (fine.state().position[3] - fine.model().start_position[3]).norm() << " m; steps "
                      << fast.steps << " and " << slow.steps);
  CHECK(fast.steps * 2 < slow.steps);
}

TEST_CASE("a mortared pier sways the same with implicit and explicit steps") {
  const auto model = [] {
    SolidModelBuilder builder;
    builder.gravity = Vec3(0, 0, -standard_gravity);
    Bonded mortar;
    mortar.kn = 1e9, mortar.ks = 4e8, mortar.mu = 0.6, mortar.beta = 1e-3, mortar.tension = 1e6, mortar.cohesion = 1e6;
    builder.add_law("mortar", mortar);
    builder.set_contact("*", "*", "mortar");
    for (int i = 0; i < 4; ++i) {
      SolidSpec spec;
      spec.name = "block " + std::to_string(i), spec.pieces = {box_at({0.4, 0.3, 0.4}, {0, 0, 0.4 * i + 0.2})};
      spec.mass = 2000 * 0.4 * 0.3 * 0.4;
      if (i == 0) spec.support.fill(Support::fixed);
      spec.velocity = i == 0 ? Vec3(Vec3::Zero()) : Vec3(0.05 * i, 0.03 * i, 0);
      builder.add_body(spec);
    }
    return builder.build();
  };
  Simulation<3> soft(model()), fine(model());
  std::array<double, 2> most{};
  const auto see = [](double& to) {
    return after_each_step([&to](const Instant<3>& now) {
      to = std::max(to, (now.state.position[3] - now.model.start_position[3]).head<2>().norm());
    });
  };
  const StageReport fast = soft.run(careful_steps(0.1, 1e-3), see(most[0])),
                    slow = fine.run(explicit_steps(0.1), see(most[1]));
  INFO(fast.reason);
  CHECK(fast.end == StageEnd::time);
  CHECK(most[1] > 1e-4);
  CHECK(near(most[0], most[1], 0.02));
  MESSAGE("sways by " << most[0] << " and " << most[1] << " m in " << fast.steps << " and " << slow.steps << " steps");
}

Simulation<3> tumbling_block() {
  Model<3> model = stacked(Vec3(0.4, 0.5, 0.6), 1, 0.1, 0.4, frictional(4e8, 2e8, 0.5, 2e-4));
  model.start_position[1].z() += 0.05;
  model.start_spin[1] = Vec3(0.7, -0.4, 0.5);
  return Simulation<3>(model);
}

TEST_CASE("the state within an implicit stage in space continues with the same bits") {
  const StageOptions whole = careful_steps(0.4, 5e-3);
  Simulation<3> once = tumbling_block();
  once.run(whole);
  std::optional<State<3>> kept;
  Simulation<3> broken = tumbling_block();
  broken.run(whole, after_each_step([&](const Instant<3>& now) {
               if (now.state.step == 40) kept = now.state;
             }));
  REQUIRE(kept.has_value());
  Simulation<3> on(broken.model(), *kept);
  StageOptions rest = whole;
  rest.end_time = once.state().time;
  on.run(rest);
  CHECK(on.state().step == once.state().step);
  CHECK(state_hash(on.state()) == state_hash(once.state()));
}

TEST_CASE("a step in space that does not converge changes no state and reports the place") {
  // A law so steep about 0 that the floating-point resolution of a position cannot represent its force.
  Table steep;
  steep.displacement = {-1, -1e-12, 1e-12, 1}, steep.force = {-1e6, -1e6, 1e6, 1e6};
  SolidModelBuilder builder;
  builder.gravity = Vec3::Zero();
  SolidSpec base, mass;
  base.name = "base", base.pieces = {box_at({1, 1, 1}, {0, 0, 0})}, base.mass = 1, base.floating = true;
  base.support.fill(Support::fixed);
  mass.name = "mass", mass.pieces = {box_at({1, 1, 1}, {3, 0, 0})}, mass.mass = 1e-3, mass.floating = true;
  mass.velocity = {0.1, 0, 0}, mass.spin = {0.2, 0.1, 0};
  builder.add_body(base), builder.add_body(mass);
  BearingSpecOf<3> link;
  link.name = "link", link.body_a = "base", link.body_b = "mass", link.point_a = {0.5, 0, 0},
  link.point_b = {2.5, 0, 0};
  link.law[0] = steep;
  builder.add_bearing(link);
  Simulation<3> sim(builder.build());
  const State<3> before = sim.state();
  const StageReport report = sim.run(careful_steps(0.1, 5e-3));
  CHECK(report.end == StageEnd::not_converged);
  CHECK(report.reason.find("on mass") != std::string::npos);
  MESSAGE(report.reason);
  CHECK(sim.state().step == 0);
  CHECK(sim.state().time == 0);
  CHECK(sim.state().position[1] == before.position[1]);
  CHECK(sim.state().velocity[1] == before.velocity[1]);
  CHECK(sim.state().spin[1] == before.spin[1]);
  CHECK(angle_of(sim.state().rotation[1] * inverse(before.rotation[1])).norm() == 0);
}

TEST_CASE("explicit, implicit, explicit again in space: the energy balance stays closed") {
  Simulation<3> sim = tumbling_block();
  sim.refresh();
  const double begin = sim.energy().balance();
  sim.run(explicit_steps(0.2));
  CHECK(sim.run(careful_steps(0.2, 5e-3)).end == StageEnd::time);
  CHECK(sim.run(explicit_steps(0.2)).end == StageEnd::time);
  sim.refresh();
  CHECK(std::abs(sim.energy().balance() - begin) < 5e-3 * sim.model().mass[1] * standard_gravity * 0.05);
}

TEST_CASE("a stage with automatic integrator in space uses implicit steps while it is slow") {
  Simulation<3> sim(stacked(Vec3(0.5, 0.5, 0.3), 2, 0, 0, frictional(1e9, 5e8, 0.6, 2e-4)));
  // Twenty times the explicit step, the least for which implicit steps are cheaper.
  StageOptions stage = careful_steps(0.5, 0.02), rest = stage;
  rest.integrator = CentralDifference{};
  REQUIRE(sim.settle(rest, {}).end == StageEnd::rest);
  stage.may_change = true;
  const StageReport report = sim.run(stage);
  CHECK(report.end == StageEnd::time);
  CHECK(sim.state().implicit());
  CHECK(report.steps <= 26);
  CHECK(sim.state().velocity[2].norm() < 1e-6);
}

}  // namespace
}  // namespace trilith::testing
