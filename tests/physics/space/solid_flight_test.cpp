// VALIDATION T27 to T29, T36 (T30: scripts/verification/space/flight.lua), and random colliding solids: impacts
// conserve energy and momenta.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "build/block_list.hpp"
#include "geometry/space/convex_hull.hpp"
#include "near.hpp"
#include "physics/space/solid_bodies.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Two solids that fly towards each other without weight, friction or damping.
SolidRun collision(std::mt19937_64& bits, double dt) {
  SpaceBuilder builder;
  const auto shape = [&] {
    return random_count(bits, 0, 2) == 0 ? random_prism(bits, 0.5, 1.2) : random_convex_solid(bits, {.smallest = 1});
  };
  SolidBody a = stone("a", shape()), b = stone("b", placed(shape(), {}, Vec3(2.5, 0, 0) + 0.3 * random_in_ball(bits)));
  a.velocity = Vec3(1, 0, 0) + 0.3 * random_in_ball(bits), b.velocity = Vec3(-1, 0, 0) + 0.3 * random_in_ball(bits);
  a.spin = 2 * random_in_ball(bits), b.spin = 2 * random_in_ball(bits);
  builder.add(a), builder.add(b);
  builder.contact(0, 0, frictional(1e9, 0, 0), "glassy");
  return {builder.build(), dt};
}

/// Random pairs until `count` have collided; returns the deepest penetration [m].
double strike_by_chance(int count, unsigned seed) {
  std::mt19937_64 bits(seed);
  int struck = 0;
  double deepest = 0;
  while (struck < count) {
    SolidRun run = collision(bits, 2e-5);
    const double energy = run.moving_energy();
    const Vec3 momentum = run.momentum(), turning = run.angular_momentum();
    bool touched = false;
    run.run_until(2.5, [&] {
      for (const GeneralContact<3>& g : run.work().general_touching)
        touched = true, deepest = std::max(deepest, g.depth);
      return touched && run.work().general_touching.empty();
    });
    if (!touched) continue;
    ++struck;
    REQUIRE(run.work().general_touching.empty());
    CHECK(near(run.moving_energy(), energy, 1e-2));
    CHECK((run.momentum() - momentum).norm() < 1e-9 * run.model().mass[0]);
    CHECK((run.angular_momentum() - turning).norm() < 1e-9 * run.model().mass[0]);
    // If two bodies passed through each other, their positions would be exchanged.
    CHECK(run.shared_volume() == 0);
  }
  return deepest;
}

/// T36: the 27 stones of the list, which fly towards each other.
SolidRun flying_stones(const Frictional& law) {
  SpaceBuilder builder;
  builder.gravity(Vec3::Zero());
  int count = 0;
  for (const FlyingBlock& block : flying_blocks("polyhedra27.json")) {
    SolidBody body = stone("stone " + std::to_string(count++), convex_hull(block.corners, "stone"), 1000);
    body.velocity = block.velocity, body.spin = block.spin;
    builder.add(body);
  }
  builder.contact(0, 0, law, "joint");
  return {builder.build(), 2e-5};
}

/// Runs until all bodies have met and separated; returns the deepest penetration [m].
double fly_apart(SolidRun& run) {
  double deepest = 0;
  run.run_until(4, [&] {
    for (const GeneralContact<3>& g : run.work().general_touching) deepest = std::max(deepest, g.depth);
    return run.time() > 1.5 && run.work().general_touching.empty();
  });
  CHECK(run.work().general_touching.empty());
  CHECK(run.shared_volume() == 0);
  return deepest;
}

}  // namespace

TEST_CASE("corners of a solid move with its node, and the largest speed is the speed of the fastest corner") {
  SpaceBuilder builder;
  SolidBody body = stone("box", box_at({0.4, 0.6, 1}, {1, 2, 3}));
  body.velocity = {-1, 0, 2}, body.spin = {0.5, -2, 1};
  builder.add(body);
  builder.gravity(Vec3::Zero());
  SolidRun run(builder.build(), 1e-3);
  run.run(0.01);
  const PlacedSolid& placed = run.work().solids.placed[0];
  const Turn3 turn(run.state().rotation[0]);
  double fastest = 0;
  for (std::size_t c = 0; c < placed.corners.size(); ++c) {
    const Vec3 arm = turn.apply(run.model().piece_solid[0].shape.corners[c]);
    CHECK((placed.corners[c] - run.place(0) - arm).norm() < 1e-14);
    fastest = std::max(fastest, (run.velocity(0) + cross(run.spin(0), arm)).norm());
  }
  CHECK(placed.corners.size() == 8);
  CHECK(near(run.work().fastest, fastest, 1e-13));
  CHECK(near(run.work().fastest_moving, fastest, 1e-13));
}

TEST_CASE("two random solids that collide conserve energy and momenta and do not pass through each other") {
  const double deepest = strike_by_chance(150, 2026);
  CHECK(deepest < 0.1);
  MESSAGE("deepest overlap " << deepest << " m");
}

TEST_CASE("2,000 random pairs of solids conserve energy and momenta and do not pass through each other" *
          doctest::test_suite("long")) {
  const double deepest = strike_by_chance(2000, 20261125);
  CHECK(deepest < 0.1);
  MESSAGE("deepest overlap " << deepest << " m");
}

TEST_CASE("T27: two bars collide edge on edge") {
  for (const UnitQuaternion& world : {UnitQuaternion{}, rotation_by({1.1, 0.4, -0.7})}) {
    const Turn3 turn(world);
    const double diagonal = 0.1 / std::sqrt(2.0);
    SpaceBuilder builder;
    const Polyhedron bar_x = box_at(Vec3(1, 0.1, 0.1), Vec3::Zero(), rotation_by({radians(45), 0, 0}));
    const Polyhedron bar_y =
        box_at(Vec3(0.1, 1, 0.1), Vec3(0.3, 0.2, 2 * diagonal + 0.01), rotation_by({0, radians(45), 0}));
    builder.add(stone("a", placed(bar_x, world, Vec3::Zero()), 1000));
    SolidBody b = stone("b", placed(bar_y, world, Vec3::Zero()), 1000);
    b.velocity = turn.apply(Vec3(0, 0, -1));
    builder.add(b);
    builder.contact(0, 0, frictional(5e13, 0, 0), "edges");
    SolidRun run(builder.build(), 5e-8);
    double begun = -1;
    REQUIRE(run.run_until(0.02, [&] {
      const bool touching = !run.work().general_touching.empty();
      if (touching && begun < 0) begun = run.time();
      return begun >= 0 && !touching;
    }));
    CHECK(run.time() - begun < 2e-3);
    const Vec3 va = turn.undo(run.velocity(0)), vb = turn.undo(run.velocity(1)), wa = turn.undo(run.spin(0)),
               wb = turn.undo(run.spin(1));
    CHECK(near(va.z(), -0.56425, 1e-2));
    CHECK(near(vb.z(), -0.43575, 1e-2));
    CHECK(near(wa.y(), 2.01117, 1e-2));
    CHECK(near(wb.x(), -1.34078, 1e-2));
    CHECK(near(run.moving_energy(), 5, 1e-2));
  }
}

TEST_CASE("T28: a bar dropped on its edge leaves with the speed and spin of its impulse") {
  SpaceBuilder builder;
  builder.gravity(Vec3(0, 0, -standard_gravity));
  builder.add(fixed_stone("floor", box_solid(Vec3(-3, -3, -0.5), Vec3(3, 3, 0))));
  builder.add(stone("bar", box_at(Vec3(1, 0.3, 0.2), Vec3(0, 0, 1.5), rotation_by({0, radians(20), 0}))));
  builder.contact(0, 0, frictional(1e12, 0, 0), "smooth");
  SolidRun run(builder.build(), 1e-6);
  REQUIRE(run.run_until(1, [&] { return !run.work().general_touching.empty(); }));
  CHECK(near(run.time(), 0.50187, 1e-3));
  CHECK(near(run.velocity(1).norm(), 4.92167, 1e-3));
  const GeneralContact<3>& touch = run.work().general_touching[0];
  CHECK(near(std::abs(touch.centre.x() - run.place(1).x()), 0.43564, 1e-3));
  REQUIRE(run.run_until(0.1, [&] { return run.work().general_touching.empty(); }));
  CHECK(near(run.velocity(1).z(), -1.83583, 1e-2));
  CHECK(near(run.spin(1).norm(), 15.5115, 1e-2));
}

TEST_CASE("T29: a spinning cube first touches with the exact corner, place and speed") {
  SpaceBuilder builder;
  builder.gravity(Vec3(0, 0, -standard_gravity));
  builder.add(fixed_stone("floor", box_solid(Vec3(-3, -3, -0.5), Vec3(3, 3, 0))));
  SolidBody cube = stone("cube", box_at(Vec3(0.5, 0.5, 0.5), Vec3(0, 0, 3)));
  cube.spin = Vec3(3, 2, 1);
  builder.add(cube);
  builder.contact(0, 0, frictional(1e9, 0, 0), "smooth");
  SolidRun run(builder.build(), 1e-5);
  REQUIRE(run.run_until(1, [&] { return !run.work().general_touching.empty(); }));
  CHECK(near(run.time(), 0.729214, 1e-3));
  const Vec3 corner = Turn3(run.state().rotation[1]).apply(Vec3(-0.25, -0.25, 0.25));
  const Vec3 at = run.place(1) + corner;
  CHECK(near_zero(at.z(), 1e-3));
  CHECK(near(at.x(), -0.10110, 1e-3));
  CHECK(near(at.y(), -0.15203, 1e-3));
  CHECK(near(run.velocity(1).z() + cross(run.spin(1), corner).z(), -7.40502, 1e-3));
}

TEST_CASE("T36: 27 listed stones conserve mass, momenta and energy through their impacts") {
  const std::vector<FlyingBlock> blocks = flying_blocks("polyhedra27.json");
  REQUIRE(blocks.size() == 27);
  const Vec3 momentum(167.0182, 142.255903, -33.474807), turning(-.952148, 11.106096, 7.611844);
  for (const bool rough : {false, true}) {
    CAPTURE(rough);
    SolidRun run = flying_stones(rough ? frictional(1e9, 5e8, 0.5, 2e-5) : frictional(1e9, 0, 0));
    double mass = 0;
    for (std::size_t i = 0; i < 27; ++i) {
      CHECK(near(run.model().mass[i], blocks[i].mass, 1e-9));
      mass += run.model().mass[i];
    }
    CHECK(near(mass, 916.930629, 1e-9));
    const auto same_momenta = [&] {
      // The list rounds momenta to 1e-6; their drift is checked against rounding below.
      CHECK((run.momentum() - momentum).norm() < 1e-6);
      CHECK((run.angular_momentum() - turning).norm() < 1e-4 * turning.norm());
    };
    same_momenta();
    CHECK(near(run.moving_energy(), 1853.776451, 1e-9));
    const Vec3 begun = run.momentum(), begun_turning = run.angular_momentum();
    const double balance = run.energy().balance();
    const double deepest = fly_apart(run);
    same_momenta();
    CHECK((run.momentum() - begun).norm() < 1e-9 * begun.norm());
    CHECK((run.angular_momentum() - begun_turning).norm() < 1e-9 * begun.norm());
    if (rough)
      CHECK(run.moving_energy() < 0.95 * 1853.776451);
    else
      CHECK(near(run.moving_energy(), 1853.776451, 1e-2));
    CHECK(near_zero(run.energy().balance() - balance, 1e-2 * 1853.776451));
    MESSAGE("T36 " << std::string(rough ? "rough" : "smooth") << ": apart after " << run.time()
                   << " s, energy of motion " << run.moving_energy() << " J, ledger off by "
                   << run.energy().balance() - balance << " J, deepest " << deepest << " m");
  }
}
