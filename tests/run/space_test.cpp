// Runs of solids in space: stages, rest, events, steps, and readings.
#include <doctest/doctest.h>

#include <filesystem>
#include <numbers>

#include "base/error.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "model/space_builder/solid_model_builder.hpp"
#include "near.hpp"
#include "physics/space/solid_bodies.hpp"
#include "results/reading/reader.hpp"
#include "run/record/recording.hpp"
#include "run/simulation.hpp"

namespace trilith::testing {
namespace {

SolidSpec solid(const std::string& name, const Polyhedron& shape) {
  SolidSpec spec;
  spec.name = name, spec.pieces = {shape}, spec.material = "stone";
  return spec;
}

SolidModelBuilder on_ground(const ContactLaw& law) {
  SolidModelBuilder builder;
  Material stone;
  stone.name = "stone", stone.density = 2400;
  builder.add_material(stone);
  builder.add_law("dry", law);
  builder.set_contact("stone", "stone", "dry");
  SolidSpec ground = solid("ground", box_at({6, 6, 1}, {0, 0, -0.5}));
  ground.support.fill(Support::fixed);
  builder.add_body(ground);
  return builder;
}

/// Two courses of bricks, the upper one over the joints of the lower.
SolidModelBuilder small_wall() {
  SolidModelBuilder builder = on_ground(frictional(1e9, 4e8, 0.6, 1e-5));
  for (int i = 0; i < 3; ++i)
    builder.add_body(solid("low " + std::to_string(i), box_at({0.4, 0.2, 0.2}, {0.4 * i, 0, 0.1})));
  for (int i = 0; i < 2; ++i)
    builder.add_body(solid("high " + std::to_string(i), box_at({0.4, 0.2, 0.2}, {0.2 + 0.4 * i, 0, 0.3})));
  return builder;
}

StageOptions stage(double duration) {
  StageOptions options;
  options.name = "stage", options.duration = duration;
  return options;
}

TEST_CASE("a block on a joint has a stable step that its highest frequency allows") {
  // Highest frequency of the block on Kn 1e9, Ks 4e8 Pa/m: 116.919 Hz (rocking and swaying), so 2 / w = 2.7226 ms.
  SolidModelBuilder builder = on_ground(frictional(1e9, 4e8, 0.6));
  builder.add_body(solid("block", box_at({0.4, 0.4, 1.2}, {0, 0, 0.6 - 1e-6})));
  builder.overlap_allowed = 1e-3;
  Simulation<3> sim(builder.build());
  sim.refresh();
  const StableStep step = stable_step(sim.model(), sim.state(), sim.work());
  const double allowed = 2 / (2 * std::numbers::pi * 116.919);
  CHECK(step.body == 1);
  // Its stiffest face governs, a side of 0.4 m by 1.2 m against a moving body: 2 kn A / m = 2.0833e6. Rocking about its
  // short side has 0.9 of it with the shear; the bound is at most a quarter above the largest.
  CHECK(step.dt <= allowed);
  CHECK(step.dt <= 2 / std::sqrt(2.0833e6));
  CHECK(step.dt >= 2 / std::sqrt(1.25 * 1.2 * 2.0833e6));
}

TEST_CASE("solids in space consolidate to rest under their weight") {
  Simulation<3> sim(small_wall().build());
  StageOptions options = stage(20);
  options.until_rest = true, options.rest_share = 0.8, options.still_ratio = 1e-5;
  int made = 0, at_rest = 0;
  RunListener<3> listener;
  listener.on_event = [&](const Event& e, const Instant<3>&) {
    made += e.type == EventType::contact_made ? 1 : 0, at_rest += e.type == EventType::body_at_rest ? 1 : 0;
  };
  const StageReport report = sim.run(options, listener);
  CHECK(report.end == StageEnd::rest);
  CHECK(made >= 7);
  sim.run(stage(1), listener);  // each is reported at rest after half a second without motion
  CHECK(at_rest == 5);
  // A course carries its own weight and the weight above it, with a penetration of m g / (kn A) for each.
  const double weight = 2400 * 0.4 * 0.2 * 0.2 * standard_gravity, below = 5.0 / 3 * weight / (1e9 * 0.4 * 0.2);
  double sunk = 0;
  for (int b = 1; b <= 3; ++b) sunk += (0.1 - sim.state().position[static_cast<std::size_t>(b)].z()) / 3;
  CHECK(near(sunk, below, 1e-4));
}

TEST_CASE("a run in space continues with the same bits from a snapshot, and after its scratch memory is freed") {
  SolidModelBuilder builder = small_wall();
  builder.gravity = tilted_gravity(0.7, 0.3);
  Simulation<3> whole(builder.build()), dropped(builder.build());
  whole.run(stage(0.4));
  const Snapshot<3> taken = whole.snapshot();
  whole.run(stage(0.3));
  const std::uint64_t end = state_hash(whole.state());
  whole.restore(taken);
  whole.run(stage(0.3));
  CHECK(state_hash(whole.state()) == end);
  RunListener<3> drops;
  drops.at_border = [&] { dropped.drop_work(); };
  dropped.run(stage(0.4), drops);
  dropped.run(stage(0.3), drops);
  CHECK(state_hash(dropped.state()) == end);
}

TEST_CASE("a body in space that leaves the bounds is deactivated, and the energy balance stays closed") {
  SolidModelBuilder builder = on_ground(frictional(1e9, 4e8, 0.2, 1e-5));
  SolidSpec block = solid("block", box_at({0.2, 0.2, 0.2}, {2.5, 0, 0.1}));
  block.velocity = {3, 0, 0};
  builder.add_body(block);
  builder.bounds.low.z() = -4;
  Simulation<3> sim(builder.build());
  Event left;
  RunListener<3> listener;
  double first = 0, last = 0;
  listener.on_energy = [&](const Instant<3>& now, const Energy& e) {
    (now.state.time == 0 ? first : last) = e.balance();
  };
  listener.on_event = [&](const Event& e, const Instant<3>&) {
    if (e.type == EventType::body_left) left = e;
  };
  StageOptions options = stage(5);
  options.energy_interval = 0.1;
  CHECK(sim.run(options, listener).end == StageEnd::all_left);
  CHECK(left.body_a == 1);
  CHECK(left.z < -4);
  CHECK(std::abs(last - first) < 1e-3 * 19.2 * standard_gravity * 4);
}

TEST_CASE("a fast thin stone in space does not pass through another undetected") {
  SolidModelBuilder builder = on_ground(frictional(2e10, 4e8, 0.2));
  SolidSpec stone = solid("stone", box_at({0.3, 0.3, 0.02}, {0, 0, 2}));
  stone.velocity = {0, 0, -60}, stone.floating = true;
  builder.add_body(stone);
  SolidSpec tile = solid("tile", box_at({0.5, 0.5, 0.01}, {0, 0, 0.5}));
  tile.support.fill(Support::fixed);
  builder.add_body(tile);
  builder.gravity = Vec3::Zero();
  Simulation<3> sim(builder.build());
  sim.run(stage(0.1));
  CHECK(sim.state().position[1].z() > 0.5);
  CHECK(sim.state().velocity[1].z() > 0);
}

TEST_CASE("a deep penetration in space is reported once") {
  SolidModelBuilder builder = on_ground(frictional(1e4, 1e4, 0.2));
  SolidSpec block = solid("block", box_at({0.2, 0.2, 0.2}, {0, 0, 0.1}));
  block.load = {0, 0, -1000};
  builder.add_body(block);
  Simulation<3> sim(builder.build());
  int told = 0;
  RunListener<3> listener;
  listener.on_event = [&](const Event& e, const Instant<3>&) { told += e.type == EventType::body_passed ? 1 : 0; };
  sim.run(stage(1), listener);
  CHECK(told == 1);
  CHECK_FALSE(sim.verdict().sound());
}

TEST_CASE("overlapping and unsupported solids are rejected by name") {
  SolidModelBuilder deep = small_wall();
  deep.add_body(solid("deep", box_at({0.4, 0.2, 0.2}, {0.1, 0, 0.25})));
  CHECK_THROWS_WITH_AS(deep.build(), doctest::Contains("'deep' overlap by"), InputError);
  SolidModelBuilder high = small_wall();
  high.add_body(solid("high up", box_at({0.4, 0.2, 0.2}, {0, 0, 3})));
  CHECK_THROWS_WITH_AS(high.build(), doctest::Contains("'high up' has no support"), InputError);
  SolidModelBuilder unknown = small_wall();
  unknown.set_contact("stone", "brick", "dry");
  CHECK_THROWS_WITH_AS(unknown.build(), doctest::Contains("no material, group or body 'brick'"), InputError);
}

TEST_CASE("a recording of a run in space is read back unchanged") {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "trilith_space_test.h5";
  Simulation<3> sim(small_wall().build());
  {
    Recording<3> recording(path, sim.model(), sim.state());
    StageOptions options = stage(0.2);
    options.frame_interval = 0.05, options.energy_interval = 0.05;
    sim.run(options, recording.listener());
    recording.finish();
  }
  const results::ResultsReader reader(path);
  CHECK(reader.header().dim == 3);
  CHECK(reader.header().bodies.size() == 6);
  CHECK(reader.header().face_count() == 36);
  const results::Frame last = reader.frame(reader.frame_count() - 1);
  for (std::size_t b = 0; b < 6; ++b)
    for (int k = 0; k < 3; ++k) CHECK(last.position[3 * b + static_cast<std::size_t>(k)] == sim.state().position[b][k]);
  CHECK(last.contacts.size() >= 7);  // head joints may touch without force
  double carried = 0;
  for (const results::ContactForce& c : last.contacts)
    if (c.body_a == 0) carried += -c.force[2];
  CHECK(near(carried, 5 * 2400 * 0.016 * standard_gravity, 0.5));
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace trilith::testing
