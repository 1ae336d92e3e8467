// Solids that must stand still for long, and a heap of random stones that must come to rest (VALIDATION T15, T36).
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "near.hpp"
#include "physics/space/solid_bodies.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// A dry wall in running bond on a fixed base, of units of 0.4 m x 0.2 m x 0.2 m.
Model<3> dry_wall(int courses, int columns) {
  constexpr double l = 0.4, h = 0.2;
  SpaceBuilder builder;
  builder.gravity(Vec3(0, 0, -standard_gravity));
  builder.add(fixed_stone("base", box_solid(Vec3(0, 0, -h), Vec3(columns * l, h, 0))));
  for (int c = 0; c < courses; ++c) {
    double from = 0;
    for (int n = 0; from < columns * l - 1e-9; ++n) {
      const bool half = c % 2 == 1 && (n == 0 || n == columns);
      const double to = std::min(columns * l, from + (half ? 0.5 * l : l));
      builder.add(stone("unit " + std::to_string(c) + "." + std::to_string(n),
                        box_solid(Vec3(from, 0, c * h), Vec3(to, h, (c + 1) * h))));
      from = to;
    }
  }
  builder.contact(0, 0, frictional(1e10, 4e9, 0.7, 2e-5), "dry");
  return builder.build();
}

/// The largest f(node) over all nodes except the first.
template <class F>
double largest_of(const SolidRun& run, F&& f) {
  double most = 0;
  for (std::size_t n = 1; n < run.state().position.size(); ++n) most = std::max(most, f(n));
  return most;
}

/// T15: planes with these dips and dip directions carry a wedge; x to the east, y to the north.
struct WedgePlanes {
  Vec3 first, second, along;  // upward normals; down along the line in which the planes meet

  static Vec3 normal(double dip, double azimuth) {
    const double d = radians(dip), a = radians(azimuth);
    return {std::sin(d) * std::sin(a), std::sin(d) * std::cos(a), std::cos(d)};
  }
  WedgePlanes() : first(normal(40, 165)), second(normal(70, 285)) {
    along = cross(first, second).normalized();
    if (along.z() > 0) along = -along;
  }
  /// Unit vector in one plane at a right angle to the line, upwards and away from it.
  [[nodiscard]] Vec3 up(const Vec3& normal, const Vec3& other) const {
    const Vec3 way = cross(normal, along);
    return way.dot(other) > 0 ? way : Vec3(-way);
  }
};

/// Acceleration of the wedge down its line [m/s2], with both friction coefficients divided by `safety`.
double wedge_acceleration(double safety) {
  const WedgePlanes planes;
  const Vec3 a = planes.up(planes.first, planes.second), b = planes.up(planes.second, planes.first);
  SpaceBuilder builder;
  builder.gravity(Vec3(0, 0, -standard_gravity));
  const auto bank = [&](const std::string& name, const Vec3& way, const Vec3& normal, int surface) {
    const std::vector<Vec3> outline{-2 * planes.along, 0.6 * way - 2 * planes.along,
                                    0.6 * way - 0.2 * normal - 2 * planes.along, -0.2 * normal - 2 * planes.along};
    SolidBody body = fixed_stone(name, extrusion(outline, 5 * planes.along));
    body.surface = surface;
    builder.add(body);
  };
  bank("first", a, planes.first, 1), bank("second", b, planes.second, 2);
  SolidBody wedge = stone("wedge", extrusion(std::vector<Vec3>{Vec3::Zero(), 0.3 * a, 0.3 * b}, planes.along));
  wedge.velocity = 0.05 * planes.along;
  builder.add(wedge);
  builder.contact(0, 1, frictional(1e10, 1e10, std::tan(radians(35)) / safety, 1e-4), "first");
  builder.contact(0, 2, frictional(1e10, 1e10, std::tan(radians(20)) / safety, 1e-4), "second");
  SolidRun run(builder.build(), 1e-5);
  run.run(0.1);
  const double early = run.velocity(2).dot(planes.along);
  run.run(0.2);
  return (run.velocity(2).dot(planes.along) - early) / 0.2;
}

}  // namespace

TEST_CASE("T15: an unsymmetric wedge has the factor of safety of both its planes") {
  const WedgePlanes planes;
  CHECK(near(std::asin(-planes.along.z()), radians(31.569), 1e-4));
  for (const double safety : {1.29, 1.32, 2.0}) {
    const double expected = standard_gravity * 0.52352 * (1 - 1.3041 / safety);
    CHECK(near_zero(wedge_acceleration(safety) - expected, 0.01 * standard_gravity * 0.52352));
  }
  CHECK(wedge_acceleration(1.29) < 0);
  CHECK(wedge_acceleration(1.32) > 0);
}

TEST_CASE("a cube of 10 cm and 1 kg rests for a minute and does not turn" * doctest::test_suite("long")) {
  SpaceBuilder builder;
  builder.gravity(Vec3(0, 0, -standard_gravity));
  builder.add(fixed_stone("floor", box_solid(Vec3(-1, -1, -0.1), Vec3(1, 1, 0))));
  builder.add(stone("cube", box_at(Vec3(0.1, 0.1, 0.1), Vec3(0.013, 0.027, 0.05)), 1000));
  builder.contact(0, 0, frictional(1e8, 1e8, 0.5, 1e-4), "joint");
  SolidRun run(builder.build(), 1e-4);
  run.run(60);
  CHECK(run.turned(1).norm() < 1e-9);
  CHECK(near(-(run.place(1).z() - 0.05), 1000 * 0.1 * standard_gravity / 1e8, 1e-9));
  CHECK(run.place(1).head<2>().isApprox(Vec2(0.013, 0.027), 1e-9));
}

TEST_CASE("a dry wall of 20 courses is at rest for one minute" * doctest::test_suite("long")) {
  SolidRun run(dry_wall(20, 4), 1e-4);
  run.settle(0.5);
  const std::vector<Vec3> before = run.state().position;
  run.run(60);
  const double drift = largest_of(run, [&](std::size_t n) { return (run.state().position[n] - before[n]).norm(); });
  CHECK(drift < 1e-5);
  MESSAGE("drift " << drift << " m");
}

TEST_CASE("27 random stones that collide conserve momentum, angular momentum and energy") {
  std::mt19937_64 bits(36);
  SpaceBuilder builder;
  builder.gravity(Vec3::Zero());
  for (int i = 0; i < 27; ++i) {
    const Vec3 at = 0.7 * Vec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    SolidBody body = stone("stone " + std::to_string(i),
                           placed(random_convex_solid(bits, {.smallest = 0.35, .largest = 0.5}), {}, at), 1000);
    body.velocity = -2 * at + 0.2 * random_in_ball(bits), body.spin = 3 * random_in_ball(bits);
    builder.add(body);
  }
  builder.contact(0, 0, frictional(1e9, 0, 0), "glassy");
  SolidRun run(builder.build(), 2e-5);
  const double energy = run.moving_energy();
  const Vec3 momentum = run.momentum(), turning = run.angular_momentum();
  double mass = 0;
  for (const double m : run.model().mass) mass += m;
  int most = 0;
  run.run_until(3, [&] {
    most = std::max(most, static_cast<int>(run.work().general_touching.size()));
    return run.time() > 0.6 && run.work().general_touching.empty();
  });
  CHECK(most > 5);
  CHECK(near(run.moving_energy(), energy, 1e-2));
  CHECK((run.momentum() - momentum).norm() < 1e-9 * mass);
  CHECK((run.angular_momentum() - turning).norm() < 1e-9 * mass);
}

TEST_CASE("500 stones poured into a box come to rest" * doctest::test_suite("long")) {
  std::mt19937_64 bits(500);
  SpaceBuilder builder;
  builder.gravity(Vec3(0, 0, -standard_gravity));
  SolidBody box;
  box.name = "box", box.density = 2000, box.fixed = true;
  constexpr double w = 2, t = 0.2, high = 4;
  box.pieces = {box_solid(Vec3(-w - t, -w - t, -t), Vec3(w + t, w + t, 0)),
                box_solid(Vec3(-w - t, -w - t, 0), Vec3(-w, w + t, high)),
                box_solid(Vec3(w, -w - t, 0), Vec3(w + t, w + t, high)),
                box_solid(Vec3(-w, -w - t, 0), Vec3(w, -w, high)), box_solid(Vec3(-w, w, 0), Vec3(w, w + t, high))};
  builder.add(box);
  for (int i = 0; i < 500; ++i) {
    const Vec3 at(0.6 * (i % 6 - 2.5), 0.6 * (i / 6 % 6 - 2.5), 0.4 + 0.6 * (i / 36));
    const Polyhedron shape = random_convex_solid(bits, {.smallest = 0.3, .largest = 0.5});
    builder.add(stone("stone " + std::to_string(i), placed(shape, {}, at + 0.03 * random_in_ball(bits))));
  }
  builder.contact(0, 0, frictional(5e7, 5e7, 0.6, 1e-3), "rubble");
  SolidRun run(builder.build(), 2e-4);
  double fall = 0;
  for (std::size_t n = 1; n <= 500; ++n)
    fall += run.model().mass[n] * standard_gravity * run.model().start_position[n].z();
  const double begun = run.energy().balance();
  run.run(6);
  const auto fastest_now = [&] {
    return largest_of(run, [&](std::size_t n) { return run.state().velocity[n].norm(); });
  };
  // The moment at which the last stone stops rocking depends on single bits of the fall: the run gets some seconds
  // more.
  for (int more = 0; more < 8 && fastest_now() >= 0.02; ++more) run.run(0.5);
  const Energy energy = run.energy();
  const double fastest = fastest_now();
  const double farthest =
      largest_of(run, [&](std::size_t n) { return run.state().position[n].head<2>().cwiseAbs().maxCoeff(); });
  MESSAGE("fastest " << fastest << " m/s, of the fall " << energy[EnergyTerm::kinetic] / fall << " left, ledger "
                     << (energy.balance() - begun) / fall);
  CHECK(farthest < w);
  CHECK(energy[EnergyTerm::kinetic] < 1e-6 * fall);
  CHECK(fastest < 0.02);
  CHECK(near_zero(energy.balance() - begun, 1e-2 * fall));
}
