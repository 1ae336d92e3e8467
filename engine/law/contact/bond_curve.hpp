// Traction of a bond at one point as a function of displacement, and the work of a step along it.
//
//     traction   top        . peak
//                          / \ .
//                         /   \___________
//                        /    last
//
// The first line has the slope of the remaining stiffness. The second falls to the traction carried by friction. A
// brittle bond drops to it at the peak.
//
// In both integrators a step does the work of the mean of the tractions at its ends. This is exact along one line and
// wrong where a step passes a corner: a step from the first line to the last does no work at all.
#pragma once

#include <algorithm>
#include <cmath>

namespace trilith {

/// Per unit length in the plane (tractions in [N/m]), per unit area in space ([Pa]).
struct BondCurve {
  double peak = 0;    ///< displacement at which softening begins or continues [m]
  double last = 0;    ///< displacement at which the bond is lost [m]
  double top = 0;     ///< traction at the peak
  double rest = 0;    ///< traction after the loss
  double whole = 0;   ///< displacement over which an intact bond is lost [m]
  double energy = 0;  ///< fracture energy of an intact bond

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
  /// Work of the law minus work of the mean traction, for a step that passes the peak.
  [[nodiscard]] double missing(double from, double to) const {
    if (!(to > peak) || !(to > from)) return 0;
    return work(to) - work(from) - 0.5 * (traction(from) + traction(to)) * (to - from);
  }
  /// Its size.
  [[nodiscard]] double missed(double from, double to) const { return std::abs(missing(from, to)); }
};

/// A displacement along a curve and its rate.
struct BondPlace {
  double at = 0, rate = 0;  ///< [m], [m/s]
};

/// Tension curve for a bond with the remaining strength share `strength`. K: the kernel of a law with bonds.
template <class K>
BondCurve tension_curve(const K& law, double strength) {
  const double first = law.first_opening();
  if constexpr (K::softens) {
    const double last = law.last_opening, range = last - first;
    return {last - strength * range, last, law.tension * strength, 0, last, 0.5 * law.tension * last};
  }
  return {first, first, law.tension, 0, first, 0.5 * law.tension * first};
}

/// Shear curve: the displacement is the present elastic slip plus all further slip. `closed`, `open`: mean overlap of
/// the closed part and mean opening of the rest [m].
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
