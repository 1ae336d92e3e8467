// Stages without a given integrator: implicit steps while they are cheaper, otherwise explicit ones.
#include "near.hpp"
#include "physics/members/implicit.hpp"

namespace trilith::testing {
namespace {

/// A block released 0.2 m above its base, with damping at its faces.
Simulation<2> falling_block() {
  Scene scene(Frictional{1e11, 5e10, 0.6, 2e-5});
  scene.fixed("base", box(-2, -1, 2, 0));
  BodySpec block;
  block.name = "block", block.outline = box(-0.5, 0.2, 0.5, 0.7), block.mass = 1000, block.floating = true;
  scene.add(block);
  return scene.start();
}

/// The damping force jumps at an impact; the residual of this is proportional to the explicit step.
constexpr double fine_steps = 0.1;

StageOptions open_stage(double duration) {
  StageOptions stage = adaptive_stage(AlphaMethod::hht(-0.05), duration, 0.005);
  stage.may_change = true;
  stage.safety = fine_steps;
  return stage;
}

struct Seen {
  std::vector<Event> changes;
  std::int64_t implicit = 0;  ///< steps
  StageReport report;
};

Seen watch(Simulation<2>& sim, const StageOptions& stage) {
  Seen out;
  RunListener<2> listener;
  listener.on_event = [&](const Event& e, const Instant<2>&) {
    if (e.type == EventType::integrator_changed) out.changes.push_back(e);
  };
  listener.on_step = [&](const Instant<2>& now) { out.implicit += now.state.implicit() ? 1 : 0; };
  out.report = sim.run(stage, listener);
  return out;
}

double residual_of(Simulation<2>& sim) {
  sim.refresh();
  const Energy energy = sim.energy();
  return energy.balance();
}

}  // namespace

TEST_CASE("with an automatic integrator a block falls and rests in implicit steps and strikes in explicit ones") {
  Simulation<2> open = falling_block(), plain = falling_block();
  const int n = node_of(open.model(), "block");
  const Seen seen = watch(open, open_stage(2));
  StageOptions explicitly;
  explicitly.duration = 2, explicitly.safety = fine_steps;
  const StageReport report = plain.run(explicitly, {});
  CHECK(seen.report.end == StageEnd::time);
  REQUIRE(seen.changes.size() >= 2);
  // The first change is due to the impact, after the free fall of 0.2 m.
  CHECK(near(seen.changes[0].time, std::sqrt(2 * 0.2 / standard_gravity), 0.02));
  CHECK(seen.changes[0].text.find("explicit") != std::string::npos);
  CHECK(seen.changes[1].text.find("implicit") != std::string::npos);
  CHECK(seen.implicit > 0);
  CHECK(seen.report.steps < report.steps);
  CHECK(open.state().implicit());  // it is at rest
  CHECK(near(open.state().position[n].y(), plain.state().position[n].y(), 1e-8));
  CHECK(near_zero(residual_of(open), 0.01 * 1000 * standard_gravity * 0.2));
}

TEST_CASE("a stage that leaves the integrator open is continued with the same bits") {
  Simulation<2> whole = falling_block();
  whole.run(open_stage(0.25), {});
  Simulation<2> rest(whole.model(), whole.state());
  for (Simulation<2>* sim : {&whole, &rest}) sim->run(open_stage(0.6), {});
  CHECK(state_hash(whole.state()) == state_hash(rest.state()));
}

TEST_CASE("explicit steps are used throughout if implicit steps may not be longer") {
  Simulation<2> open = falling_block();
  StageOptions stage = open_stage(0.5);
  stage.dt = 1e-4;
  const Seen seen = watch(open, stage);
  CHECK(seen.implicit <= 1);
  CHECK(seen.changes.size() == 1);
}

}  // namespace trilith::testing
