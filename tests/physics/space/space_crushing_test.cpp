// Mortar in space that crushes under moving blocks, in joints and in contacts of any shape: stopping distance,
// compressed toes, energy ledger, saved history.
#include <unistd.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "assembly/start.hpp"
#include "model/io/checkpoint.hpp"
#include "near.hpp"
#include "physics/space/solid_bodies.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double bed_stiffness = 1e10;  // [Pa/m]

/// Mortar with almost no bond strength, so that crushing alone acts.
Cohesive weak_mortar(double compression, double depth, double beta = 0) {
  Cohesive law;
  law.kn = bed_stiffness, law.ks = 0.5 * bed_stiffness, law.mu = 0.7, law.beta = beta;
  law.cohesion = law.tension = 1e3, law.energy_tension = law.energy_shear = 1e-2;
  law.compression = compression, law.crushing_depth = depth;
  return law;
}

/// A block of 1 m by 1 m by 0.5 m and 1000 kg that lands on a floor, all in a rotated world.
Model<3> falling_block(const Cohesive& law, double gap, double speed, const UnitQuaternion& world) {
  SpaceBuilder builder;
  const Turn3 turn(world);
  builder.gravity(turn.apply(Vec3(0, 0, -standard_gravity)));
  const auto put = [&](const Vec3& sides, const Vec3& at) { return placed(box_at(sides, at), world, Vec3::Zero()); };
  builder.add(fixed_stone("base", put(Vec3(4, 4, 1), Vec3(0, 0, -0.5))));
  SolidBody block = stone("block", put(Vec3(1, 1, 0.5), Vec3(0, 0, 0.25 + gap)), 2000);
  block.velocity = turn.apply(Vec3(0, 0, -speed));
  builder.add(block);
  builder.contact(0, 0, law, "mortar");
  return builder.build();
}

double depth_of(const State<3>& state) {
  double most = 0;
  for (const SolidMemory& m : state.contacts.memory) most = std::max(most, m.crushed);
  for (const JointMemory& j : state.contacts.joint) most = std::max(most, j.most_crushed());
  return most;
}

/// A block that rotates while it lands and slides over mortar that it crushes.
Model<3> tumbling_block(const Vec3& turn) {
  SpaceBuilder builder;
  builder.gravity(Vec3(0, 0, -standard_gravity));
  builder.add(fixed_stone("base", box_at(Vec3(8, 8, 1), Vec3(0, 0, -0.5))));
  SolidBody block = stone("block", box_at(Vec3(0.6, 0.8, 1.0), Vec3(0, 0, 0.9), rotation_by(turn)), 1700);
  block.velocity = Vec3(1.5, 0.4, -1);
  builder.add(block);
  builder.contact(0, 0, weak_mortar(5e5, 4e-3, 2e-6), "mortar");
  return builder.build();
}

}  // namespace

TEST_CASE("a solid that falls on mortar too weak to stop it sinks in by its energy over the strength") {
  // The depth is so small that the border strip of the block, which is closer to its sides than the depth, is
  // negligible (about 0.1 % of the area).
  const double strength = 2e5, mass = 1000, speed = 0.5, gap = 1e-3;
  for (const UnitQuaternion& world : {UnitQuaternion{}, rotation_by({0.4, -1.2, 0.7})}) {
    const Model<3> model = falling_block(weak_mortar(strength, 0.05), gap, speed, world);
    SolidRun run(model, 1e-5);
    const double begun = run.energy().balance();
    run.run(0.2);
    const double resist = strength - mass * standard_gravity, elastic = strength / bed_stiffness;
    const double v2 = speed * speed + 2 * standard_gravity * gap;
    const double depth = (0.5 * mass * v2 + mass * standard_gravity * elastic - 0.5 * strength * elastic) / resist;
    CHECK(near(run.energy()[EnergyTerm::contact_fracture], strength * depth, 2e-3));
    CHECK(near(depth_of(run.state()), depth, 2e-3));
    CHECK(near_zero(run.energy().balance() - begun, 1e-3 * 0.5 * mass * v2));
    const double low = Turn3(world).undo(run.place(1)).z() - 0.25;
    CHECK(low > -depth - 2 * elastic);
    const double rebound = 0.5 * strength * elastic / (mass * standard_gravity);  // rebound by the elastic penetration
    CHECK(low < -depth + rebound);
  }
}

TEST_CASE("a solid pressed into crushing mortar settles as far as one that falls on it") {
  // Bonded from the start; the impact is the block's own velocity.
  const double strength = 2e5, mass = 1000, speed = 2;
  const Model<3> model = falling_block(weak_mortar(strength, 0.05), 0, speed, {});
  SolidRun run(model, start_state(model), 1e-5);
  const double begun = run.energy().balance();
  run.run(0.05);
  const double resist = strength - mass * standard_gravity, depth = 0.5 * mass * speed * speed / resist;
  CHECK(near(depth_of(run.state()), depth, 5e-3));
  CHECK(near_zero(run.energy().balance() - begun, 1e-3 * 0.5 * mass * speed * speed));
}

TEST_CASE("a crushing toe makes a tilted solid topple earlier, by a third of the length that carries its weight") {
  const double width = 0.4, depth = 0.5, height = 1.2, density = 1000 / (width * depth * height), mass = 1000;
  for (const double azimuth : {0.0, 90.0}) {
    const double across = azimuth == 0 ? width : depth, along = azimuth == 0 ? depth : width;
    for (const double share : {0.05, 0.10}) {
      const double strength = mass * standard_gravity / (share * across * along), upright = std::atan(across / height);
      SpaceBuilder builder;
      builder.add(fixed_stone("base", box_at(Vec3(3, 3, 1), Vec3(0, 0, -0.5))));
      builder.add(stone("block", box_at(Vec3(width, depth, height), Vec3(0, 0, height / 2)), density));
      builder.contact(0, 0, weak_mortar(strength, 5e-3, 2e-5), "mortar");
      builder.gravity(Vec3(0, 0, -standard_gravity));
      SolidRun run(builder.build(), 2e-5);
      run.run(0.1);
      const double rate = radians(2), from = 0.75 * upright, begun = run.time();
      const double settling = 0.3;  // time to reach the first tilt before it grows [s]
      double tilt = 0;
      const bool topples = run.run_until(settling + 0.4 * upright / rate, [&] {
        const double t = run.time() - begun;
        tilt = from * std::min(1.0, t / settling) + rate * std::max(0.0, t - settling);
        run.model().gravity.field = tilted_gravity(tilt, radians(azimuth));
        return run.velocity(1).norm() > 0.05;
      });
      REQUIRE(topples);
      const double expected = (across - 2 * share * across * std::cos(upright) / 3) / height;
      MESSAGE("pressed on ", share, " of the width: topples at ", std::tan(tilt), ", by the law ", expected,
              ", without crushing ", across / height);
      CHECK(near(std::tan(tilt), expected, 0.03));
      CHECK(std::tan(tilt) < across / height);
    }
  }
}

TEST_CASE("a solid that tumbles over mortar it crushes creates no energy, whatever shapes meet") {
  for (const Vec3& turn :
       {Vec3(0, 0, 0.3), Vec3(0.003, -0.002, 0), Vec3(0.02, 0.01, 0.5), Vec3(0.4, 0.3, -0.2), Vec3(1.1, -0.6, 0.3)}) {
    CAPTURE(turn);
    SolidRun run(tumbling_block(turn), 1e-5);
    const double begun = run.energy().balance(), weight = run.model().mass[1] * standard_gravity;
    double worst = 0;
    for (int i = 0; i < 12; ++i) run.run(0.1), worst = std::max(worst, std::abs(run.energy().balance() - begun));
    const double turned_over = weight * 0.9 + 0.5 * run.model().mass[1] * 3.41;
    MESSAGE("residual ", 100 * worst / turned_over, " %, crushing took ", run.energy()[EnergyTerm::contact_fracture],
            " J of ", turned_over);
    CHECK(run.energy()[EnergyTerm::contact_fracture] > 0);
    CHECK(depth_of(run.state()) > 0);
    CHECK(worst < 0.002 * turned_over);
    CHECK(run.place(1).z() > 0.25);
  }
}

TEST_CASE("mortar in space stays crushed while the block that crushed it bounces, and has the same bits continued") {
  const Model<3> model = falling_block(weak_mortar(2e5, 0.01), 1e-3, 1, {});
  SolidRun run(model, 1e-5), dropped(model, 1e-5);
  run.run(0.02), dropped.run(0.02);
  const double depth = depth_of(run.state());
  REQUIRE(depth > 0);
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("crushed" + std::to_string(::getpid()) + ".state");
  save_state(run.state(), model, path);
  SolidRun rest(model, load_state(model, path), 1e-5);
  std::filesystem::remove(path);
  for (int i = 0; i < 100; ++i) {
    run.run(5e-4), rest.run(5e-4), dropped.run(5e-4);
    dropped.drop_work();
    REQUIRE(state_hash(rest.state()) == state_hash(run.state()));
    REQUIRE(state_hash(dropped.state()) == state_hash(run.state()));
    REQUIRE(depth_of(run.state()) >= depth);
  }
}

TEST_CASE("mortar set again between crushed solids is intact, and the crushing is kept") {
  const Model<3> model = falling_block(weak_mortar(2e5, 0.05, 1e-4), 1e-3, 1, {});
  SolidRun run(model, 1e-5);
  run.run(0.5);
  const double depth = depth_of(run.state());
  REQUIRE(depth > 1e-4);
  State<3> state = run.state();
  set_bonds(model, state, 1e-2);
  REQUIRE(state.contacts.joint.size() == 1);
  CHECK(state.contacts.joint[0].most_crushed() == 0);
  CHECK(depth_of(state) == depth);
  SolidRun set(model, state, 1e-5);
  const double begun = set.energy().balance();
  const Vec3 place = set.place(1);
  set.run(0.1);
  CHECK((set.place(1) - place).norm() < 1e-6);
  CHECK(near_zero(set.energy().balance() - begun, 1e-4));
  State<3> lifted = set.state();
  lift_bonds(model, lifted);
  SolidRun loose(model, lifted, 1e-5);
  loose.run(0.1);
  CHECK((loose.place(1) - place).norm() < 1e-6);
}
