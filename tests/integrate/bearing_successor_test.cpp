// A bearing with a successor law that counts displacements from the switch: the switch puts in no energy.
#include <doctest/doctest.h>

#include <cmath>
#include <utility>

#include "assembly/bearing_motion.hpp"
#include "model/io/fingerprint.hpp"
#include "model/io/state_words.hpp"
#include "model/space_builder/solid_model_builder.hpp"
#include "near.hpp"
#include "physics/scene.hpp"
#include "physics/space/solid_bodies.hpp"
#include "run/record/recorded_texts.hpp"

namespace trilith {
namespace {

using testing::box;
using testing::near;
using testing::near_zero;
using testing::Scene;
using testing::SolidRun;

constexpr double soft = 1e4, stiff = 1e6, reach = 0.1, heavy = 2000;  // 50 J in the first spring at its limit

/// A weightless block that pulls a soft spring over its limit, whose successor is a stiff spring; `way`: direction +1
/// or -1.
struct HandedOn {
  Scene scene;
  BearingSpec first, second;

  explicit HandedOn(double way = 1, double turn = 0) : scene(Frictional{1e8, 5e7, 0.4, 0}, turn) {
    scene.builder.set_contact("*", "*", "none");
    scene.set_gravity({0, 0});
    scene.fixed("base", box(0, 0, 1, 1));
    BodySpec block;
    block.name = "block", block.outline = box(2, 0, 3, 1), block.mass = heavy, block.velocity = {way * speed(), 0};
    scene.add(block);
    first.name = "first", first.body_a = "base", first.body_b = "block";
    first.point_a = scene.to_world({1, 0.5}), first.point_b = scene.to_world({2, 0.5}), first.angle = turn;
    first.law[along] = Linear{soft, 0}, first.limit[along] = reach, first.becomes_bearing = "second";
    second = first;
    second.name = "second", second.becomes_bearing.clear(), second.starts_waiting = true;
    second.law[along] = Linear{stiff, 0}, second.limit[along] = unbounded;
  }
  /// Speed of the block at 100 J [m/s].
  static double speed() { return std::sqrt(2 * 100 / heavy); }
  Simulation<2> start(bool from_here) {
    if (from_here) first.next_from_here.fill(true);
    scene.builder.add_bearing(first), scene.builder.add_bearing(second);
    return scene.start();
  }
};

struct Seen {
  double farthest = 0, took_over = 0, dissipated = 0;
  std::vector<double> balance;
};

/// Runs for `duration` [s]: largest displacement of either sign, displacement at the switch, and the ledger.
Seen follow(Simulation<2>& sim, double duration, bool implicitly, double dt) {
  Seen seen;
  StageOptions options;
  options.duration = duration, options.dt = dt, options.energy_interval = dt;
  if (implicitly) options.integrator = AlphaMethod::hht(0);
  RunListener<2> listener = testing::each_step([&](const Instant<2>& now) {
    const double far = bearing_motion(now.model, now.state, 1).displacement[along];
    if (std::abs(far) > std::abs(seen.farthest)) seen.farthest = far;
  });
  listener.on_energy = [&](const Instant<2>&, const Energy& e) {
    seen.balance.push_back(e.balance());
    seen.dissipated = e[EnergyTerm::bearing_failure];
  };
  sim.run(options, listener);
  seen.took_over = sim.state().bearing[1].begun_at[along];
  return seen;
}

TEST_CASE("a stiff spring that counts from its start has the energy left in the block") {
  for (const bool implicitly : {false, true}) {
    HandedOn scene;
    Simulation<2> sim = scene.start(true);
    const Seen seen = follow(sim, 0.6, implicitly, 2e-4);
    CAPTURE(implicitly);
    REQUIRE(sim.state().bearing[0].status == BearingStatus::changed);
    REQUIRE(sim.state().bearing[1].status == BearingStatus::intact);
    // The first law failed within the step that exceeded its limit.
    CHECK(seen.took_over >= reach);
    CHECK(seen.took_over < reach + 2e-4 * HandedOn::speed());
    const double stored = 0.5 * soft * seen.took_over * seen.took_over;
    CHECK(near(seen.farthest - seen.took_over, std::sqrt(2 * (100 - stored) / stiff), 2e-3));
    CHECK(near(seen.dissipated, stored, 1e-3));  // plus the last force over half a step
    CHECK(seen.dissipated >= stored);
    REQUIRE(seen.balance.size() > 20);
    CHECK(near(seen.balance.back(), seen.balance[2], 1e-12));
  }
}

TEST_CASE("a stiff spring that counts from the start adds energy, which the energy balance contains") {
  for (const bool implicitly : {false, true}) {
    HandedOn scene;
    Simulation<2> sim = scene.start(false);
    const Seen seen = follow(sim, 0.6, implicitly, 2e-4);
    CAPTURE(implicitly);
    REQUIRE(sim.state().bearing[0].status == BearingStatus::changed);
    CHECK(seen.took_over == 0);
    CHECK(near(seen.dissipated, 0.5 * (soft - stiff) * reach * reach, 2e-3));
    // The first force of the second law has not worked before: its share of the spring energy is included.
    REQUIRE(seen.balance.size() > 20);
    CHECK(near(seen.balance.back(), seen.balance[2], 1e-10));
  }
}

TEST_CASE("a successor acts the same in both directions and in a rotated frame") {
  const auto farthest = [](double way, double turn) {
    HandedOn scene(way, turn);
    Simulation<2> sim = scene.start(true);
    return follow(sim, 0.5, false, 2e-4).farthest;
  };
  const double there = farthest(1, 0);
  CHECK(there > reach);
  CHECK(near(farthest(-1, 0), -there, 1e-12));
  for (const double turn : {0.4, 2.1}) CHECK(near(farthest(1, turn), there, 1e-9));
}

TEST_CASE(
    "the limit of a successor counts from its start, its events name it, and the next one counts from its given "
    "origin") {
  HandedOn scene;
  BearingSpec third = scene.second;
  third.name = "third", third.law[along] = Linear{1, 0};
  scene.second.law[along] = Linear{10, 0}, scene.second.limit[along] = 0.03;
  scene.second.becomes_bearing = "third";
  scene.scene.builder.add_bearing(third);
  Simulation<2> sim = scene.start(true);
  std::vector<Event> failed;
  RunListener<2> listener;
  listener.on_event = [&](const Event& e, const Instant<2>&) {
    if (e.type == EventType::bearing_failed) failed.push_back(e);
  };
  testing::run_for(sim, 1, 1e-4, listener);
  REQUIRE(failed.size() == 2);
  CHECK(near(failed[0].value, reach, 1e-3));
  CHECK(near(failed[1].value, 0.03, 1e-3));
  const int third_row = 0, second_row = 2;
  REQUIRE(sim.model().bearings[second_row].name == "second");
  CHECK(sim.state().bearing[second_row].begun_at[along] > reach);
  CHECK(is_live(sim.state().bearing[third_row].status));
  CHECK(sim.state().bearing[third_row].begun_at[along] == 0);
}

TEST_CASE("by direction: a successor starts along at the present position and carries the weight as before") {
  const double mass = 1000, weight = mass * standard_gravity, bed = 1e8;
  for (const bool all : {false, true}) {
    Scene scene(Frictional{1e8, 5e7, 0.4, 0});
    scene.builder.set_contact("*", "*", "none");
    scene.fixed("base", box(-2, -0.5, 3, 0));
    BodySpec block;
    block.name = "block", block.outline = box(0, 0, 1, 0.5), block.mass = mass, block.velocity = {1, 0};
    block.support[2] = Support::fixed, block.floating = true;
    scene.add(block);
    BearingSpec first, second;
    first.name = "first", first.body_a = "base", first.body_b = "block", first.point_a = first.point_b = {0.5, 0};
    first.law[along] = Linear{2e5, 0}, first.law[axial] = Linear{bed, 2e5}, first.limit[along] = 0.02;
    second = first;
    second.name = "second", second.starts_waiting = true, second.limit[along] = unbounded;
    first.becomes_bearing = "second";
    first.next_from_here[along] = true, first.next_from_here[axial] = all;
    scene.builder.add_bearing(first), scene.builder.add_bearing(second);
    Simulation<2> sim = scene.start();
    testing::run_for(sim, 0.03, 1e-5);
    REQUIRE(sim.state().bearing[0].status == BearingStatus::changed);
    testing::settle(sim);
    const auto at = bearing_motion(sim.model(), sim.state(), 1).displacement, from = sim.state().bearing[1].begun_at;
    CAPTURE(all);
    CHECK(from[along] > 0.02);
    CHECK(near(at[along], from[along], 1e-6));  // its spring is without force there
    CHECK((from[axial] != 0) == all);
    CHECK(near(at[axial], from[axial] - weight / bed, 1e-3));
  }
}

/// A solid with one free direction, which moves with 100 J from a soft spring to a stiff one.
struct HandedOnInSpace {
  SolidModelBuilder builder;
  BearingSpecOf<3> first, second;
  int free;

  explicit HandedOnInSpace(int direction) : free(direction) {
    builder.gravity = Vec3::Zero();
    SolidSpec base, top;
    base.name = "a", base.pieces = {testing::box_at({1, 1, 1}, {0, 0, 0})}, base.mass = 1,
    base.support.fill(Support::fixed);
    top.name = "b", top.pieces = {testing::box_at({1, 1, 1}, {0, 0, 1.5})}, top.mass = 6 * heavy;  // 2,000 kg m2 too
    top.floating = true, top.support.fill(Support::fixed);
    top.support[static_cast<std::size_t>(free)] = Support::free;
    builder.add_body(base), builder.add_body(top);
    first.name = "first", first.body_a = "a", first.body_b = "b", first.point_a = first.point_b = {0, 0, 0.75};
    const auto k = static_cast<std::size_t>(free);
    first.law[k] = Linear{soft, 0}, first.limit[k] = reach, first.becomes_bearing = "second";
    first.next_from_here.fill(true);
    second = first;
    second.name = "second", second.becomes_bearing.clear(), second.next_from_here = {}, second.starts_waiting = true;
    second.law[k] = Linear{stiff, 0}, second.limit[k] = unbounded;
  }
  Model<3> build() {
    builder.add_bearing(first), builder.add_bearing(second);
    return builder.build();
  }
  /// With 100 J, along x, y, z or about them.
  [[nodiscard]] State<3> moving(const Model<3>& model) const {
    State<3> state = initial_state(model);
    const double inertia = free < 3 ? model.mass[1] : 6 * heavy / 6;
    (free < 3 ? state.velocity[1][free] : state.spin[1][free - 3]) = std::sqrt(2 * 100 / inertia);
    return state;
  }
};

TEST_CASE("a successor in space starts without force in all directions and rotations") {
  for (int direction = 0; direction < 6; ++direction) {
    HandedOnInSpace scene(direction);
    const Model<3> model = scene.build();
    SolidRun run(model, scene.moving(model), 1e-4);
    run.step(), run.step();
    const double begin = run.energy().balance();
    double farthest = 0;
    while (run.time() < 1.2) {
      run.step();
      const auto d = bearing_motion(run.model(), run.state(), 1).displacement[static_cast<std::size_t>(direction)];
      farthest = std::max(farthest, d);
    }
    CAPTURE(direction);
    REQUIRE(run.state().bearing[0].status == BearingStatus::changed);
    const double at = run.state().bearing[1].begun_at[static_cast<std::size_t>(direction)];
    CHECK(near(at, reach, 1e-3));
    CHECK(near(farthest - at, std::sqrt(2 * (100 - 0.5 * soft * at * at) / stiff), 2e-3));
    CHECK(near(run.energy()[EnergyTerm::bearing_failure], 0.5 * soft * at * at, 2e-3));
    CHECK(near(run.energy().balance(), begin, 1e-9));
  }
}

TEST_CASE("a law of both horizontal directions replaces another at any azimuth and returns to that point") {
  for (const double azimuth : {0.0, 0.6, 2.2}) {
    HandedOnInSpace scene(0);
    SolidSpec free_top = scene.builder.bodies()[1];
    SolidModelBuilder builder;
    builder.gravity = Vec3::Zero();
    free_top.support[1] = Support::free;
    builder.add_body(scene.builder.bodies()[0]), builder.add_body(free_top);
    for (BearingSpecOf<3>* spec : {&scene.first, &scene.second}) {
      spec->horizontal = std::exchange(spec->law[0], std::monostate{});
      spec->horizontal_limit = std::exchange(spec->limit[0], unbounded);
      builder.add_bearing(*spec);
    }
    const Model<3> model = builder.build();
    State<3> state = initial_state(model);
    const Vec3 way(std::cos(azimuth), std::sin(azimuth), 0);
    state.velocity[1] = std::sqrt(2 * 100 / (6 * heavy)) * way;
    SolidRun run(model, state, 1e-4);
    REQUIRE(run.run_until(2, [&] { return is_live(run.state().bearing[1].status); }));
    const auto at = run.state().bearing[1].begun_at;
    CHECK(near(Vec3(at[0], at[1], 0).dot(way), reach, 1e-3));
    double farthest = 0;
    while (run.time() < 2) {
      run.step();
      farthest = std::max(farthest, (run.place(1) - model.start_position[1]).dot(way));
    }
    CHECK(near(farthest - reach, std::sqrt(2 * 50 / stiff), 1e-2));
    CHECK(near_zero((run.place(1) - model.start_position[1]).cross(way).norm(), 1e-12));
  }
}

TEST_CASE("a state saved after a bearing took over continues with the same bits") {
  HandedOnInSpace scene(4);
  const Model<3> model = scene.build();
  SolidRun run(model, scene.moving(model), 1e-4);
  REQUIRE(run.run_until(1, [&] { return is_live(run.state().bearing[1].status); }));
  run.run(0.01);
  SolidRun again(model, state_from_words(model, state_words(run.state()), "checkpoint"), 1e-4);
  CHECK(again.state().bearing[1].begun_at == run.state().bearing[1].begun_at);
  run.run(0.05), again.run(0.05);
  CHECK(state_hash(again.state()) == state_hash(run.state()));

  HandedOn flat;
  Simulation<2> sim = flat.start(true);
  testing::run_for(sim, 0.4, 2e-4);
  REQUIRE(is_live(sim.state().bearing[1].status));
  const State<2> read = state_from_words(sim.model(), state_words(sim.state()), "checkpoint");
  CHECK(read.bearing[1].begun_at == sim.state().bearing[1].begun_at);
  CHECK(state_hash(read) == state_hash(sim.state()));
}

TEST_CASE("a model whose successors count from their start has another fingerprint") {
  HandedOn plain, from_here;
  Simulation<2> a = plain.start(false), b = from_here.start(true);
  CHECK(state_words(a.state()) == state_words(b.state()));
  CHECK_FALSE(model_fingerprint(a.model()) == model_fingerprint(b.model()));
  CHECK(bearing_text(a.model(), a.model().bearings[0]).ends_with("; becomes bearing second"));
  CHECK(bearing_text(b.model(), b.model().bearings[0]).ends_with("; becomes bearing second from here"));
  Bearing<2> along_alone = b.model().bearings[0];
  along_alone.next_from_here = {true, false, false};
  CHECK(bearing_text(b.model(), along_alone).ends_with("; becomes bearing second from here along"));
}

}  // namespace
}  // namespace trilith
