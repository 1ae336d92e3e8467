// Contact that stiffens as it closes: a power of the overlap, for rough faces, dry joints and rounded bodies.
//
// Pressure: sigma = kn d (delta/d)^n, where kn is the secant stiffness at the overlap d ("depth"). The exponent n = 1
// is linear; n = 3/2 holds for two spheres (Hertz, "On the contact of elastic solids", J. reine angew. Math. 92, 1882).
// Friction and shear follow law/contact/coulomb.hpp. The damping stress is kn beta d(delta)/dt, cut off where the sum
// would be tension. Integrals use Gauss quadrature (law/contact/point_law.hpp).
#pragma once

#include <array>

#include "base/portable.hpp"
#include "base/schema.hpp"
#include "base/simd/lane_powers.hpp"
#include "law/contact/point_law.hpp"

namespace trilith {

struct Power {
  double kn = 0;        ///< [Pa/m]
  double depth = 0;     ///< [m]
  double exponent = 0;  ///< [1]
  double ks = 0;        ///< [Pa/m]
  double mu = 0;        ///< tan of the friction angle
  double beta = 0;      ///< [s]

  static constexpr std::string_view name = "power";
  static constexpr std::string_view sentence = "contact that stiffens with a power of the overlap, Coulomb friction";
  static constexpr auto parameters() {
    using P = Parameter<Power>;
    return std::array{
        P{&Power::kn, "kn", "Pa/m", no_default, 0, unbounded, false, "stress over overlap at the overlap `depth`"},
        P{&Power::depth, "depth", "m", no_default, 0, unbounded, false,
          "overlap at which the stiffness is kn; small compared with the bodies; it sets the time step"},
        P{&Power::exponent, "exponent", "1", 1.5, 1, 3, true, "exponent of the overlap: 1 linear, 1.5 Hertz"},
        P{&Power::ks, "ks", "Pa/m", no_default, 0, unbounded, true, "shear stiffness, stress per elastic slip"},
        P{&Power::mu, "mu", "1", no_default, 0, 100, true, "friction coefficient, tan of the friction angle"},
        P{&Power::beta, "beta", "s", 0, 0, 1, true, "damping stress per stiffness and velocity"}};
  }

  struct Kernel;
};

struct Power::Kernel : PointLaw<Power::Kernel> {
  double depth, exponent;

  Kernel(const Power& law, double thick, double step)
      : PointLaw(law, thick, step), depth(law.depth), exponent(law.exponent) {}

  /// The overlap at which a linear spring of stiffness kn has the same pressure [m].
  [[nodiscard]] double effective(double overlap) const { return effective_at(overlap); }
  [[nodiscard]] TRILITH_INLINE Lanes effective_four(const Lanes& overlap) const { return effective_at(overlap); }
  [[nodiscard]] double stored(const HalfGaps& gaps, double length, double hold) const;
  [[nodiscard]] ContactTangent tangent(double overlap) const {
    const double share = std::max(overlap, depth) / depth;
    return {kn * exponent * portable::pow(share, exponent - 1), ks, beta};
  }

 private:
  /// For one overlap or four. The usual exponents need no power.
  template <class T>
  [[nodiscard]] TRILITH_INLINE T effective_at(const T& overlap) const {
    const T share = larger<T>(overlap, T{}) / depth;
    if (exponent == 1.5) return depth * share * root(share);
    if (exponent == 1) return depth * share;
    if (exponent == 2) return depth * share * share;
    return depth * power_of_positive<T>(share, exponent);
  }
};

/// Work of the pressure: effective(overlap) overlap / (exponent + 1).
inline double Power::Kernel::stored(const HalfGaps& gaps, double length, double /*hold*/) const {
  const PositivePart<double> closed(-gaps.g0, -gaps.g1);
  double sum = 0;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const double s = closed.from + point[i] * (closed.to - closed.from);
    const double overlap = std::max(0.0, -gaps.g0 - s * (gaps.g1 - gaps.g0));
    sum += weight[i] * (closed.to - closed.from) * effective(overlap) * overlap;
  }
  return kn * length * sum / (exponent + 1);
}

}  // namespace trilith
