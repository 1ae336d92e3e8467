// Run-time checks of a run: elements strained beyond their solid's limit, energy and speed without a source, rest not
// reached; and the text of the verdict.
#include "run/watch.hpp"
#include "run/element_stretch.hpp"

#include "near.hpp"
#include "physics/space/solids.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double young = 1e7;

/// A square of 1 m that stands on its two lower nodes; at rest `push` would compress it by this share.
Simulation<2> pressed_square(double push, double limit) {
  Material soft = elastic("soft", 2400, young, 0);
  soft.solid->strain_limit = limit;
  BodySpec spec = grid_body("q", box(0, 0, 1, 1), "soft", 1, 1);
  spec.supports.push_back({{0, 0}, {1, 0}, {Support::fixed, Support::fixed}});
  spec.load = {0, -2 * push * young};  // distributed like the mass: its upper half acts
  return Simulation(alone(soft, spec));
}

struct Told {
  StageReport report;
  std::vector<Event> events;
  [[nodiscard]] const Event* find(EventType type) const {
    for (const Event& e : events)
      if (e.type == type) return &e;
    return nullptr;
  }
};

Told run_told(Simulation<2>& sim, StageOptions options, RunListener<2> listener = {}) {
  Told told;
  listener.on_event = [&](const Event& e, const Instant<2>&) { told.events.push_back(e); };
  told.report = sim.run(options, listener);
  return told;
}

StageOptions calm_stage(double duration) {
  StageOptions options;
  options.name = "press";
  options.duration = duration;
  options.rest_share = 0.8;
  return options;
}

/// A block of 1 m in empty space.
Model<2> lone_block(double speed) {
  ModelBuilder builder;
  builder.gravity = Vec2::Zero();
  builder.add_material({"stone", 2000});
  BodySpec spec;
  spec.name = "block", spec.outline = box(0, 0, 1, 1), spec.material = "stone", spec.floating = true;
  spec.velocity = {speed, 0};
  builder.add_body(spec);
  return builder.build();
}

StageOptions plain_stage(double duration, double dt) {
  StageOptions options;
  options.name = "flight";
  options.duration = duration;
  options.dt = dt;
  return options;
}

}  // namespace

TEST_CASE("the stretch of an element follows its deformation gradient and does not depend on rotation") {
  const Model<2> model = alone(elastic("soft", 2000, young, 0.2), grid_body("q", box(0, 0, 2, 1), "soft", 1, 1));
  const auto stretched = [&](const Eigen::Matrix2d& gradient) {
    State<2> state = initial_state(model);
    for (Vec2& x : state.position) x = gradient * x;
    double room = unbounded;
    return worst_element(model, state, room);
  };
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(2.3).toRotationMatrix();
  const auto diagonal = [](double a, double b) { return Eigen::Matrix2d{{a, 0}, {0, b}}; };
  CHECK(near_zero(stretched(turn).strain, 1e-12));
  CHECK(near(stretched(turn * diagonal(1.3, 0.9)).strain, 0.3, 1e-12));
  CHECK(near(stretched(turn * diagonal(1.3, 0.6)).strain, -0.4, 1e-12));
  CHECK(stretched(turn * diagonal(1, 0.51)).spare > 0);
  CHECK(stretched(turn * diagonal(1, 0.49)).spare < 0);
  CHECK(near(stretched(diagonal(1, -0.2)).strain, -1.2, 1e-12));  // a mirror image, which no rotation reverses
}

TEST_CASE("an element strained beyond the limit of its solid ends the stage as diverged") {
  for (const double side : {1.0, -1.0}) {
    Simulation<2> held = pressed_square(0.35 * side, 0.5), crushed = pressed_square(0.55 * side, 0.5);
    CHECK(run_told(held, calm_stage(1)).report.end == StageEnd::time);
    CHECK(held.verdict().sound());
    StageOptions fine = calm_stage(1);
    fine.dt = 1e-4;  // so that the limit is met to one or two percent
    const Told told = run_told(crushed, fine);
    REQUIRE(told.report.end == StageEnd::diverged);
    CHECK(told.report.ended < 1);
    const Event* const strained = told.find(EventType::element_overstrained);
    REQUIRE(strained != nullptr);
    CHECK(strained->body_a == 0);
    CHECK(near(strained->value, -0.5 * side, 0.02));
    CHECK(told.report.reason.find("element 1 of q was") == 0);
    CHECK_FALSE(crushed.verdict().sound());
    CHECK(crushed.verdict().sound_until() < told.report.ended);
    CHECK(crushed.verdict().text().find("element 1 of q") != std::string::npos);
    CHECK_THROWS_AS(crushed.run(calm_stage(1)), InputError);
  }
  Simulation<2> rubber = pressed_square(0.55, 0.9);
  CHECK(run_told(rubber, calm_stage(1)).report.end == StageEnd::time);
}

TEST_CASE("an inverted element is found for any strain limit") {
  Simulation<2> crushed = pressed_square(5, 100);
  StageOptions fine = calm_stage(1);
  fine.dt = 1e-4;  // so that it is found before it has moved far
  const Told told = run_told(crushed, fine);
  REQUIRE(told.report.end == StageEnd::diverged);
  CHECK(told.find(EventType::element_overstrained)->value <= -1);
  for (const Vec2& x : crushed.state().position) CHECK(x.y() > -0.1);
}

TEST_CASE("unexplained energy ends the stage as diverged and names the fastest body") {
  const auto run_with = [](double factor, bool watched) {
    Simulation<2> sim(lone_block(3));
    RunListener<2> listener;
    listener.change_model = [&, done = false](Model<2>& model) mutable {
      if (done || sim.state().step < 50) return false;
      model.mass[0] *= factor;  // at its current speed this creates energy
      return done = true;
    };
    StageOptions options = plain_stage(1, 1e-2);
    options.watched = watched;
    return run_told(sim, options, listener).report;
  };
  const StageReport made = run_with(2.5, true);
  CHECK(made.end == StageEnd::diverged);
  CHECK(made.reason.find("block is fastest") != std::string::npos);
  CHECK(made.sound_until <= 0.51);
  CHECK(run_with(1.5, true).end == StageEnd::time);
  CHECK(run_with(2.5, false).end == StageEnd::time);
}

TEST_CASE("a high speed from the start or a motion is accepted, a supersonic speed from a load is not") {
  Simulation<2> shot(lone_block(2e4));
  StageOptions options = plain_stage(2e-3, 1e-5);
  CHECK(run_told(shot, options).report.end == StageEnd::time);
  const auto pushed = [&](double force) {
    Model<2> model = lone_block(0);
    model.load[0] = {force, 0};
    Simulation<2> sim(std::move(model));
    return run_told(sim, plain_stage(0.01, 1e-5)).report;
  };
  CHECK(pushed(0.9 * 2000 * 5000 / 0.01).end == StageEnd::time);
  const StageReport fast = pushed(1.1 * 2000 * 5000 / 0.01);
  CHECK(fast.end == StageEnd::diverged);
  CHECK(fast.reason.find("sound") != std::string::npos);
}

TEST_CASE("a body released by a moving support keeps its velocity without an error") {
  Model<2> model = lone_block(0);
  const auto motion = std::make_shared<GroundMotion>(std::vector<double>{0, 0}, 10.0, MotionStart{4, 0});
  for (const int k : {1, 2}) set_support(model, 0, k, Support::fixed);
  set_drive(model, 0, 0, motion, 0, model.start_position[0].x());
  Simulation<2> sim(std::move(model));
  RunListener<2> listener;
  listener.change_model = [&](Model<2>& m) {
    if (sim.state().step != 20) return false;
    set_support(m, 0, 0, Support::free);
    return true;
  };
  CHECK(run_told(sim, plain_stage(1, 1e-2), listener).report.end == StageEnd::time);
  CHECK(near(sim.state().velocity[0].x(), 4, 1e-6));
}

TEST_CASE("a consolidation without rest names the worst body, and its run is not valid") {
  const auto settle_for = [](double duration, bool must) {
    testing::Scene scene(Frictional{1e8, 4e7, 0.6, 2e-3});
    scene.fixed("ground", box(-3, -1, 3, 0));
    scene.block("lower", box(-0.5, 0, 0.5, 0.5), 1000);
    scene.block("upper", box(-0.5, 0.5, 0.5, 1), 1000);
    Simulation<2> sim = scene.start();
    StageOptions options = calm_stage(duration);
    options.until_rest = true;
    options.still_ratio = 1e-5;
    options.must_rest = must;
    const Told told = run_told(sim, options);
    return std::tuple(told, sim.verdict());
  };
  const auto [hasty, verdict] = settle_for(0.05, true);
  CHECK(hasty.report.end == StageEnd::not_at_rest);
  const Event* const unsettled = hasty.find(EventType::stage_unsettled);
  REQUIRE(unsettled != nullptr);
  CHECK(unsettled->body_a >= 1);
  CHECK(hasty.report.reason.find("er is worst") != std::string::npos);  // lower or upper
  CHECK(verdict.has(EventType::stage_unsettled));
  const auto [quiet, accepted] = settle_for(0.05, false);
  CHECK(quiet.report.end == StageEnd::not_at_rest);
  CHECK(accepted.sound());
  const auto [whole, sound] = settle_for(20, true);
  CHECK(whole.report.end == StageEnd::rest);
  CHECK(sound.sound());
}

TEST_CASE("an excessive rotation within a step ends the stage without delay") {
  Scene scene(Frictional{1e8, 5e7, 0.5, 1e-3});
  scene.fixed("base", box(-3, -0.5, 3, 0));
  BodySpec low;
  low.name = "low", low.outline = box(-0.5, 0, 0.5, 0.5), low.spin = 1e22;
  scene.add(low);
  Simulation<2> sim(scene.builder.build());
  StageOptions stage;
  stage.duration = 0.004;
  CHECK(sim.run(stage).end == StageEnd::diverged);
}
