// Mass scaling in space of bodies in contact: energy ledger, bounds of contact stiffness, bits, rejected options.
#include <doctest/doctest.h>

#include <cmath>

#include "energy_watch.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "near.hpp"
#include "physics/members/scaled_masses.hpp"
#include "physics/scene.hpp"
#include "physics/space/space_solids.hpp"

namespace trilith::testing {
namespace {

/// Three meshed blocks on each other and a rigid one, on a base that is shaken along x and y.
Simulation<3> shaken_tower(double length = 0.2) {
  SolidModelBuilder builder;
  builder.add_material(elastic_in("soft", 2000, 1e10, 0.2));
  builder.add_law("joint", Frictional{1e10, 4e9, 0.5, 2e-5});
  builder.set_contact("*", "*", "joint");
  const auto add = [&](const std::string& name, const Vec3& low, const Vec3& high, ElementShape shape) {
    SolidSpec spec = box_of(name, box_solid(low, high), "soft", {3, 2, 2}, shape);
    spec.floating = false;
    if (name == "base" || name == "top") spec.form = {};
    if (name == "base") spec.support.fill(Support::fixed);
    builder.add_body(spec);
  };
  add("base", Vec3(-1, -1, -0.5), Vec3(2, 2, 0), ElementShape::brick);
  for (int i = 0; i < 3; ++i)
    add("b" + std::to_string(i), Vec3(0.02 * i, 0.01 * i, 0.2 * i), Vec3(0.4 + 0.02 * i, 0.3 + 0.01 * i, 0.2 * (i + 1)),
        i == 1 ? ElementShape::tetrahedron : ElementShape::brick);
  add("top", Vec3(0.1, 0.1, 0.6), Vec3(0.4, 0.3, 0.7), ElementShape::brick);
  Model<3> model = builder.build();
  const auto motion = motion_of(length, 1e-3, [](double t) { return 8 * std::sin(2 * M_PI * 10 * t); });
  for (const int k : {0, 1}) set_drive(model, 0, k, motion, 0, model.start_position[0][k]);
  return Simulation<3>(model);
}

StageOptions tower_stage(double step, double duration = 0.06) {
  StageOptions options;
  options.duration = duration, options.energy_interval = 1e-3;
  if (step > 0) options.mass_scaling.emplace().step = step;
  return options;
}

TEST_CASE("mass scaling in space: the energy balance of a shaken tower closes, during and after the stage") {
  std::array<double, 2> residual{};
  std::array<Vec3, 2> top;
  for (const bool scaled : {false, true}) {
    Simulation<3> sim = shaken_tower();
    EnergyWatch watch;
    RunListener<3> listener;
    watch.listen(listener);
    const StageReport report = sim.run(tower_stage(scaled ? 3e-5 : 0), listener);
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
    const StageReport later = sim.run(tower_stage(0, 0.02), listener);
    if (scaled) CHECK(later.longest_dt < 2e-5);
    residual[scaled] = watch.check.share();
    MESSAGE("steps of ", report.longest_dt, ", residual ", residual[scaled]);
  }
  MESSAGE("the top's places part by ", (top[1] - top[0]).norm());
  CHECK(residual[1] < 5e-3);
  CHECK((top[1] - top[0]).norm() < 1e-3);
}

TEST_CASE("mass scaling in space: same bits for any threads, from a snapshot, from a file, with scratch memory freed") {
  check_scaled_bits<3>([] { return shaken_tower(); }, tower_stage(3e-5, 0.04), 0.015, 0.025, 0.04);
}

TEST_CASE("mass scaling in space: contact bounds a rigid body of elements by no less than its bounce") {
  Simulation<3> sim = shaken_tower();
  State<3> state = sim.state();
  state.position = sim.model().start_position;
  for (int b = 1; b < 5; ++b)
    for (int n = sim.model().bodies[b].first_node; n < sim.model().bodies[b].first_node + sim.model().bodies[b].nodes;
         ++n)
      state.position[n].z() -= 1e-5 * b;
  Work<3> work;
  evaluate(sim.model(), state, work, 0.0);
  const std::vector<BodyRates> rates = body_rates(sim.model(), state, work, true);
  const double mass = 2000 * 0.4 * 0.3 * 0.2, bounce = 1e10 * 0.4 * 0.3 / mass;
  MESSAGE("rigid bound ", rates[1].rigid.stiffness / bounce, " of kn A / m");
  CHECK(rates[1].rigid.stiffness > 2.8 * bounce);  // on a fixed base, under a body that moves as well
  CHECK(rates[1].rigid.stiffness < 12 * bounce);
  CHECK(rates[0].rigid.stiffness == 0);
  CHECK(rates[4].rigid.stiffness == 0);
  CHECK(near(rates[1].rigid.damping, 2e-5 * rates[1].rigid.stiffness, 1e-9));
}

std::string tower_refusal(const StageOptions& options) {
  return scaling_refusal(shaken_tower(), options);
}

TEST_CASE("mass scaling in space: an impossible step is rejected with the possible one") {
  CHECK(tower_refusal(tower_stage(1e-3)).find("even if it were rigid") != std::string::npos);
  StageOptions little = tower_stage(3e-5);
  little.mass_scaling->most = 0.5;
  CHECK(tower_refusal(little).find("must be at most 0.5 times") != std::string::npos);
  // With scaling of chosen bodies the others keep their masses.
  StageOptions one = tower_stage(3e-5);
  one.mass_scaling->bodies = {1};
  CHECK(tower_refusal(one).find("whose masses are not scaled") != std::string::npos);
}

}  // namespace
}  // namespace trilith::testing
