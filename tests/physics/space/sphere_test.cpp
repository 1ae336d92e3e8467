// Spheres in motion: rolling, slipping, bouncing, spinning and colliding against closed forms.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "integrate/explicit/stable_step.hpp"
#include "near.hpp"
#include "solid_bodies.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double radius = 0.05, density = 2500;

SolidBody ball(const std::string& name, const Vec3& at, double r = radius) {
  SolidBody body;
  body.name = name, body.density = density, body.spheres = {{at, r}};
  return body;
}

double mass_of_ball(double r = radius) {
  return density * 4.0 / 3 * std::numbers::pi * r * r * r;
}

/// Penetration of a ball at rest on a plane: m g = kn pi R e^2 except for a share of e / R [m].
double resting_depth(double kn, double weight) {
  return std::sqrt(weight / (kn * std::numbers::pi * radius));
}

/// A ball on a floor tilted by `angle`, with the penetration of its weight's component normal to the floor.
SolidRun on_slope(double angle, double mu, const Vec3& velocity = Vec3::Zero(), double kn = 1e10) {
  SpaceBuilder space;
  space.gravity(tilted_gravity(angle, 0));
  space.add(fixed_stone("floor", box_at(Vec3(20, 20, 1), Vec3(0, 0, -0.5))));
  SolidBody b =
      ball("ball", Vec3(0, 0, radius - resting_depth(kn, mass_of_ball() * standard_gravity * std::cos(angle))));
  b.velocity = velocity;
  space.add(b);
  space.contact(0, 0, frictional(kn, 0.5 * kn, mu, 2e-5), "rolls");
  return {space.build(), 1e-5};
}

}  // namespace

TEST_CASE("a ball rolls down a slope with 5/7 of the acceleration of a smooth one") {
  const double angle = radians(20);
  SolidRun run = on_slope(angle, 0.5);
  run.run(0.1);
  const double begun = run.velocity(1).x();
  run.run(0.4);
  CHECK(near((run.velocity(1).x() - begun) / 0.4, 5.0 / 7 * standard_gravity * std::sin(angle), 0.002));
  CHECK(near(run.spin(1).y(), run.velocity(1).x() / radius, 0.002));
}

TEST_CASE("a ball on a slope slips where the tangent is above 7/2 mu") {
  const double mu = 0.2, limit = std::atan(3.5 * mu);
  SolidRun rolls = on_slope(limit - radians(2), mu), slips = on_slope(limit + radians(2), mu);
  for (SolidRun* run : {&rolls, &slips}) run->run(0.3);
  const auto slip = [](const SolidRun& run) { return run.velocity(1).x() - radius * run.spin(1).y(); };
  CHECK(std::abs(slip(rolls)) < 0.01 * rolls.velocity(1).x());
  CHECK(slip(slips) > 0.03);
  const double steep = radians(60);
  SolidRun run = on_slope(steep, mu);
  run.run(0.05);
  const double v = run.velocity(1).x(), w = run.spin(1).y();
  run.run(0.2);
  CHECK(near((run.velocity(1).x() - v) / 0.2, standard_gravity * (std::sin(steep) - mu * std::cos(steep)), 0.003));
  CHECK(near((run.spin(1).y() - w) / 0.2, 2.5 * mu * standard_gravity * std::cos(steep) / radius, 0.005));
}

TEST_CASE("a ball that is pushed along slides until it rolls with 5/7 of its speed") {
  SolidRun run = on_slope(0, 0.3, Vec3(2, 0, 0));
  run.run(0.1);
  const double slides = run.velocity(1).x();
  CHECK(near(slides, 2 - 0.3 * standard_gravity * 0.1, 0.003));
  run.run(0.4);
  CHECK(near(run.velocity(1).x(), 2 * 5.0 / 7, 0.003));
  CHECK(near(run.spin(1).y(), 2 * 5.0 / 7 / radius, 0.003));
}

TEST_CASE("a spinning ball on a plane is slowed by the friction couple of its contact disc") {
  const double kn = 1e8, mu = 0.4;
  SpaceBuilder space;
  space.gravity(Vec3(0, 0, -standard_gravity));
  space.add(fixed_stone("floor", box_at(Vec3(2, 2, 1), Vec3(0, 0, -0.5))));
  const double weight = mass_of_ball() * standard_gravity, depth = resting_depth(kn, weight);
  SolidBody b = ball("ball", Vec3(0, 0, radius - depth));
  b.spin = Vec3(0, 0, 10);
  space.add(b);
  space.contact(0, 0, frictional(kn, 0.5 * kn, mu, 1e-4), "rubs");
  SolidRun run(space.build(), 2e-5);
  run.run(0.05);
  const double w = run.spin(1).z();
  run.run(0.1);
  const double couple = mu * weight * 8 / 15 * std::sqrt(2 * radius * depth - depth * depth);
  CHECK(near((w - run.spin(1).z()) / 0.1, couple / (0.4 * mass_of_ball() * radius * radius), 0.02));
}

TEST_CASE("a ball on a floor sinks in as deep as its weight presses the cap") {
  SolidRun run = on_slope(0, 0.3);
  run.run(0.3);
  const double e = radius - run.place(1).z(), weight = mass_of_ball() * standard_gravity;
  CHECK(near(1e10 * std::numbers::pi * e * e * (3 * radius - 2 * e) / 3, weight, 1e-4));
  CHECK(run.velocity(1).norm() < 1e-4);
}

TEST_CASE("a ball bounces to its drop height without damping and by its equation of motion with damping") {
  const double kn = 1e9, speed = 1;
  for (const double beta : {0.0, 2e-4}) {
    SpaceBuilder space;
    space.add(fixed_stone("floor", box_at(Vec3(2, 2, 1), Vec3(0, 0, -0.5))));
    SolidBody b = ball("ball", Vec3(0, 0, radius + 1e-4));
    b.velocity = Vec3(0, 0, -speed);
    space.add(b);
    space.contact(0, 0, frictional(kn, kn, 0, beta), "bounces");
    SolidRun run(space.build(), 2e-6);
    run.run(0.02);
    // m d2e/dt2 = -F with the cap force F = kn pi e^2 (3 R - 2 e) / 3. During loading the damping adds kn beta (de/dt)
    // times the area; during unloading e and R are reduced by beta |de/dt|.
    double e = 0, v = speed;
    const double dt = 1e-7, m = mass_of_ball();
    const auto cap = [&](double d, double r) { return d > 0 ? std::numbers::pi / 3 * d * d * (3 * r - 2 * d) : 0; };
    for (bool in = true; in || e > 0;) {
      const double area = std::numbers::pi * (2 * radius * e - e * e);
      const double relief = std::max(0.0, -beta * v);
      const double force = v >= 0 ? cap(e, radius) + beta * v * area : cap(e - relief, radius - relief);
      v -= dt * kn * force / m, e += dt * v;
      in = in && v > 0;
    }
    CHECK(near(run.velocity(1).z(), -v, 0.003));
    if (beta == 0) CHECK(near(run.velocity(1).z(), speed, 1e-4));
  }
}

TEST_CASE("a ball rolls over the joint of two flush blocks at a constant height") {
  SpaceBuilder space;
  space.gravity(Vec3(0, 0, -standard_gravity));
  space.add(fixed_stone("left", box_at(Vec3(1, 1, 1), Vec3(-0.5, 0, -0.5))));
  space.add(fixed_stone("right", box_at(Vec3(1, 1, 1), Vec3(0.5, 0, -0.5))));
  const double kn = 1e9, depth = resting_depth(kn, mass_of_ball() * standard_gravity);
  SolidBody b = ball("ball", Vec3(-0.1, 0, radius - depth));
  b.velocity = Vec3(1, 0, 0), b.spin = Vec3(0, 1 / (radius - depth), 0);
  space.add(b);
  space.contact(0, 0, frictional(kn, 0.5 * kn, 0.5, 1e-4), "rolls");
  SolidRun run(space.build(), 1e-5);
  run.run(0.05);
  double highest = -1, lowest = 1;
  run.run_until(0.15, [&] {
    highest = std::max(highest, run.place(2).z()), lowest = std::min(lowest, run.place(2).z());
    return false;
  });
  CHECK(run.place(2).x() > 0.09);
  CHECK(highest - lowest < 0.02 * depth);
  CHECK(near(run.velocity(2).x(), 1, 1e-3));
}

TEST_CASE("spheres, clumps and stones at random keep momentum and energy as they collide") {
  std::mt19937_64 bits(3);
  double worst = 0;
  for (int i = 0; i < 24; ++i) {
    SpaceBuilder space;
    const auto make = [&](const std::string& name, const Vec3& at, int kind) {
      SolidBody body;
      body.name = name, body.density = 2000;
      if (kind == 0) body.spheres = {{at, random_between(bits, 0.2, 0.5)}};
      if (kind == 1)
        body.spheres = {{at, 0.3}, {at + 0.3 * random_in_ball(bits), 0.25}, {at + 0.3 * random_in_ball(bits), 0.2}};
      if (kind == 2) body.pieces = {placed(random_convex_solid(bits), random_rotation(bits), at)};
      body.spin = 3 * random_in_ball(bits);
      return body;
    };
    SolidBody a = make("a", Vec3(-1.4, 0, 0), i % 2),
              b = make("b", Vec3(1.4, 0.3 * random_in_ball(bits).y(), 0), i % 3);
    a.velocity = Vec3(2, 0, 0), b.velocity = Vec3(-2, 0, 0);
    space.add(a), space.add(b);
    space.contact(0, 0, frictional(1e9, 0, 0), "smooth");
    SolidRun run(space.build(), 1e-5);
    const double energy = run.moving_energy();
    const Vec3 momentum = run.momentum(), turning = run.angular_momentum();
    run.run(1.2);
    CHECK((run.momentum() - momentum).norm() < 1e-9 * (1 + 4 * run.model().mass[0]));
    CHECK((run.angular_momentum() - turning).norm() < 1e-9 * (1 + 4 * run.model().mass[0]));
    worst = std::max(worst, std::abs(run.moving_energy() / energy - 1));
  }
  CHECK(worst < 0.01);
}

TEST_CASE("the energy balance of a ball that falls, slides and rolls closes") {
  SolidRun run = on_slope(radians(10), 0.3, Vec3(0, 1, -1));
  const double before = run.energy().balance();
  run.run(0.5);
  const Energy after = run.energy();
  CHECK(std::abs(after.balance() - before) < 2e-3 * after[EnergyTerm::contact_friction]);
  CHECK(after[EnergyTerm::contact_friction] > 0.05);
}

TEST_CASE("freeing scratch memory does not change spheres that fall on each other") {
  const auto heap = [] {
    SpaceBuilder space;
    space.gravity(Vec3(0, 0, -standard_gravity));
    space.add(fixed_stone("floor", box_at(Vec3(2, 2, 1), Vec3(0, 0, -0.5))));
    std::mt19937_64 bits(17);
    for (int i = 0; i < 24; ++i) {
      const Vec3 at(0.12 * (i % 2) + 0.01 * random_in_ball(bits).x(), 0.12 * (i / 2 % 2), 0.06 + 0.11 * (i / 4));
      SolidBody b = ball(std::to_string(i), at);
      if (i % 3 == 0) b.spheres.push_back({at + Vec3(0, 0, 0.02), 0.04});
      space.add(b);
    }
    space.contact(0, 0, frictional(1e9, 5e8, 0.4, 1e-4), "heap");
    return space.build();
  };
  SolidRun through(heap(), 2e-5), dropped(heap(), 2e-5);
  for (int i = 0; i < 8000; ++i) {
    through.step(), dropped.step();
    if (i % 500 == 0) dropped.drop_work();
  }
  for (int b = 1; b < 25; ++b) {
    CHECK(through.place(b) == dropped.place(b));
    CHECK(through.spin(b) == dropped.spin(b));
  }
}

TEST_CASE("the step for spheres is stable in a fast impact") {
  SpaceBuilder space;
  space.add(fixed_stone("floor", box_at(Vec3(2, 2, 1), Vec3(0, 0, -0.5))));
  SolidBody b = ball("ball", Vec3(0, 0, radius + 1e-3));
  b.velocity = Vec3(0, 0, -2);
  space.add(b);
  space.contact(0, 0, frictional(1e10, 5e9, 0.5), "hard");
  const Model<3> model = space.build();
  SolidRun first(model, 1e-6);
  const double dt = 0.8 * stable_step(model, first.state(), first.work()).dt;
  CHECK(dt > 2e-5);
  SolidRun run(model, dt);
  run.run(0.02);
  CHECK(near(run.velocity(1).z(), 2, 0.02));
}
