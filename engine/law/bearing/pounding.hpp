// Pounding of two neighbours across a gap: a spring and a linear dashpot defined by the coefficient of restitution.
//
// The law of law/bearing/gap.hpp with c = 2 zeta sqrt(k m), m = m1 m2 / (m1 + m2), and zeta from the restitution e.
// Where the dashpot may pull until the gap opens: zeta = -ln e / sqrt(pi^2 + ln^2 e) (Anagnostopoulos, "Pounding of
// buildings in series during earthquakes", Earthquake Eng. Struct. Dyn. 16, 1988).
//
// Where the force ends at 0, for faces that do not stick: zeta = sin(a) with `tan(a) (pi - 2 a) = -ln e`. At critical
// damping the restitution is exp(-2). Source, two cases in one formula: Schwager and Poeschel, "Coefficient of
// restitution and linear-dashpot model revisited", Granular Matter 9, 2007.
#pragma once

#include <array>
#include <cmath>

#include "base/portable.hpp"
#include "law/bearing/gap.hpp"

namespace trilith {

struct Pounding {
  double stiffness = 0;    ///< [N/m]
  double opening = 0;      ///< [m]
  double restitution = 0;  ///< [1]
  double mass = 0;         ///< m1 m2 / (m1 + m2) [kg]
  double side = 0;         ///< +1, -1, or 0 for both
  double pull = 0;         ///< 0 or 1

  static constexpr std::string_view name = "pounding";
  static constexpr std::string_view sentence = "free play, then a spring and a dashpot with a given restitution";
  static constexpr auto parameters() {
    using P = Parameter<Pounding>;
    return std::array{
        P{&Pounding::stiffness, "stiffness", "N/m", no_default, 0, unbounded, false,
          "force per displacement beyond the gap"},
        P{&Pounding::opening, "opening", "m", no_default, 0, unbounded, true, "displacement at which the gap closes"},
        P{&Pounding::restitution, "restitution", "1", 0.65, 0.14, 1, true,
          "coefficient of restitution: separation speed over closing speed"},
        P{&Pounding::mass, "mass", "kg", no_default, 0, unbounded, false,
          "reduced mass m1 m2 / (m1 + m2) for the restitution; against the ground the mass of the body"},
        P{&Pounding::side, "side", "1", -1, -1, 1, true,
          "-1: closes in motion of the second point against the axis; +1: along it; 0: both"},
        P{&Pounding::pull, "pull", "1", 0, 0, 1, true,
          "0: the force ends at 0; 1: the dashpot may pull until the gap opens"}};
  }
  [[nodiscard]] double tangent() const { return stiffness; }
  [[nodiscard]] double dashpot() const { return 2 * damping_ratio() * std::sqrt(stiffness * mass); }

  [[nodiscard]] DirectionResponse respond(const DirectionMotion& m, const DirectionMemory& before) const {
    // The damping takes several tangents to compute, so it is evaluated only where there may be contact.
    const double damping = std::abs(m.displacement) > opening ? dashpot() : 0;
    return Gap{stiffness, opening, damping, side, pull}.respond(m, before);
  }

  /// Damping ratio that gives the restitution.
  [[nodiscard]] double damping_ratio() const {
    const double loss = -portable::log(restitution);
    if (pull > 0) return loss / std::sqrt(M_PI * M_PI + loss * loss);
    // Newton's method from 0: the left side is increasing and concave, so the root is never passed.
    double angle = 0;
    for (int i = 0; i < 50; ++i) {
      const double t = portable::tan(angle), open = M_PI - 2 * angle;
      const double change = (loss - t * open) / ((1 + t * t) * open - 2 * t);
      if (!(change > 1e-16)) break;
      angle += change;
    }
    return portable::sin(angle);
  }
};

}  // namespace trilith
