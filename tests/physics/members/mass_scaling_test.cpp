// Mass scaling of deformable bodies: added mass acts against deformation only, so that steps are longer.
#include "integrate/explicit/mass_scaling.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "energy_watch.hpp"
#include "near.hpp"
#include "physics/members/scaled_masses.hpp"
#include "physics/space/solids.hpp"

namespace trilith::testing {
namespace {

constexpr double bar_young = 20e9, bar_density = 2000, bar_length = 2, bar_depth = 0.1;

Model<2> lone_bar(bool is_held) {
  Model<2> model = alone(elastic("m", bar_density, bar_young, 0),
                         grid_body("bar", rectangle({0, 0}, {bar_length, bar_depth}), "", 40, 1));
  if (is_held)
    for (int n = 0; n < model.nodes(); ++n)
      if (model.start_position[n].x() < 1e-9) model.support[n][0] = Support::fixed;
  // Motion along the bar alone.
  for (int n = 0; n < model.nodes(); ++n) model.support[n][1] = Support::fixed;
  return model;
}

/// A stage with steps of `times` the stable step of `model`.
StageOptions scaled_stage(const Model<2>& model, double times, double duration) {
  Work<2> work;
  const State<2> state = initial_state(model);
  evaluate(model, state, work, 0);
  StageOptions options;
  options.duration = duration;
  options.mass_scaling.emplace();
  options.mass_scaling->step = times * options.safety * stable_step(model, state, work).dt;
  options.mass_scaling->most = 1000;
  return options;
}

/// Twice the time between two passages of the right end's velocity through 0 [s].
double swing_period(Simulation<2>& sim, const StageOptions& options, StageReport& report) {
  const int end = node_at(sim.model(), {bar_length, 0});
  double first = -1, last = -1, before = 0;
  int passages = 0;
  report = sim.run(options, [&] {
    RunListener<2> listener;
    listener.on_step = [&](const Instant<2>& now) {
      const double v = now.state.velocity[end].x();
      if (before != 0 && before * v < 0) {
        const double at = now.state.time - now.state.last_dt * v / (v - before);
        (first < 0 ? first : last) = at;
        if (last >= 0) ++passages;
      }
      before = v;
    };
    return listener;
  }());
  REQUIRE(passages > 3);
  return 2 * (last - first) / passages;
}

TEST_CASE("mass scaling: a held bar swings slower by the root of its mass and the added one over its mass") {
  const double c = std::sqrt(bar_young / bar_density), period = 4 * bar_length / c;
  Model<2> model = lone_bar(true);
  for (int n = 0; n < model.nodes(); ++n)
    model.start_velocity[n].x() = 0.01 * std::sin(0.5 * M_PI * model.start_position[n].x() / bar_length);
  const StageOptions options = scaled_stage(model, 4, 30 * period);
  Simulation<2> sim(model);
  StageReport report;
  const double found = swing_period(sim, options, report);
  REQUIRE(report.scaled);
  const double share = report.scaled->most;
  MESSAGE("added ", share, " times the mass, period ", found / period, " of the plain one");
  CHECK(near(share, 15, 0.01));  // the step is proportional to the square root of the mass
  CHECK(near(found, period * std::sqrt(1 + share), 1e-3));
  CHECK(near(report.scaled->share, share, 1e-12));  // this bar is the whole model
  CHECK(near(report.scaled->energy, share * report.scaled->kinetic, 1e-9));
  CHECK(near(report.longest_dt, options.mass_scaling->step, 1e-12));
  CHECK(near(report.scaled->before, report.longest_dt / 4, 0.09));  // at most one rung of the step ladder below
}

TEST_CASE("mass scaling: a free bar vibrates slower by the same factor, and its flight and rotation are unchanged") {
  const double c = std::sqrt(bar_young / bar_density), period = 2 * bar_length / c;
  Model<2> model = alone(elastic("m", bar_density, bar_young, 0),
                         grid_body("bar", rectangle({0, 0}, {bar_length, bar_depth}), "", 40, 1));
  for (int n = 0; n < model.nodes(); ++n)
    model.start_velocity[n].x() = 0.01 * std::cos(M_PI * model.start_position[n].x() / bar_length);
  Simulation<2> sim(model);
  const StageOptions options = scaled_stage(model, 3, 30 * period);
  StageReport report;
  const double found = swing_period(sim, options, report);
  CHECK(near(found, period * std::sqrt(1 + report.scaled->most), 2e-3));

  // Thrown and spinning: the same position, angle and momenta as without scaling.
  std::array<Pose, 2> pose;
  std::array<double, 2> angular{};
  for (const bool scaled : {false, true}) {
    BodySpec spec = grid_body("bar", rectangle({0, 0}, {bar_length, bar_depth}), "", 10, 2);
    spec.velocity = {3, 4}, spec.spin = 5;
    Model<2> thrown = alone(elastic("m", bar_density, bar_young, 0), spec);
    thrown.gravity.field = {0, -standard_gravity};
    StageOptions flight = scaled_stage(thrown, 5, 0.5);
    if (!scaled) flight.mass_scaling.reset();
    Simulation<2> s(thrown);
    s.run(flight);
    pose[scaled] = body_pose(s.model(), s.state(), 0);
    for (int n = 0; n < thrown.nodes(); ++n)
      angular[scaled] += thrown.mass[n] * cross(Vec2(s.state().position[n] - pose[scaled].place),
                                                Vec2(s.state().velocity[n] - pose[scaled].velocity));
  }
  MESSAGE("place ", pose[1].place.x(), " ", pose[1].place.y(), ", angle ", pose[1].rotation, " and ", pose[0].rotation);
  CHECK((pose[1].place - pose[0].place).norm() < 1e-4);  // leapfrog starts half a step off
  CHECK(near(pose[1].rotation, pose[0].rotation, 1e-3));
  CHECK(near(angular[1], angular[0], 1e-6));
}

TEST_CASE("mass scaling: a hanging bar stretches by rho g L^2 / 2E, by the weight of its own mass") {
  std::array<double, 2> stretch{};
  for (const bool scaled : {false, true}) {
    Model<2> model = lone_bar(true);
    model.gravity.field = {standard_gravity, 0};
    StageOptions options = scaled_stage(model, 4, 0.2);
    options.rest_share = 0.8;
    if (!scaled) options.mass_scaling.reset();
    Simulation<2> sim(model);
    sim.run(options);
    stretch[scaled] = sim.state().position[node_at(model, {bar_length, 0})].x() - bar_length;
  }
  CHECK(near(stretch[1], bar_density * standard_gravity * bar_length * bar_length / (2 * bar_young), 1e-3));
  CHECK(near(stretch[1], stretch[0], 1e-6));
}

/// Three meshed blocks on each other and a rigid one, on a base that is shaken.
Simulation<2> shaken_stack() {
  Scene scene(Frictional{1e10, 4e9, 0.5, 2e-5});
  scene.builder.add_material(elastic("soft", bar_density, 1e10, 0.2));
  scene.fixed("base", rectangle({-2, -1}, {2, 0}));
  for (int i = 0; i < 3; ++i) {
    BodySpec spec = grid_body("b" + std::to_string(i), rectangle({0.02 * i, 0.2 * i}, {0.4 + 0.02 * i, 0.2 * (i + 1)}),
                              "soft", 3, 2);
    spec.floating = false;
    scene.add(spec);
  }
  scene.block("top", rectangle({0.1, 0.6}, {0.4, 0.7}), 60);
  Model<2> model = scene.builder.build();
  scene.drive_along_x(model, "base", *motion_of(0.2, 1e-3, [](double t) { return 8 * std::sin(2 * M_PI * 10 * t); }));
  return Simulation<2>(model);
}

StageOptions shaking_stage(double step) {
  StageOptions options;
  options.duration = 0.2, options.energy_interval = 1e-3;
  if (step > 0) options.mass_scaling.emplace().step = step;
  return options;
}

TEST_CASE(
    "mass scaling: the energy balance of a shaken stack closes, in the stage and when its masses are its own again") {
  std::array<double, 2> residual{};
  std::array<Vec2, 2> top;
  for (const bool scaled : {false, true}) {
    Simulation<2> sim = shaken_stack();
    EnergyWatch watch;
    RunListener<2> listener;
    watch.listen(listener);
    const StageReport report = sim.run(shaking_stage(scaled ? 3e-5 : 0), listener);
    top[scaled] = sim.state().position[sim.model().bodies[4].first_node];
    if (scaled) {
      REQUIRE(report.scaled);
      CHECK(report.scaled->bodies == 3);
      CHECK(near(report.longest_dt, 3e-5, 1e-12));
      CHECK(report.scaled->before < 2e-5);
      CHECK(report.scaled->energy > 0);
      CHECK(report.scaled->energy < 0.01 * report.scaled->kinetic);
      CHECK(sim.state().added_share.empty());
      CHECK(sim.state().given[EnergyTerm::removed] >= 0);
    }
    StageOptions after = shaking_stage(0);
    after.duration = 0.05;
    const StageReport later = sim.run(after, listener);
    if (scaled) CHECK(later.longest_dt < 2e-5);
    residual[scaled] = watch.check.share();
  }
  MESSAGE("residuals ", residual[0], " and ", residual[1], ", the top's places part by ", (top[1] - top[0]).norm());
  CHECK(residual[1] < 5e-3);
  CHECK((top[1] - top[0]).norm() < 1e-3);
}

TEST_CASE("mass scaling: same bits for any threads, from a snapshot or a file within the stage, after freeing memory") {
  check_scaled_bits<2>(shaken_stack, shaking_stage(3e-5), 0.07, 0.1, 0.2);
}

std::string stack_refusal(const StageOptions& options) {
  return scaling_refusal(shaken_stack(), options);
}

TEST_CASE("mass scaling: an impossible step is rejected with the possible one") {
  CHECK(stack_refusal(shaking_stage(1e-3)).find("even if it were rigid") != std::string::npos);
  StageOptions little = shaking_stage(3e-5);
  little.mass_scaling->most = 0.5;
  CHECK(stack_refusal(little).find("must be at most 0.5 times") != std::string::npos);
  StageOptions both = shaking_stage(3e-5);
  both.dt = 1e-6;
  CHECK(stack_refusal(both).find("leave dt out") != std::string::npos);
  StageOptions implicit = shaking_stage(3e-5);
  implicit.integrator = AlphaMethod::hht(-0.05);
  CHECK(stack_refusal(implicit).find("explicit steps") != std::string::npos);
  StageOptions none = shaking_stage(3e-5);
  none.mass_scaling->step = -1;
  CHECK(stack_refusal(none).find("mass_scaling: step") != std::string::npos);
  // With scaling of chosen bodies the others keep their masses.
  StageOptions one = shaking_stage(3e-5);
  one.mass_scaling->bodies = {1};
  CHECK(stack_refusal(one).find("whose masses are not scaled") != std::string::npos);
}

}  // namespace
}  // namespace trilith::testing
