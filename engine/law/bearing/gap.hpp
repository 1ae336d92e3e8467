// Gap: no force until the displacement exceeds `opening` in the direction of `side`, then a linear spring and a
// dashpot.
//
// f = k (|d| - g) + c |d|' in the direction of d, where |d| > g; never negative in that direction unless `pull` allows
// it. The linear viscoelastic model of pounding in its first form: Anagnostopoulos, Earthquake Eng. Struct. Dyn. 16,
// 1988.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/schema.hpp"
#include "law/bearing/direction.hpp"

namespace trilith {

struct Gap {
  double stiffness = 0;  ///< [N/m]
  double opening = 0;    ///< [m]
  double damping = 0;    ///< [N s/m]
  double side = 0;       ///< +1, -1, or 0 for both
  double pull = 0;       ///< 0 or 1

  static constexpr std::string_view name = "gap";
  static constexpr std::string_view sentence = "free play, then a linear spring with a dashpot that does not pull";
  static constexpr auto parameters() {
    using P = Parameter<Gap>;
    return std::array{
        P{&Gap::stiffness, "stiffness", "N/m", no_default, 0, unbounded, false,
          "force per displacement beyond the gap"},
        P{&Gap::opening, "opening", "m", no_default, 0, unbounded, true, "displacement at which the gap closes"},
        P{&Gap::damping, "damping", "N s/m", 0, 0, unbounded, true, "force per velocity while closed"},
        P{&Gap::side, "side", "1", 0, -1, 1, true, "+1 or -1: closes in that direction only; 0: in both"},
        P{&Gap::pull, "pull", "1", 0, 0, 1, true,
          "0: the dashpot reduces the force to 0 at most; 1: it may pull until the gap opens"}};
  }
  [[nodiscard]] double tangent() const { return stiffness; }
  [[nodiscard]] double dashpot() const { return damping; }

  [[nodiscard]] DirectionResponse respond(const DirectionMotion& m, const DirectionMemory& before) const {
    DirectionResponse out;
    const double sign = m.displacement < 0 ? -1 : 1;
    const double beyond = std::abs(m.displacement) - opening;
    const bool closed = beyond > 0 && sign * side >= 0;
    if (closed) {
      out.memory.force = sign * stiffness * beyond;
      out.stored = 0.5 * stiffness * beyond * beyond;
      const double total = out.memory.force + damping * m.rate;
      out.memory.damping = pull > 0 || total * sign > 0 ? damping * m.rate : -out.memory.force;
    }
    out.lost_damping = 0.5 * (out.memory.damping + before.damping) * m.mean * m.dt;
    return out;
  }
};

}  // namespace trilith
