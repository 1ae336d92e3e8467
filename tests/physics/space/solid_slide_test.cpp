// VALIDATION T23 to T26: friction in a plane with free direction; the position of the pressure resultant.
#include <doctest/doctest.h>

#include <cmath>

#include "near.hpp"
#include "physics/space/solid_bodies.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// A block on the floor that rests under its own weight, its base at z = 0.
SolidRun block_on_floor(const Vec3& sides, double mu, const Vec3& gravity, const Vec3& velocity, double spin, double dt,
                        double kn = 1e9) {
  SpaceBuilder builder;
  builder.gravity(gravity);
  builder.add(fixed_stone("floor", box_solid(Vec3(-5, -5, -0.5), Vec3(5, 5, 0))));
  const double sunk = -2000 * sides.z() * gravity.z() / kn;
  SolidBody block = stone("block", box_at(sides, Vec3(0, 0, sides.z() / 2 - sunk)));
  block.velocity = velocity, block.spin = Vec3(0, 0, spin);
  builder.add(block);
  builder.contact(0, 0, frictional(kn, kn, mu, 1e-5), "joint");
  return {builder.build(), dt};
}

const Vec3 down(0, 0, -standard_gravity);

/// Follows the block on an accelerated base: in the frame of the base, gravity is tilted against the acceleration.
void shake(SolidRun& run, double dt, double seconds, const std::function<Vec3(double)>& base,
           const std::function<void()>& each) {
  const auto steps = static_cast<int>(std::lround(seconds / dt));
  for (int i = 0; i < steps; ++i) {
    run.model().gravity.field = down - base(run.time());
    run.step();
    each();
  }
}

}  // namespace

TEST_CASE("T23: the path of a block kicked across a slope turns downwards") {
  const Vec3 gravity = tilted_gravity(radians(30), 0);
  struct Row {
    double mu, time, across, downhill;
  };
  for (const Row& r :
       {Row{std::tan(radians(30)), 0.25, 0.35309, 0.11863}, Row{std::tan(radians(30)), 0.5, 0.48611, 0.34908},
        Row{std::tan(radians(30)), 1, 0.53886, 0.84706}, Row{0.4, 1, 0.86198, 1.40453},
        Row{0.7, 1.2, 0.40536, 0.43392}}) {
    SolidRun run = block_on_floor(Vec3(0.1, 0.1, 0.01), r.mu, gravity, Vec3(0, 2, 0), 0, 1e-5);
    run.run(r.time);
    CHECK(near(run.place(1).y(), r.across, 5e-3));
    CHECK(near(run.place(1).x(), r.downhill, 5e-3));
    if (r.mu == 0.7) CHECK(run.velocity(1).norm() < 1e-3);
  }
}

TEST_CASE("T24: on a base that moves on a circle the block slides on a smaller circle") {
  struct Row {
    double share, mu, radius, speed;
  };
  const double period = 1, w = 2 * std::numbers::pi / period;
  for (const Row& r : {Row{0.5, 0.3, 0.099362, 0.62431}, Row{0.6, 0.5, 0.082387, 0}}) {
    const double dt = 5e-5;
    // The base starts with the velocity (0, -A g / w): relative to it the block moves with the opposite velocity.
    SolidRun run = block_on_floor(Vec3(0.1, 0.1, 0.01), r.mu, down, Vec3(0, r.share * standard_gravity / w, 0), 0, dt);
    const auto base = [&](double t) {
      return Vec3(r.share * standard_gravity * Vec3(std::cos(w * t), std::sin(w * t), 0));
    };
    shake(run, dt, 10, base, [] {});
    Vec3 low = run.place(1), high = low;
    double speed = 0;
    int count = 0;
    shake(run, dt, 2, base, [&] {
      low = low.cwiseMin(run.place(1)), high = high.cwiseMax(run.place(1));
      speed += run.velocity(1).norm(), ++count;
    });
    CHECK(near(0.25 * ((high - low).x() + (high - low).y()), r.radius, 5e-3));
    if (r.speed > 0) CHECK(near(speed / count, r.speed, 5e-3));
  }
}

TEST_CASE("T25: a pulse in two directions moves the block by the path of a circle's friction") {
  const double dt = 2e-5;
  SolidRun run = block_on_floor(Vec3(0.1, 0.1, 0.01), 0.25, down, Vec3::Zero(), 0, dt);
  const auto base = [](double t) {
    if (t > 1) return Vec3(Vec3::Zero());
    return Vec3(standard_gravity *
                Vec3(0.4 * std::sin(2 * std::numbers::pi * t), 0.3 * std::sin(4 * std::numbers::pi * t), 0));
  };
  double most = 0;
  shake(run, dt, 2.5, base, [&] { most = std::max(most, run.place(1).head<2>().norm()); });
  CHECK(near(most, 0.12284, 1e-2));
  CHECK(near_zero(std::abs(run.place(1).x()) - 0.0041, 2e-3));
  CHECK(near_zero(std::abs(run.place(1).y()) - 0.0585, 2e-3));
}

TEST_CASE("T26: a plate that spins is stopped by friction spread over its area") {
  SolidRun run = block_on_floor(Vec3(0.4, 0.4, 0.01), 0.3, down, Vec3::Zero(), 10, 1e-5);
  run.run(0.1);
  const double early = run.spin(1).z();
  run.run(0.2);
  CHECK(near((early - run.spin(1).z()) / 0.2, 16.884, 2e-2));
  run.run(0.2);
  REQUIRE(run.run_until(0.3, [&] { return run.spin(1).z() < 1e-3; }));
  CHECK(near(run.time(), 0.59228, 2e-2));
  CHECK(near(run.turned(1).z(), 2.9614, 2e-2));
}

TEST_CASE("T26: sliding and spinning of a plate stop at the same time") {
  SolidRun run = block_on_floor(Vec3(0.4, 0.4, 0.01), 0.3, down, Vec3(1, 0, 0), 5, 1e-5);
  REQUIRE(run.run_until(1, [&] { return run.velocity(1).norm() < 1e-3 && run.spin(1).norm() < 1e-2; }));
  CHECK(near(run.time(), 0.4808, 2e-2));
  CHECK(near(run.place(1).x(), 0.2301, 2e-2));
  CHECK(run.place(1).x() > 0.1700 * 1.2);  // it slides farther than a block that does not spin
}

TEST_CASE("a body that is heavier on one side slides straight and stops where friction stops it") {
  const double mu = 0.3, dt = 1e-5, kn = 1e9;
  SpaceBuilder builder;
  builder.gravity(down);
  builder.add(fixed_stone("floor", box_solid(Vec3(-5, -5, -0.5), Vec3(5, 5, 0))));
  SolidBody body = stone("sledge", box_solid(Vec3(-0.2, -0.2, 0), Vec3(0.2, 0.2, 0.04)));
  body.pieces.push_back(box_solid(Vec3(-0.1, 0, 0.04), Vec3(0.1, 0.2, 0.14)));
  body.velocity = Vec3(1, 0, 0);
  builder.add(body);
  builder.contact(0, 0, frictional(kn, kn, mu, 1e-4), "joint");
  SolidRun run(builder.build(), dt);
  const Vec3 start = run.place(1);
  CHECK(start.y() > 0.038);  // a tenth of the width
  REQUIRE(run.run_until(0.5, [&] { return run.velocity(1).norm() < 1e-3; }));
  CHECK(near(run.time(), 1 / (mu * standard_gravity), 5e-3));
  const Vec3 way = run.place(1) - start;
  CHECK(near(way.x(), 0.5 / (mu * standard_gravity), 5e-3));
  // Friction at the middle of the area would rotate the block by 0.18 rad.
  CHECK(std::abs(run.turned(1).z()) < 1e-3);
  CHECK(std::abs(way.y()) < 1e-4);
}
