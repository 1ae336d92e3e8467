// VALIDATION B9: a compound pendulum.
#include "near.hpp"
#include "physics/scene.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Period of a rod of length L hinged at its end and released at `angle` from the vertical: complete elliptic integral
/// by the arithmetic-geometric mean [s].
double rod_period(double length, double angle) {
  double a = 1, b = std::cos(angle / 2);
  for (int i = 0; i < 20; ++i) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  return 2 * M_PI * std::sqrt(2 * length / (3 * standard_gravity)) / a;
}

/// A thin rod hinged by a stiff link, released at `angle`; the mean of ten periods [s].
double swing(double length, double angle, double turn) {
  Scene scene(Frictional{1e6, 0, 0, 0}, turn);
  scene.builder.set_contact("*", "*", "none");
  scene.fixed("wall", rectangle({-1, 1}, {1, 2}));
  BodySpec rod;
  rod.name = "rod", rod.mass = 3, rod.inertia = 3 * length * length / 12;
  const Vec2 way(std::sin(angle), -std::cos(angle)), side = 0.01 * left_of(way);
  rod.outline = {Vec2(-side), Vec2(length * way - side), Vec2(length * way + side), side};
  scene.add(rod);
  BearingSpec hinge;
  hinge.name = "hinge", hinge.body_a = "wall", hinge.body_b = "rod";
  hinge.law[along] = hinge.law[axial] = Linear{1e7, 0};
  scene.builder.add_bearing(hinge);
  Simulation<2> sim = scene.start();
  const int n = node_of(sim.model(), "rod");
  double before = 0, first = 0, last = 0;
  int turns = 0;
  run_for(sim, 10.6 * rod_period(length, angle), 0, each_step([&](const Instant<2>& now) {
            const double spin = now.state.spin[n];
            if (before > 0 && spin <= 0) {
              last = now.state.time;
              if (turns++ == 0) first = last;
            }
            before = spin;
          }));
  return (last - first) / (turns - 1);
}

}  // namespace

TEST_CASE("B9: a rod of 2 m hinged at its end and released at 60 degrees swings with 2.48635 s") {
  CHECK(near(rod_period(2, 60 * degree), 2.48635, 1e-5));
  for (const double turn : {0.0, 17 * degree, 203 * degree}) {
    const double period = swing(2, 60 * degree, turn);
    MESSAGE("B9 period ", period, " s (2.48635)");
    CHECK(near(period, 2.48635, 0.005));
  }
  for (const double angle : {5 * degree, 120 * degree, 170 * degree})
    CHECK(near(swing(0.7, angle, 0), rod_period(0.7, angle), 0.005));
}
