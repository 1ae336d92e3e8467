// The traction of a bond at one place against its displacement, and the work of a step along it.
//
//   traction   top        . peak                 The first line has the slope of the stiffness that is left; the second
//                        / \                     falls to the traction that friction holds. A brittle bond drops to it
//                       /   \___________         at the peak.
//                      /    last
//
// Steps of both integrators do the work of the mean of both tractions at the ends of a step. It is exact along one of
// the lines and wrong where a step passes a corner: a step from the first line to the last does no work at all.
#pragma once

#include <algorithm>
#include <cmath>

namespace trilith {

/// Per unit of length in the plane (tractions in N/m), of area in space (Pa).
struct BondCurve {
  double peak = 0;    ///< displacement at which softening begins or goes on [m]
  double last = 0;    ///< ... at which the bond is gone [m]
  double top = 0;     ///< traction at the peak
  double rest = 0;    ///< traction of what is gone
  double whole = 0;   ///< displacement over which an intact bond is lost [m]
  double energy = 0;  ///< of an intact bond that is lost

  [[nodiscard]] double traction(double u) const {
    if (u <= peak) return peak > 0 ? top * u / peak : 0;
    return u < last ? rest + (top - rest) * (last - u) / (last - peak) : rest;
  }
  /// Work from 0 to u.
  [[nodiscard]] double work(double u) const {
    if (u <= peak) return 0.5 * traction(u) * u;
    const double on = std::min(u, last);
    return 0.5 * top * peak + 0.5 * (top + (last > peak ? traction(on) : top)) * (on - peak) +
           rest * std::max(u - last, 0.0);
  }
  /// Difference between the work of the law and the work of the mean traction, of a step that goes past the peak.
  [[nodiscard]] double missed(double from, double to) const {
    if (!(to > peak) || !(to > from)) return 0;
    return std::abs(work(to) - work(from) - 0.5 * (traction(from) + traction(to)) * (to - from));
  }
};

/// A displacement along a curve and its rate.
struct BondPlace {
  double at = 0, rate = 0;  ///< [m], [m/s]
};

/// Of tension, with the share `strength` of its strength left. K: the kernel of a law with bonds.
template <class K>
BondCurve tension_curve(const K& law, double strength) {
  const double first = law.first_opening();
  if constexpr (K::softens) {
    const double last = law.last_opening, range = last - first;
    return {last - strength * range, last, law.tension * strength, 0, last, 0.5 * law.tension * last};
  }
  return {first, first, law.tension, 0, first, 0.5 * law.tension * first};
}

/// Of shear: the displacement counts the elastic slip that is there, and from there on all slip. `closed`, `open`: mean
/// overlap of the closed part and mean opening of the rest [m].
template <class K>
BondCurve shear_curve(const K& law, double strength, double closed, double open) {
  if (!(law.ks > 0) || !(law.cohesion > 0)) return {};
  const double friction = law.kn * law.mu * closed, first = law.cohesion / law.ks;
  const double top = std::max(law.shear_strength(closed, open) - law.cohesion * (1 - strength), friction);
  BondCurve curve{top / law.ks, top / law.ks, top, friction, first, 0.5 * law.cohesion * first};
  if constexpr (K::softens) {
    curve.last += strength * (law.last_slip - first);
    curve.whole = law.last_slip, curve.energy = 0.5 * law.cohesion * law.last_slip;
  }
  return curve;
}

}  // namespace trilith
