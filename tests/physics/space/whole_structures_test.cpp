// Steps and modes of whole structures: energy over a thousand periods, a wall that vibrates at its frequency, an arch
// near its limit by long implicit steps.
#include <algorithm>
#include <cmath>

#include "build/plane/arch.hpp"
#include "integrate/implicit/implicit_step.hpp"
#include "modal/modes.hpp"
#include "near.hpp"
#include "physics/masonry_scene.hpp"
#include "physics/members/frames.hpp"
#include "physics/members/implicit.hpp"

namespace trilith::testing {
namespace {

TEST_CASE("undamped average acceleration keeps the energy of an elastic frame over 1000 periods") {
  BodySpec spec;
  spec.name = "portal", spec.kind = BodyKind::frame, spec.material = "steel", spec.floating = true;
  FrameSpec frame;
  frame.joints = {{.name = "a", .place = {0, 0}, .support = held},
                  {.name = "b", .place = {0, 3}},
                  {.name = "c", .place = {4, 3}},
                  {.name = "d", .place = {4, 0}, .support = held}};
  FrameMember member;
  member.section = rectangle_section(0.2, 0.2), member.divisions = 1;
  for (const int i : {0, 1, 2}) member.from = i, member.to = i + 1, frame.members.push_back(member);
  spec.frame = frame;
  Model<2> model = of_frames(elastic_material("steel", 7850, 2.1e11), {spec});
  const double period = 1 / modes(model, initial_state(model), 1)[0].frequency();
  // A sway of a few hundredths of a millimetre: the scheme conserves the energy of linear motion.
  for (int n = 0; n < model.nodes(); ++n)
    if (model.moves(n)) model.start_velocity[n] = {1e-4, 0};
  Simulation<2> sim(model);
  const double begun = implicit_kinetic(model, sim.state());
  double most = 0, least = 1e300;
  sim.run(implicit_stage(AlphaMethod::hht(0), 1000 * period, period / 20), each_step([&](const Instant<2>& now) {
            const double held_now = implicit_kinetic(now.model, now.state) + now.work.element_stored;
            most = std::max(most, held_now), least = std::min(least, held_now);
          }));
  MESSAGE(
      fmt::format("energy from {:.3e} below to {:.3e} above what it began with", 1 - least / begun, most / begun - 1));
  CHECK(near(most, begun, 1e-6));
  CHECK(near(least, begun, 1e-6));
}

TEST_CASE("a bonded wall swings at the frequency of its first mode") {
  // Eight courses of four bricks in running bond, whose joints stay closed during the small vibration.
  Scene scene(Bonded{.kn = 1e9, .ks = 4e8, .mu = 0.6, .beta = 0, .cohesion = 1e9, .tension = 1e9});
  scene.set_gravity({0, 0});
  scene.fixed("base", box(-1, -1, 3, 0));
  for (int course = 0; course < 8; ++course)
    for (int i = 0; i < 4 + course % 2; ++i) {
      const double from = std::max(0.0, 0.4 * i - (course % 2) * 0.2),
                   to = std::min(1.6, 0.4 * (i + 1) - (course % 2) * 0.2);
      scene.block(fmt::format("b{}.{}", course, i), box(from, 0.2 * course, to, 0.2 * (course + 1)),
                  2000 * (to - from) * 0.2);
    }
  Simulation<2> sim = scene.start();
  sim.refresh();
  Model<2> model = sim.model();
  const Mode first = modes(model, sim.state(), 1)[0];
  const double period = 1 / first.frequency();
  double most = 0;
  for (const Vec2& v : first.displacement) most = std::max(most, v.norm());
  for (int n = 0; n < model.nodes(); ++n)
    model.start_velocity[n] = 1e-4 / most * first.displacement[n],
    model.start_spin[n] = 1e-4 / most * first.rotation[n];
  Simulation<2> swings(model);
  const int top = node_of(model, "b7.2");
  const double side = first.displacement[top].x() > 0 ? 1 : -1;
  std::vector<double> passes;
  double last = 0, before = 0;
  StageOptions stage;
  stage.duration = 10.3 * period;
  swings.run(stage, each_step([&](const Instant<2>& now) {
               const double x = side * (now.state.position[top].x() - model.start_position[top].x());
               if (last < 0 && x >= 0) passes.push_back(before + (now.state.time - before) * -last / (x - last));
               last = x, before = now.state.time;
             }));
  REQUIRE(passes.size() == 10);
  const double counted = 9 / (passes.back() - passes.front());
  MESSAGE(fmt::format("first mode {:.4f} Hz, counted {:.4f} Hz", first.frequency(), counted));
  CHECK(near(counted, first.frequency(), 0.002));
}

/// A semicircular arch with t/R = 0.15 under gravity tilted to `share` of its limit (A6).
Model<2> leaning_arch(double share) {
  Arch arch;
  arch.voussoirs = 20, arch.thickness = .15, arch.half_angle = 90 * degree, arch.sub_edges = 2;
  const double kn = 4e12, mass = 2400 * 0.15 * M_PI / 20, tilt = share * std::atan(.1445);
  Scene scene(Frictional{kn, 0.5 * kn, 2, 0.4 / std::sqrt(kn * 0.15 / mass)});
  scene.set_gravity({standard_gravity * std::sin(tilt), -standard_gravity * std::cos(tilt)});
  add_parts(scene, build_arch(arch), "abutments");
  return scene.builder.build();
}

TEST_CASE(
    "an arch at 0.97 of its limit tilt has the same state with explicit steps and implicit ones twenty times as long") {
  const Model<2> model = leaning_arch(0.97);
  const int crown = node_of(model, "v10");
  std::array<Vec2, 2> way{};
  std::array<double, 2> longest{};
  for (const int i : {0, 1}) {
    Simulation<2> sim(model);
    StageOptions stage;
    stage.duration = 0.15;
    if (i == 1) stage = adaptive_stage(AlphaMethod::hht(-0.05), 0.15, 20 * longest[0]);
    const StageReport report = sim.run(stage);
    CHECK(report.end == StageEnd::time);
    longest[i] = report.longest_dt;
    way[i] = sim.state().position[crown] - model.start_position[crown];
    MESSAGE(fmt::format("crown by {:.4e} and {:.4e} m in {} steps of {:.2e} s at most", way[i].x(), way[i].y(),
                        report.steps, report.longest_dt));
  }
  CHECK((way[1] - way[0]).norm() < 0.02 * way[0].norm());
}

}  // namespace
}  // namespace trilith::testing
