// Maxwell damper: a spring and a dashpot in series, such as a damper on a brace, or one with compressible oil.
//
// Spring: f' = k (v - u). Dashpot: f = F (|u| / v0)^a in the direction of its velocity u. Maxwell, "On the dynamical
// theory of gases", Phil. Trans. R. Soc. 157, 1867; for dampers Constantinou and Symans, Report NCEER-92-0032, 1992.
//
// At constant velocity over the step a linear dashpot is integrated exactly. For others the step's mean force moves the
// dashpot by exactly the displacement that the spring leaves (implicit midpoint). The dissipated energy is mean force
// times this displacement, never negative. The spring limits the time step, whatever the dashpot. Memory: `inner` is
// the position of the dashpot.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/portable.hpp"
#include "base/schema.hpp"
#include "law/bearing/direction.hpp"

namespace trilith {

struct Maxwell {
  double stiffness = 0;  ///< k [N/m]
  double force = 0;      ///< F [N]
  double speed = 0;      ///< v0 [m/s]
  double exponent = 0;   ///< a [1]

  static constexpr std::string_view name = "maxwell";
  static constexpr std::string_view sentence = "viscous damper in series with a spring";
  static constexpr auto parameters() {
    using P = Parameter<Maxwell>;
    return std::array{
        P{&Maxwell::stiffness, "stiffness", "N/m", no_default, 0, unbounded, false,
          "stiffness of the spring: brace, column of oil"},
        P{&Maxwell::force, "force", "N", no_default, 0, unbounded, false, "force of the dashpot at `speed`"},
        P{&Maxwell::speed, "speed", "m/s", 1, 0, unbounded, false, "with 1 m/s, `force` is C of f = C v^exponent"},
        P{&Maxwell::exponent, "exponent", "1", 1, 0.05, 1, true,
          "1: a linear dashpot; of oil dampers mostly 0.2 to 1"}};
  }
  [[nodiscard]] double tangent() const { return stiffness; }
  [[nodiscard]] double dashpot() const { return 0; }
  /// A damper that becomes live later starts unstressed at its current displacement.
  [[nodiscard]] static DirectionMemory begin_at(double displacement) {
    DirectionMemory memory;
    memory.inner = displacement;
    return memory;
  }

  [[nodiscard]] DirectionResponse respond(const DirectionMotion& m, const DirectionMemory& before) const {
    const double held = stiffness * (m.displacement - before.inner);  // force if the dashpot did not move
    DirectionResponse out;
    out.memory.force = exponent == 1 ? relaxed(before.force, held, m.dt)
                                     : 2 * mean_force(0.5 * (before.force + held), m.dt) - before.force;
    out.memory.inner = m.displacement - out.memory.force / stiffness;
    const double moved = out.memory.inner - before.inner;
    out.memory.travelled = before.travelled + std::abs(moved);
    out.stored = 0.5 * out.memory.force * out.memory.force / stiffness;
    out.lost_damping = 0.5 * (out.memory.force + before.force) * moved;
    return out;
  }

 private:
  /// Force after `dt` with a linear dashpot: `last` is the force before, `held` the force of the spring alone.
  [[nodiscard]] double relaxed(double last, double held, double dt) const {
    const double x = dt * stiffness * speed / force, kept = portable::exp(-x);
    const double mean = x < 1e-4 ? 1 - x / 2 * (1 - x / 3 * (1 - x / 4)) : (1 - kept) / x;  // of exp(-s), 0 < s < x
    return last * kept + (held - last) * mean;
  }
  /// f where f + k dt/2 u(f) = goal. Relative to F the left side g + r g^p is convex, so Newton's method converges from
  /// above, starting where either term alone reaches the goal.
  [[nodiscard]] double mean_force(double goal, double dt) const {
    const double size = std::abs(goal) / force, r = 0.5 * stiffness * dt * speed / force, p = 1 / exponent;
    if (!(size > 0) || !(r > 0)) return goal;
    double g = std::min(size, portable::pow(size / r, exponent));
    for (int i = 0; i < 60; ++i) {
      const double term = r * portable::pow(g, p - 1);
      const double change = (g + term * g - size) / (1 + p * term);
      if (!(change > 1e-15 * g)) break;
      g -= change;
    }
    return std::copysign(g * force, goal);
  }
};

}  // namespace trilith
