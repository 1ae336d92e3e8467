// Bodies that leave the bounds: reported, removed from the step, in the ledger, and still removed after a restart.
#include <fmt/format.h>

#include "integrate/explicit/central_difference.hpp"
#include "model/bounds.hpp"
#include "model/io/checkpoint.hpp"
#include "near.hpp"
#include "physics/scene.hpp"
#include "results/sample_run.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double bottom = -3, drop = 3;  // y of the bounds, fall height of the body's centre to them [m]

/// A block that lies on its ground, and one that falls past it.
Scene two_blocks() {
  Scene scene(Frictional{1e8, 4e7, 0.6, 2e-3});
  scene.builder.bounds.low.y() = bottom;
  scene.fixed("ground", box(-3, -1, 3, 0));
  scene.block("stays", box(-0.5, 0, 0.5, 0.5), 1000);
  BodySpec falls;
  falls.name = "falls", falls.outline = box(5, -0.25, 6, 0.25), falls.mass = 1000, falls.floating = true;
  scene.add(falls);
  return scene;
}

StageOptions stage(double duration) {
  StageOptions options;
  options.duration = duration;
  options.dt = 1e-3;
  return options;
}

double balance(const Simulation<2>& sim) {
  State<2> state = sim.state();
  Work<2> work = sim.work();
  return energy_now(sim.model(), state, work, {state.last_dt, {}}).balance();
}

struct Left {
  std::vector<Event> events;
  RunListener<2> listener() {
    RunListener<2> out;
    out.on_event = [this](const Event& e, const Instant<2>&) { events.push_back(e); };
    return out;
  }
  [[nodiscard]] std::vector<Event> of(EventType type) const {
    std::vector<Event> found;
    for (const Event& e : events)
      if (e.type == type) found.push_back(e);
    return found;
  }
};

}  // namespace

TEST_CASE(
    "a body that leaves the bounds is reported with its speed and stopped, and the energy balance has its energy") {
  Scene scene = two_blocks();
  Simulation<2> sim = scene.start();
  sim.refresh();
  const double begun = balance(sim);
  Left left;
  CHECK(sim.run(stage(1.5), left.listener()).end == StageEnd::time);
  const std::vector<Event> told = left.of(EventType::body_left);
  REQUIRE(told.size() == 1);
  const double speed = std::sqrt(2 * standard_gravity * drop);
  CHECK(told[0].body_a == 2);
  CHECK(near(told[0].value, speed, 2e-3));
  CHECK(near(told[0].time, speed / standard_gravity, 2e-3));
  CHECK(near(told[0].y, bottom, 5e-3));
  CHECK(told[0].y < bottom);
  const int n = node_of(sim.model(), "falls");
  CHECK(sim.state().position[n].y() == told[0].y);
  CHECK(sim.state().velocity[n].norm() == 0);
  const double taken = sim.state().given[EnergyTerm::left_bounds];
  CHECK(near(taken, 0.5 * 1000 * speed * speed, 5e-3));
  sim.refresh();
  CHECK(std::abs(balance(sim) - begun) < 1e-5 * taken);
  CHECK(sim.verdict().left() == 1);
  CHECK(sim.verdict().sound());
}

TEST_CASE("bodies within the bounds have the same bits whether or not another body departed") {
  Scene tight = two_blocks(), wide = two_blocks();
  wide.builder.bounds = {};
  Simulation<2> one = tight.start(), other = wide.start();
  one.run(stage(1.5));
  other.run(stage(1.5));
  CHECK(one.verdict().left() == 1);
  CHECK(other.verdict().left() == 0);
  const int n = node_of(one.model(), "stays");
  CHECK(one.state().position[n] == other.state().position[n]);
  CHECK(one.state().velocity[n] == other.state().velocity[n]);
  CHECK(one.state().rotation[n] == other.state().rotation[n]);
}

TEST_CASE("a departed body has no contact, and a stage ends when all bodies have departed") {
  Scene scene(Frictional{1e8, 4e7, 0.6, 2e-3});
  scene.builder.bounds.low.y() = bottom;
  for (const double y : {0.0, 4.0}) {  // the second falls through the first one's position
    BodySpec falls;
    falls.name = y > 0 ? "second" : "first", falls.outline = box(0, y - 0.25, 1, y + 0.25), falls.floating = true;
    scene.add(falls);
  }
  Simulation<2> sim = scene.start();
  Left left;
  const StageReport report = sim.run(stage(10), left.listener());
  CHECK(report.end == StageEnd::all_left);
  CHECK(report.reason.find("bounds") != std::string::npos);
  CHECK(near(report.ended, std::sqrt(2 * (4 + drop) / standard_gravity), 2e-3));
  CHECK(left.of(EventType::body_left).size() == 2);
  CHECK(left.of(EventType::impact).empty());
  CHECK(left.of(EventType::contact_made).empty());
  CHECK(sim.run(stage(1)).end == StageEnd::all_left);
}

TEST_CASE("a restart in a rebuilt model keeps departed bodies out and continues with the same bits") {
  const testing::Folder folder;
  Scene scene = two_blocks();
  Simulation<2> straight = scene.start();
  straight.run(stage(1));
  REQUIRE(straight.verdict().left() == 1);
  save_state(straight.state(), straight.model(), folder / "left");
  const Model<2> fresh = two_blocks().builder.build();
  Simulation again(fresh, load_state(fresh, folder / "left"));
  CHECK(state_hash(again.state()) == state_hash(straight.state()));
  straight.run(stage(0.5));
  again.run(stage(0.5));
  CHECK(state_hash(again.state()) == state_hash(straight.state()));
  // A body released by name stays removed too.
  again.edit([](Model<2>& model) {
    for (const int k : {0, 1, 2}) set_support(model, 2, k, Support::free);
  });
  again.run(stage(0.1));
  CHECK(again.state().velocity[node_of(fresh, "falls")].norm() == 0);
}

TEST_CASE("the bearings of a body that leaves fail because of it and the energy balance closes") {
  Scene scene = two_blocks();
  BearingSpec spring;
  spring.name = "spring", spring.body_a = "stays", spring.body_b = "falls";
  spring.point_a = {0, 0.25}, spring.point_b = {5.5, 0};
  spring.law[axial] = Linear{100, 0};
  scene.builder.add_bearing(spring);
  Simulation<2> sim = scene.start();
  sim.refresh();
  const double begun = balance(sim);
  Left left;
  sim.run(stage(1.5), left.listener());
  const std::vector<Event> failed = left.of(EventType::bearing_failed), out = left.of(EventType::body_left);
  REQUIRE(failed.size() == 1);
  REQUIRE(out.size() == 1);
  CHECK(failed[0].cause == out[0].id);
  CHECK(sim.state().bearing[0].status == BearingStatus::failed);
  sim.refresh();
  CHECK(std::abs(balance(sim) - begun) < 1e-5 * sim.state().given[EnergyTerm::left_bounds]);
}

TEST_CASE("the default bounds lie at ten times the initial extent of the bodies") {
  const Model<2> model = [] {
    ModelBuilder builder;
    builder.add_material({"stone", 2000});
    for (const double x : {0.0, 30.0}) {
      BodySpec spec;
      spec.name = fmt::format("b{:g}", x), spec.outline = box(x, 0, x + 2, 1), spec.material = "stone";
      spec.support = held;
      builder.add_body(spec);
    }
    builder.bounds.high.y() = 7;
    return builder.build();
  }();
  CHECK(near(model.bounds.low.x(), -320, 1e-12));
  CHECK(near(model.bounds.low.y(), -320, 1e-12));
  CHECK(near(model.bounds.high.x(), 352, 1e-12));
  CHECK(model.bounds.high.y() == 7);
  Model<2> other = model;
  CHECK_THROWS_AS(set_bounds(other, {{0, 8}, {1, 7}}), InputError);
}
