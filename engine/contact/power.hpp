// Contact that stiffens as it closes: a power of the overlap, as of rough faces, dry joints and rounded bodies.
//
// sigma = kn d (delta/d)^n: kn is the secant stiffness at the overlap d ("depth"), n = 1 is linear, n = 3/2 the
// exponent of Hertz for two spheres ("On the contact of elastic solids", J. reine angew. Math. 92, 1882). Friction and
// shear are those of contact/coulomb.hpp; the damping stress is kn beta d(delta)/dt, cut off where the sum would pull.
// Integrals are taken by Gauss's rule.
#pragma once

#include <array>
#include <cmath>

#include "base/portable.hpp"
#include "base/schema.hpp"
#include "contact/coulomb.hpp"

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

struct Power::Kernel : Coulomb {
  static constexpr bool linear = false;
  double depth, exponent;

  Kernel(const Power& law, double thickness, double step)
      : Coulomb(law, thickness, step), depth(law.depth), exponent(law.exponent) {}

  /// The overlap at which a linear spring of stiffness kn would press as much [m].
  [[nodiscard]] double effective(double overlap) const {
    const double share = overlap > 0 ? overlap / depth : 0;
    if (exponent == 1.5) return depth * share * std::sqrt(share);
    return depth * portable::pow(share, exponent);
  }
  [[nodiscard]] TRILITH_INLINE Lanes effective(const Lanes& overlap) const {
    Lanes e;
    for (int i = 0; i < lane_count; ++i) e[i] = effective(overlap[i]);
    return e;
  }

  template <class T>
  TRILITH_INLINE void press(const HalfState<T>* halves, T* active, HalfResponse<T>* out) const;
  template <class T>
  [[nodiscard]] TRILITH_INLINE StretchPressure<T> stretch(T d0, T d1, T c0, T c1) const;
  [[nodiscard]] double over(double area, double d0, double d1, double d2) const;
  [[nodiscard]] double stored(const HalfGaps& gaps, double length, double hold) const;
  [[nodiscard]] HalfPressure pressure(const HalfGaps& gaps, double length, double hold) const;
  [[nodiscard]] ContactTangent tangent(double overlap) const {
    const double share = std::max(overlap, depth) / depth;
    return {kn * exponent * portable::pow(share, exponent - 1), ks, beta};
  }

 private:
  static constexpr std::array<double, 4> point{0.06943184420297371, 0.33000947820757187, 0.66999052179242813,
                                               0.93056815579702629};  // of Gauss, on 0 to 1
  static constexpr std::array<double, 4> weight{0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                                0.17392742256872693};

  /// Integrals of the elastic pressure over kn, and of that with its damping, over a part of a half or stretch on which
  /// overlap and closing speed are linear from d0 to d1 and from c0 to c1.
  template <class T>
  TRILITH_INLINE void integrate(T d0, T d1, T c0, T c1, T from, T to, LinearStress<T>& elastic,
                                LinearStress<T>& total) const;
};

template <class T>
TRILITH_INLINE void Power::Kernel::integrate(T d0, T d1, T c0, T c1, T from, T to, LinearStress<T>& elastic,
                                             LinearStress<T>& total) const {
  const T zero{};
  elastic = total = {zero, zero, zero, zero};
  for (std::size_t i = 0; i < point.size(); ++i) {
    const T s = from + point[i] * (to - from), width = weight[i] * (to - from);
    const T spring = effective(d0 + s * (d1 - d0)), pressed = larger(zero, spring + beta * (c0 + s * (c1 - c0)));
    elastic.sum += width * spring, elastic.moment += width * s * spring;
    total.sum += width * pressed, total.moment += width * s * pressed;
  }
}

template <class T>
TRILITH_INLINE void Power::Kernel::press(const HalfState<T>* halves, T* active, HalfResponse<T>* out) const {
  for (const int h : {0, 1}) {
    const HalfState<T>& half = halves[h];
    const PositivePart<T> closed(-half.g0, -half.g1);
    HalfStress<T> stress(half, beta, closed.from, closed.to, closed.from, closed.to);
    integrate(-half.g0, -half.g1, -half.r0, -half.r1, closed.from, closed.to, stress.elastic, stress.total);
    active[h] = closed.to - closed.from;
    stress.write(half, kn, out[h]);
  }
}

template <class T>
TRILITH_INLINE StretchPressure<T> Power::Kernel::stretch(T d0, T d1, T c0, T c1) const {
  const T zero{}, one = zero + 1.0;
  StretchPressure<T> out{{zero, zero, zero, zero}, {zero, zero, zero, zero}};
  integrate(d0, d1, c0, c1, zero, one, out.spring, out.total);
  return out;
}

/// Six points, exact to degree 4 (Dunavant, "High degree efficient symmetrical Gaussian quadrature rules for the
/// triangle", Int. J. Numer. Meth. Engng 21, 1985).
inline double Power::Kernel::over(double area, double d0, double d1, double d2) const {
  constexpr double near_a = 0.108103018168070, far_a = 0.445948490915965, weight_a = 0.223381589678011;
  constexpr double near_b = 0.816847572980459, far_b = 0.091576213509771, weight_b = 0.109951743655322;
  const auto at = [&](double a, double b, double c) { return effective(a * d0 + b * d1 + c * d2); };
  return area * (weight_a * (at(near_a, far_a, far_a) + at(far_a, near_a, far_a) + at(far_a, far_a, near_a)) +
                 weight_b * (at(near_b, far_b, far_b) + at(far_b, near_b, far_b) + at(far_b, far_b, near_b)));
}

/// The work of the pressure: an overlap takes effective(overlap) overlap / (exponent + 1).
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

inline HalfPressure Power::Kernel::pressure(const HalfGaps& gaps, double length, double /*hold*/) const {
  const PositivePart<double> closed(-gaps.g0, -gaps.g1);
  LinearStress<double> elastic(0, 0, 0, 0), total = elastic;
  integrate(-gaps.g0, -gaps.g1, 0.0, 0.0, closed.from, closed.to, elastic, total);
  return {kn * length * elastic.sum, kn * length * length * elastic.moment};
}

}  // namespace trilith
