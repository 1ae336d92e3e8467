// VALIDATION I12: the rocking block of K4, K5 and T30 by implicit steps of 1 ms.
#include <algorithm>

#include "near.hpp"
#include "physics/members/implicit.hpp"

namespace trilith::testing {
namespace {

/// A block of half width b and half height h [m]; `inertia` about its centre per mass [m2].
struct TiltedBlock {
  double b, h, inertia;
  [[nodiscard]] double radius() const { return std::hypot(b, h); }
  [[nodiscard]] double angle() const { return std::atan2(b, h); }
  [[nodiscard]] double p() const { return std::sqrt(standard_gravity * radius() / (inertia + radius() * radius())); }
  /// Angular velocity at the landing, from rest at tilt q angle() [rad/s].
  [[nodiscard]] double landing(double q) const {
    return p() * std::sqrt(2 * (std::cos(angle() * (1 - q)) - std::cos(angle())));
  }
};

TiltedBlock plane_block(double width, double height) {
  return {width / 2, height / 2, (width * width + height * height) / 12};
}

/// Results of rocking from rest at a tilt.
struct RockingRun {
  double lands = 0, rate = 0;  ///< first landing: time [s], angular velocity before it [rad/s]
  double other_peak = 0;       ///< largest tilt to the other side before the second landing [rad]
  double highest = -1e300;     ///< largest excess of the energy over its start value, as a share of the energy of the
                               ///< swing
  int landings = 0;
  std::int64_t steps = 0;
  StageEnd end = StageEnd::time;

  RockingRun(const TiltedBlock& shape, double q, const StageOptions& stage) {
    Scene scene(Frictional{1e12, 5e11, 2, 2 * 0.1 / 3e4});
    scene.fixed("base", box(-4, -1, 4, 0));
    const double start = q * shape.angle(), mass = 1000 * 4 * shape.b * shape.h;
    Polygon outline = box(-2 * shape.b, 0, 0, 2 * shape.h);
    for (Vec2& p : outline) p = Turn(-start).apply(p);
    BodySpec spec;
    spec.name = "block", spec.outline = outline, spec.mass = mass, spec.inertia = mass * shape.inertia;
    scene.add(spec);
    Simulation<2> sim = scene.start();
    const int n = node_of(sim.model(), "block");
    // Potential energy from the start tilt to the flat position.
    const double swings =
        mass * standard_gravity * shape.radius() * (std::cos(shape.angle() - start) - std::cos(shape.angle()));
    double before = start, spin = 0;
    StageOptions told = stage;
    told.energy_interval = 1e-3;
    RunListener<2> listener = each_step([&](const Instant<2>& now) {
      const double tilt = start - now.state.rotation[n];
      if (before * tilt <= 0 && before != 0) {
        if (++landings == 1) lands = now.state.time - now.state.last_dt * tilt / (tilt - before), rate = spin;
      }
      if (landings == 1) other_peak = std::max(other_peak, -tilt);
      if (tilt != 0) before = tilt;
      if (tilt > 2e-4) spin = now.state.spin[n];  // only the corner is in contact
    });
    double first = 0;
    bool begun = false;
    listener.on_energy = [&](const Instant<2>&, const Energy& e) {
      const double all = e[EnergyTerm::kinetic] + e[EnergyTerm::gravity] + e[EnergyTerm::contact_elastic];
      if (!begun) first = all, begun = true;
      highest = std::max(highest, (all - first) / swings);
    };
    const StageReport report = sim.run(told, listener);
    end = report.end, steps = report.steps;
  }
  /// Square root of the share of energy that remains after the first landing.
  [[nodiscard]] double restitution(const TiltedBlock& shape, double q) const {
    const double al = shape.angle();
    return std::sqrt((std::cos(al - other_peak) - std::cos(al)) / (std::cos(al - q * al) - std::cos(al)));
  }
};

TEST_CASE("I12: with implicit steps of 1 ms a block lands at the time of the pendulum equation and gains no energy") {
  struct Case {
    std::string row;
    TiltedBlock shape;
    double q, expected;
  };
  const TiltedBlock k4 = plane_block(0.4, 1.2), k5 = plane_block(0.5, 2.0);
  // A block that falls about a corner stays in the plane of its diagonal, where it equals a plane block of this width
  // and its own inertia.
  const TiltedBlock t30{std::sqrt(0.08), 0.6, (0.04 + 0.36) / 3};
  CHECK(near(t30.landing(0.25), .96906, 1e-5));
  CHECK(near(t30.landing(0.5), 1.27205, 1e-5));
  CHECK(near(t30.landing(0.75), 1.42437, 1e-5));
  CHECK(near(t30.angle() / degree, 25.2394, 1e-5));
  CHECK(near(t30.p(), 3.36837, 1e-5));
  for (const Case& c : {Case{"K4", k4, 0.25, .2345}, Case{"K4", k4, 0.5, .3874}, Case{"K4", k4, 0.75, .6059},
                        Case{"K4", k4, 0.9, .8784}, Case{"K5", k5, 0.25, .2987}, Case{"K5", k5, 0.5, .4939},
                        Case{"K5", k5, 0.75, .7731}, Case{"T30", t30, 0.25, .23855}, Case{"T30", t30, 0.5, .39321},
                        Case{"T30", t30, 0.75, .61422}}) {
    const RockingRun r(c.shape, c.q, adaptive_stage(AlphaMethod::hht(-0.05), 3.5 * c.expected, 1e-3));
    MESSAGE(
        fmt::format("I12, {} q {}: lands at {:.5f} s ({}) with {:.5f} rad/s ({:.5f}), e {:.4f}; {} landings, {} "
                    "steps, energy at most {:.1e} above its start",
                    c.row, c.q, r.lands, c.expected, r.rate, c.shape.landing(c.q), r.restitution(c.shape, c.q),
                    r.landings, r.steps, r.highest));
    CHECK(r.end == StageEnd::time);
    CHECK(near(r.lands, c.expected, 0.01));
    CHECK(near(r.rate, c.shape.landing(c.q), 0.01));
    CHECK(r.landings >= 2);
    CHECK(r.restitution(c.shape, c.q) < 1);
    CHECK(r.highest < 1e-6);
  }
}

}  // namespace
}  // namespace trilith::testing
