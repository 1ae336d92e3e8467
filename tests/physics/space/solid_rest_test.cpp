// VALIDATION T1, T3, T9, T12, T14: solids that rest and start to slide. Limits of tipping, rolling and of a corbel are
// in scripts/verification/space (standing.lua, wedges.lua).
#include <doctest/doctest.h>

#include <cmath>

#include "near.hpp"
#include "physics/space/solid_bodies.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

Polyhedron floor_slab() {
  return box_solid(Vec3(-3, -3, -0.5), Vec3(3, 3, 0));
}

/// A block on the floor, in a world rotated by `world`, under gravity tilted by `angle` towards `azimuth` [rad].
struct Slope {
  Vec3 sides;
  double mu, angle, azimuth = 0, kn = 1e9, beta = 2e-4;
  UnitQuaternion world = {};

  [[nodiscard]] SolidRun run(double dt) const {
    SpaceBuilder builder;
    builder.gravity(Turn3(world).apply(tilted_gravity(angle, azimuth)));
    builder.add(fixed_stone("floor", placed(floor_slab(), world, Vec3::Zero())));
    const double sunk = 2000 * sides.z() * standard_gravity * std::cos(angle) / kn;
    builder.add(stone("block", placed(box_at(sides, Vec3(0, 0, sides.z() / 2 - sunk)), world, Vec3::Zero())));
    builder.contact(0, 0, frictional(kn, kn, mu, beta), "joint");
    return {builder.build(), dt};
  }
  [[nodiscard]] Vec3 downhill() const { return Turn3(world).apply(Vec3(std::cos(azimuth), std::sin(azimuth), 0)); }
};

}  // namespace

TEST_CASE("T1: a cube slides down an incline that is turned about any axis") {
  for (const UnitQuaternion& world : {UnitQuaternion{}, rotation_by({0.3, -1.2, 2.1}), rotation_by({-2, 0.4, 0.1})}) {
    const Slope slope{Vec3(0.5, 0.5, 0.5), 0.3, radians(25), 0.7, 1e9, 2e-4, world};
    SolidRun run = slope.run(2e-5);
    run.run(0.2);
    const Vec3 early = run.velocity(1);
    run.run(0.2);
    const Vec3 gained = (run.velocity(1) - early) / 0.2;
    CHECK(near(gained.dot(slope.downhill()), standard_gravity * (std::sin(slope.angle) - 0.3 * std::cos(slope.angle)),
               5e-3));
    CHECK(near_zero((gained - gained.dot(slope.downhill()) * slope.downhill()).norm(), 5e-3));
  }
}

TEST_CASE("T3: a cube dropped flat from 1 m lands at the exact time and rests at the overlap of its weight") {
  SpaceBuilder builder;
  builder.gravity(Vec3(0, 0, -standard_gravity));
  builder.add(fixed_stone("floor", floor_slab()));
  builder.add(stone("cube", box_at(Vec3(1, 1, 1), Vec3(0, 0, 1.5)), 1000));
  builder.contact(0, 0, frictional(1e8, 1e8, 0.5, 5e-4), "joint");
  SolidRun run(builder.build(), 2e-5);
  REQUIRE(run.run_until(1, [&] { return !run.work().general_touching.empty(); }));
  CHECK(near(run.time(), 0.45160, 1e-3));
  CHECK(near(run.velocity(1).norm(), 4.42869, 1e-3));
  run.run(6);
  CHECK(near(-(run.place(1).z() - 0.5), 1000 * standard_gravity / 1e8, 5e-3));
  CHECK(run.velocity(1).norm() < run.model().still_speed);
  const Energy energy = run.energy();
  CHECK(near_zero(energy.balance(), 5e-3 * 1000 * standard_gravity));
}

TEST_CASE("a cube at rest stays at rest, without vibration, tilt or rotation") {
  SpaceBuilder builder;
  builder.gravity(Vec3(0, 0, -standard_gravity));
  builder.add(fixed_stone("floor", floor_slab()));
  const double sunk = 1000 * 0.1 * standard_gravity / 1e8;
  builder.add(stone("cube", box_at(Vec3(0.1, 0.1, 0.1), Vec3(0.013, 0.027, 0.05 - sunk)), 1000));
  builder.contact(0, 0, frictional(1e8, 1e8, 0.5, 1e-4), "joint");
  SolidRun run(builder.build(), 1e-4);
  const Vec3 before = run.place(1);
  run.run(10);
  CHECK(run.turned(1).norm() < 1e-9);
  CHECK((run.place(1) - before).norm() < 1e-9);
}

TEST_CASE("T9: a table of four feet spreads its load as a rigid plate does") {
  // A slab with four legs, one body; a block that belongs to it moves its weight off the middle.
  const auto feet = [](double ex, double ey) {
    SpaceBuilder builder;
    builder.gravity(Vec3(0, 0, -standard_gravity));
    builder.add(fixed_stone("floor", floor_slab()));
    SolidBody table;
    table.name = "table", table.density = 1e-3;  // negligible: the load is the weight
    table.pieces.push_back(box_solid(Vec3(-0.6, -0.5, 0.5), Vec3(0.6, 0.5, 0.6)));
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.4, 0.4})
        table.pieces.push_back(box_solid(Vec3(x - 0.02, y - 0.02, 0), Vec3(x + 0.02, y + 0.02, 0.5)));
    builder.add(table);
    builder.contact(0, 0, frictional(1e11, 1e11, 0.5, 1e-3), "joint");
    Model<3> model = builder.build();
    // A mass of 10 kN / g at (ex, ey, 0.55) with some inertia: the body's centroid is moved to it.
    const Vec3 shift = Vec3(ex, ey, 0.55) - model.start_position[1];
    const Vec3 own = Turn3(model.start_rotation[1]).undo(shift);
    model.start_position[1] += shift;
    for (int s = model.bodies[1].first_skin; s < model.bodies[1].first_skin + model.bodies[1].skins; ++s)
      model.skin_place[static_cast<std::size_t>(s)] -= own;
    for (int p = 1; p < model.pieces(); ++p)
      for (Vec3& corner : model.piece_solid[static_cast<std::size_t>(p)].shape.corners) corner -= own;
    model.mass[1] = 10e3 / standard_gravity, model.inertia[1] = Vec3::Constant(200);
    SolidRun run(model, 1e-4);
    run.run(3);
    std::array<double, 4> force{};
    for (const GeneralContact<3>& g : run.work().general_touching)
      force[(g.centre.x() > 0 ? 1U : 0U) + (g.centre.y() > 0 ? 2U : 0U)] += g.force.z();
    return force;
  };
  const auto even = feet(0.2, 0.08);
  CHECK(near(even[3], 4000, 5e-3));
  CHECK(near(even[1], 3000, 5e-3));
  CHECK(near(even[2], 2000, 5e-3));
  CHECK(near(even[0], 1000, 5e-3));
  const auto lifted = feet(0.375, 0.2);
  CHECK(near(lifted[3], 6250, 5e-3));
  CHECK(near(lifted[1], 2500, 5e-3));
  CHECK(near(lifted[2], 1250, 5e-3));
  CHECK(lifted[0] == 0);
}

TEST_CASE("T12: friction is a circle") {
  for (const double azimuth : {0.0, 22.5, 45.0, 17.0}) {
    for (const double off : {-0.1, 0.1}) {
      const Slope slope{Vec3(0.4, 0.4, 0.2), 0.4, radians(21.801 + off), radians(azimuth)};
      SolidRun run = slope.run(2e-5);
      run.run(0.6);
      if (off < 0)
        CHECK(run.velocity(1).norm() < 1e-4);
      else
        CHECK(run.velocity(1).dot(slope.downhill()) > 0.003);  // g (sin - mu cos) 0.6 s is 0.011 m/s
    }
  }
}

TEST_CASE("T14: a wedge in a groove feels friction over the sine of half its angle") {
  for (const auto& [half_angle, expected] :
       {std::pair(45.0, 2.05398), std::pair(30.0, 0.29373), std::pair(60.0, 2.83380)}) {
    const double w = radians(half_angle), s = std::sin(w), c = std::cos(w), psi = radians(40), kn = 1e10;
    SpaceBuilder builder;
    builder.gravity(standard_gravity * Vec3(0, std::sin(psi), -std::cos(psi)));
    for (const double side : {-1.0, 1.0}) {
      const std::vector<Vec3> bank{Vec3(0, -1, 0), Vec3(side * s, -1, c), Vec3(side * (s + 0.5 * c), -1, c - 0.5 * s),
                                   Vec3(side * 0.5 * c, -1, -0.5 * s)};
      builder.add(fixed_stone(side < 0 ? "left" : "right", extrusion(bank, Vec3(0, 3, 0))));
    }
    const double h = 0.3;
    const std::vector<Vec3> wedge{Vec3(0, 0, 0), Vec3(h * s / c, 0, h), Vec3(-h * s / c, 0, h)};
    builder.add(stone("wedge", extrusion(wedge, Vec3(0, 0.4, 0))));
    builder.contact(0, 0, frictional(kn, kn, 0.4, 1e-4), "joint");
    SolidRun run(builder.build(), 1e-5);
    run.run(0.1);
    const double early = run.velocity(2).y();
    run.run(0.2);
    CHECK(near((run.velocity(2).y() - early) / 0.2, expected, 5e-3));
  }
}
