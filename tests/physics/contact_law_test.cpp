// VALIDATION C1 to C6: load transfer through contacts, and bounces of blocks.
#include <algorithm>

#include "near.hpp"
#include "physics/scene.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Depth of a body's corner below the scene's x axis [m].
double depth_of(const Scene& scene, const Simulation<2>& sim, const std::string& body, int corner) {
  return -scene.to_scene(corner_of(sim, body, corner)).y();
}

/// A base from x = `from` to `to` [m] with its top on the scene's x axis.
Polygon base_under(double from, double to) {
  return rectangle({from, -1}, {to, 0});
}

struct Bounce {
  double restitution, duration, deepest;  // speed share, w t, w d / v0
};

/// A body of mass `m1` hits a fixed base (m2 = 0) or a free body of mass m2, flat and at `speed`.
Bounce bounce(double m1, double m2, double kn, double speed, double zeta, double turn) {
  const double m = m2 > 0 ? m1 * m2 / (m1 + m2) : m1;
  const double w = std::sqrt(kn / m);
  Scene scene(Frictional{kn, 0, 0, 2 * zeta / w}, turn);
  scene.set_gravity(Vec2::Zero());
  if (m2 > 0)
    scene.block("below", base_under(0, 1), m2);
  else
    scene.fixed("below", base_under(0, 1));
  scene.block("above", rectangle({0, 0}, {1, 1}), m1, {0, -speed});
  Simulation<2> sim = scene.start();
  const double dt = 5e-4 / w;
  const int above = node_of(sim.model(), "above"), below = node_of(sim.model(), "below");
  const double distance = (sim.state().position[above] - sim.state().position[below]).norm();
  double loaded = 0, deepest = 0;
  run_for(sim, 4 / w, dt, each_step([&](const Instant<2>& now) {
            if (now.work.force[above].norm() > 0) loaded += now.state.last_dt;
            deepest = std::max(deepest, distance - (now.state.position[above] - now.state.position[below]).norm());
          }));
  const Vec2 parting = scene.to_scene(sim.state().velocity[above] - sim.state().velocity[below]);
  return {parting.y() / speed, w * loaded, w * deepest / speed};
}

}  // namespace

TEST_CASE("C1: a block rests at the overlap m g / (kn A), under a uniform stress") {
  struct Case {
    double mass, width, kn, thickness;
  };
  for (const Case c : {Case{1000, 1, 1e8, 1}, Case{1000, 0.25, 1e8, 1}, Case{37, 2, 4e7, 0.5}, Case{1e5, 3, 1e9, 2}}) {
    Scene scene(Frictional{c.kn, 0.5 * c.kn, 0.6, 1e-3});
    scene.builder.thickness = c.thickness;
    scene.fixed("base", base_under(-5, 5));
    scene.block("block", rectangle({0, 0}, {c.width, 1}), c.mass);
    Simulation<2> sim = scene.start();
    CHECK(settle(sim).end == StageEnd::rest);
    const double expected = c.mass * standard_gravity / (c.kn * c.width * c.thickness);
    const double left = depth_of(scene, sim, "block", 0), right = depth_of(scene, sim, "block", 1);
    MESSAGE("C1 overlap ", left, " expected ", expected);
    CHECK(near(left, expected, 1e-4));
    CHECK(near(right, expected, 1e-4));
    CHECK(near(c.kn * left, c.mass * standard_gravity / (c.width * c.thickness), 1e-4));
  }
}

TEST_CASE("C2, C3: a flat bounce with damping that may not pull has the restitution, duration and depth of F2") {
  const double zetas[] = {0.02, 0.05, 0.1, 0.2, 0.3, 0.5};
  const double restitution[] = {0.93984, 0.85876, 0.74408, 0.57174, 0.45098, 0.29844};
  const double duration[] = {3.1022, 3.0454, 2.9561, 2.7954, 2.6545, 2.4184};
  const double depth[] = {0.96945, 0.92669, 0.86260, 0.75613, 0.67155, 0.54629};
  for (int i = 0; i < 6; ++i) {
    const double zeta = zetas[i], s = std::sqrt(1 - zeta * zeta);
    // The published figures agree with the formulas.
    CHECK(near(std::exp(-zeta / s * (M_PI - std::atan2(2 * zeta * s, 1 - 2 * zeta * zeta))), restitution[i], 1e-4));
    CHECK(near(std::exp(-zeta / s * std::atan2(s, zeta)), depth[i], 1e-4));
    const Bounce fixed = bounce(1000, 0, 1e8, 1, zeta, 0), two = bounce(300, 700, 5e8, 0.2, zeta, 17 * degree);
    MESSAGE("zeta ", zeta, ": e ", fixed.restitution, " (", restitution[i], "), w t ", fixed.duration, " (",
            duration[i], "), w d/v0 ", fixed.deepest, " (", depth[i], "), two bodies: e ", two.restitution);
    for (const Bounce& b : {fixed, two}) {
      CHECK(near(b.restitution, restitution[i], 0.005));
      CHECK(near(b.duration, duration[i], 0.005));
      CHECK(near(b.deepest, depth[i], 0.005));
    }
  }
}

TEST_CASE("C2: without damping a flat bounce returns the speed") {
  const Bounce b = bounce(1000, 0, 1e8, 1, 0, 0);
  CHECK(near(b.restitution, 1.0, 1e-6));
  CHECK(near(b.duration, M_PI, 0.001));
  CHECK(near(b.deepest, 1.0, 0.001));
}

namespace {

struct Joint {
  double left, right, rotation;  // stress [Pa] at the ends of the joint, turn of the block
};

/// A block of weight N on a joint of width B, its centroid at the eccentricity `e` to the right of the joint's middle:
/// a leaning block.
Joint eccentric(double n, double b, double e, double kn, double turn) {
  Scene scene(Frictional{kn, 0.5 * kn, 0.8, 1e-3}, turn);
  scene.fixed("base", base_under(-2 * b, 3 * b));
  BodySpec spec;
  spec.name = "block", spec.weight = n;
  spec.outline = {{0, 0}, {b, 0}, {b + 2 * e, 0.4 * b}, {2 * e, 0.4 * b}};
  scene.add(spec);
  Simulation<2> sim = scene.start();
  CHECK(settle(sim).end == StageEnd::rest);
  return {kn * depth_of(scene, sim, "block", 0), kn * depth_of(scene, sim, "block", 1),
          -sim.state().rotation[node_of(sim.model(), "block")]};
}

}  // namespace

TEST_CASE("C4: within the middle third the stress of an eccentric load is N/B (1 +- 6e/B)") {
  struct Case {
    double n, b, e, kn, turn;
  };
  for (const Case c : {Case{1e4, 1, 0.1, 1e8, 0}, Case{1e4, 1, 0.01, 1e8, 0}, Case{1e4, 1, 0.1, 1e8, 203 * degree},
                       Case{5e5, 2, 0.3, 4e9, 90 * degree}}) {
    const Joint j = eccentric(c.n, c.b, c.e, c.kn, c.turn);
    MESSAGE("C4 e ", c.e, ": ", j.left, " ", j.right, " Pa, ", j.rotation, " rad");
    CHECK(near(j.right, c.n / c.b * (1 + 6 * c.e / c.b), 0.005));
    CHECK(near(j.left, c.n / c.b * (1 - 6 * c.e / c.b), 0.005));
    CHECK(near(j.rotation, 12 * c.n * c.e / (c.kn * c.b * c.b * c.b), 0.005));
  }
}

TEST_CASE("C4: an eccentric load beyond the middle third opens the joint to 3(B/2 - e)") {
  struct Case {
    double n, b, e, kn, turn;
  };
  for (const Case c : {Case{1e4, 1, 0.25, 1e8, 0}, Case{1e4, 1, 0.25, 1e8, 17 * degree}, Case{1e4, 1, 0.4, 1e9, 0},
                       Case{2e4, 0.5, 0.1, 1e9, 90 * degree}}) {
    const Joint j = eccentric(c.n, c.b, c.e, c.kn, c.turn);
    const double length = 3 * (c.b / 2 - c.e), peak = 2 * c.n / length;
    MESSAGE("C4 e ", c.e, ": peak ", j.right, " (", peak, ") Pa, ", j.rotation, " rad, length ",
            c.b * j.right / (j.right - j.left), " (", length, ") m");
    CHECK(near(j.right, peak, 0.005));
    CHECK(near(c.b * j.right / (j.right - j.left), length, 0.005));
    CHECK(near(j.rotation, peak / (c.kn * length), 0.005));
  }
}

TEST_CASE("C5: faces that overlap in part carry W/(1 - s) where they overlap") {
  for (const double s : {0.1, 0.25, 0.5, 0.75}) {
    const double kn = 1e8, weight = 2e4;
    Scene scene(Frictional{kn, 0.5 * kn, 0.6, 1e-3});
    scene.fixed("lower", rectangle({0, -0.5}, {1, 0}));
    BodySpec spec;  // leans back, so that its weight acts through the middle of the contact
    spec.name = "upper", spec.weight = weight;
    spec.outline = {{s, 0}, {1 + s, 0}, {1, 0.5}, {0, 0.5}};
    scene.add(spec);
    Simulation<2> sim = scene.start();
    CHECK(settle(sim).end == StageEnd::rest);
    const double rotation = sim.state().rotation[node_of(sim.model(), "upper")], expected = weight / (1 - s);
    const double at_left = kn * depth_of(scene, sim, "upper", 0);
    const double at_edge = kn * (depth_of(scene, sim, "upper", 0) - rotation * (1 - s));
    MESSAGE("C5 s ", s, ": ", at_left, " and ", at_edge, " Pa (", expected, ")");
    CHECK(near(at_left, expected, 0.005));
    CHECK(near(at_edge, expected, 0.005));
  }
}

TEST_CASE("C6: three blocks on one transfer a uniform pressure, without rotation") {
  const double kn = 1e10, pressure = 1e6;
  for (const double turn : {0.0, 17 * degree, 90 * degree, 203 * degree}) {
    Scene scene(Frictional{kn, 0.5 * kn, 0.6, 1e-4}, turn);
    scene.set_gravity(Vec2::Zero());
    scene.fixed("base", base_under(-1, 2));
    scene.block("wide", rectangle({0, 0}, {1, 0.3}), 600);
    for (int i = 0; i < 3; ++i) {
      BodySpec spec;
      spec.name = "narrow" + std::to_string(i), spec.mass = 200, spec.load = {0, -pressure / 3};
      spec.outline = rectangle({i / 3.0, 0.3}, {(i + 1) / 3.0, 0.6});
      scene.add(spec);
    }
    Simulation<2> sim = scene.start();
    CHECK(settle(sim).end == StageEnd::rest);
    const auto y = [&](const std::string& body, int corner) {
      return scene.to_scene(corner_of(sim, body, corner)).y();
    };
    double least = 1e300, most = 0;
    const auto note = [&](double stress) { least = std::min(least, stress), most = std::max(most, stress); };
    for (const int c : {0, 1}) note(-kn * y("wide", c));
    for (int i = 0; i < 3; ++i)
      for (const int c : {0, 1}) note(kn * (y("wide", 2) - y("narrow" + std::to_string(i), c)));
    MESSAGE("C6 joint stress ", least, " to ", most, " Pa");
    CHECK(near(least, pressure, 0.001));
    CHECK(near(most, pressure, 0.001));
    for (int n = 0; n < sim.model().nodes(); ++n) CHECK(std::abs(sim.state().rotation[n]) < 1e-8);
  }
}
