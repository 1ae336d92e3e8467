// Two blocks that collide with a restitution set through beta (D6), and a bar that falls about a hinge (D7).
#include <doctest/doctest.h>

#include <cmath>

#include "near.hpp"
#include "physics/scene.hpp"

namespace trilith {
namespace {

using testing::box;
using testing::near;
using testing::Scene;

/// Restitution of a spring and dashpot in parallel without tensile force (VALIDATION F2).
double restitution(double zeta) {
  const double s = std::sqrt(1 - zeta * zeta);
  return std::exp(-zeta / s * (M_PI - std::atan2(2 * zeta * s, 1 - 2 * zeta * zeta)));
}

/// Its inverse, by bisection: restitution falls from 1 at zeta = 0 to exp(-2) at zeta = 1.
double damping_ratio_for(double e) {
  double low = 0, high = 0.9999999;
  for (int i = 0; i < 60; ++i) (restitution(0.5 * (low + high)) > e ? low : high) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

TEST_CASE("D6: the formula for beta reproduces the restitutions of its table") {
  const std::array<std::pair<double, double>, 6> table{
      {{0.02, 0.93984}, {0.05, 0.85876}, {0.1, 0.74408}, {0.2, 0.57174}, {0.3, 0.45098}, {0.5, 0.29844}}};
  for (const auto& [zeta, e] : table) {
    CHECK(near(restitution(zeta), e, 2e-5));
    CHECK(near(damping_ratio_for(e), zeta, 2e-4));
  }
}

/// Two blocks that collide face to face, without gravity.
struct Meeting {
  double m1 = 1000, m2 = 2000, v1 = 1, v2 = 0;  ///< [kg], [m/s]
  double kn = 1e8;                              ///< on a face of 1 m [Pa/m]
  double turn = 0;                              ///< of the world [rad]
  double gap = 1e-3;                            ///< at the start [m]

  /// Velocities after a collision with contact damping `zeta` of the two masses on their contact; steps of `share` over
  /// the frequency of this contact.
  [[nodiscard]] std::pair<double, double> after(double zeta, double share) const {
    const double w = std::sqrt(kn / (m1 * m2 / (m1 + m2)));
    Scene scene(Frictional{kn, 0, 0, 2 * zeta / w}, turn);
    scene.set_gravity({0, 0});
    scene.block("one", box(0, 0, 1, 1), m1, {v1, 0});
    scene.block("two", box(1 + gap, 0, 2 + gap, 1), m2, {v2, 0});
    Simulation<2> sim = scene.start();
    testing::run_for(sim, gap / (v1 - v2) + 10 / w, share / w);
    return {scene.to_scene(sim.state().velocity[0]).x(), scene.to_scene(sim.state().velocity[1]).x()};
  }
};

TEST_CASE("D6: 1000 kg at 1 m/s hits 2000 kg at rest with restitution 1, 0.65 and nearly 0") {
  struct Row {
    double zeta, share, one, two;
  };
  for (const Row& row : {Row{0, 0.02, -1.0 / 3, 2.0 / 3}, Row{damping_ratio_for(0.65), 0.002, -0.10, 0.55},
                         Row{20, 0.001, 1.0 / 3, 1.0 / 3}}) {
    const auto [u, v] = Meeting{}.after(row.zeta, row.share);
    MESSAGE("D6 zeta = " << row.zeta << ": " << u << " and " << v << " m/s, expected " << row.one << " and "
                         << row.two);
    CHECK(near(u, row.one, 0.01));
    CHECK(near(v, row.two, 0.01));
  }
}

TEST_CASE("D6: the error of the restitution is of first order in the step") {
  const double zeta = damping_ratio_for(0.65);
  // The worst result of several gaps: the phase of the step at the first contact is random.
  const auto error = [&](double share) {
    double worst = 0;
    for (const double gap : {1e-3, 1.123e-3, 1.317e-3, 1.77e-3}) {
      Meeting m;
      m.gap = gap;
      const auto [u, v] = m.after(zeta, share);
      worst = std::max(worst, std::abs((v - u) - 0.65));
    }
    return worst;
  };
  for (const double share : {0.1, 0.025, 0.00625, 0.0015}) {
    const double wrong = error(share);
    MESSAGE("D6 error of e at steps of " << share << "/w: " << wrong);
    CHECK(wrong < 0.2 * share);
  }
}

TEST_CASE("D6: other masses, speeds and stiffness, in a rotated frame, keep momentum and the restitution requested") {
  struct Row {
    double m1, m2, v1, v2, kn, turn, e;
  };
  for (const Row& row : {Row{10, 10, 2, -1, 1e6, 17, 0.8}, Row{5e5, 2e3, 0.3, 0.1, 1e9, 203, 0.5},
                         Row{1, 1e4, 5, 0, 1e7, 90, 0.9}, Row{700, 300, 0, -4, 1e8, 45, 0.3}}) {
    Meeting m;
    m.m1 = row.m1, m.m2 = row.m2, m.v1 = row.v1, m.v2 = row.v2, m.kn = row.kn, m.turn = row.turn * testing::degree;
    const auto [u, v] = m.after(damping_ratio_for(row.e), 0.002);
    INFO("masses ", row.m1, " and ", row.m2, " kg, e = ", row.e);
    CHECK(std::abs(row.m1 * (u - row.v1) + row.m2 * (v - row.v2)) < 1e-9 * row.m1 * (row.v1 - row.v2));
    CHECK(near((v - u) / (row.v1 - row.v2), row.e, 0.01));
  }
}

/// Time for the far end of a bar hinged at one end and released level to drop by `drop` [s]: by quadrature of theta'' =
/// (3 g / 2 L) cos(theta), so theta' = sqrt(3 g/L sin(theta)).
double falling_time(double length, double drop) {
  const double end = std::asin(drop / length);
  // theta = s^2 removes the singularity at the start.
  const int n = 20000;
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double s = std::sqrt(end) * (i + 0.5) / n;
    sum += 2 * s / std::sqrt(3 * standard_gravity / length * std::sin(s * s)) * std::sqrt(end) / n;
  }
  return sum;
}

/// The same by the engine: a bar, its left end hinged to the ground by a stiff link.
double falling_time_by_engine(double length, double depth, double drop, double turn) {
  Scene scene(Frictional{1e8, 0, 0, 0}, turn);
  scene.fixed("ground", box(-2, -3, -1, 0));
  BodySpec bar;
  bar.name = "bar", bar.outline = box(0, -depth / 2, length, depth / 2);
  bar.mass = 1000, bar.inertia = 1000 * length * length / 12;  // of a thin bar, whatever the drawn depth
  scene.add(bar);
  scene.builder.set_contact("*", "*", "none");
  BearingSpec hinge;
  hinge.name = "hinge", hinge.body_a = "ground", hinge.body_b = "bar", hinge.angle = turn;
  hinge.point_a = hinge.point_b = scene.to_world({0, 0});
  const double k = 1000 * standard_gravity / (1e-5 * length);  // deflection of 1e-5 of the length
  hinge.law = {Linear{k, 0.02 * std::sqrt(k * 1000)}, Linear{k, 0.02 * std::sqrt(k * 1000)}, {}};
  scene.builder.add_bearing(hinge);
  Simulation<2> sim = scene.start();
  double last = 0, last_t = 0, found = -1;
  testing::run_for(sim, 1.5 * falling_time(length, drop), 0, testing::each_step([&](const Instant<2>& now) {
                     const Vec2 end =
                         now.state.position[1] + Turn(turn + now.state.rotation[1]).apply(Vec2(length / 2, 0));
                     const double down = -scene.to_scene(end).y();
                     if (found < 0 && down >= drop)
                       found = last_t + (now.state.time - last_t) * (drop - last) / (down - last);
                     last = down, last_t = now.state.time;
                   }));
  return found;
}

TEST_CASE(
    "D7: an 80 ft bar hinged at one end drops its other end by 20, 40, 50 and 60 ft in the time of a turning bar") {
  const double foot = 0.3048, length = 80 * foot;
  for (const auto& [drop, seconds] :
       {std::pair{20.0, 0.914}, std::pair{40.0, 1.322}, std::pair{50.0, 1.506}, std::pair{60.0, 1.696}}) {
    const double ours = falling_time_by_engine(length, 5 * foot, drop * foot, 0);
    MESSAGE("D7 " << drop << " ft: " << ours << " s, expected " << seconds << " s (quadrature "
                  << falling_time(length, drop * foot) << " s)");
    CHECK(near(ours, seconds, 0.01));
    CHECK(near(ours, falling_time(length, drop * foot), 0.001));
  }
}

TEST_CASE("D7: bars of other lengths, in rotated frame, fall in the time found by quadrature") {
  for (const auto& [length, turn] : {std::pair{0.5, 17.0}, std::pair{3.0, 90.0}, std::pair{120.0, 203.0}})
    for (const double share : {0.1, 0.5, 0.95})
      CHECK(near(falling_time_by_engine(length, 0.05 * length, share * length, turn * testing::degree),
                 falling_time(length, share * length), 0.01));
}

}  // namespace
}  // namespace trilith
