// A contact law defined by its equations at one point, which every geometry integrates.
//
//     sigma = kn (e(delta) + beta d(delta)/dt), never below 0        e = effective(delta) [m], delta the overlap
//     |tau| <= mu(sigma, v) sigma                                    mu = friction(sigma, v), v the slip speed
//
// A kernel K that derives from PointLaw<K> defines `effective` or `friction` for scalars. PointLaw makes from them the
// members used by faces and polygons in the plane (law/contact/coulomb.hpp). The pressure is integrated by Gauss
// quadrature; friction acts on the resultant of a half or of a contact. Flat faces, polyhedra and spheres in space call
// `effective` and `friction` directly. A pressure of kn times the overlap keeps the closed forms of Coulomb.
#pragma once

#include <array>
#include <concepts>
#include <type_traits>

#include "law/contact/coulomb.hpp"

namespace trilith {

/// The class that declares a member function, from a pointer to it.
template <class C, class R, class... A>
std::type_identity<C> owner_of(R (C::*)(A...) const);

/// Whether a kernel overrides pressure or friction.
template <class K>
inline constexpr bool has_own_effective = !requires {
  { owner_of(&K::effective) } -> std::same_as<std::type_identity<Coulomb>>;
};
template <class K>
inline constexpr bool has_own_friction = !requires {
  { owner_of(&K::friction) } -> std::same_as<std::type_identity<Coulomb>>;
};

/// effective() of a law, for one overlap or four. A law may evaluate four at once by `effective_four`, with the bits of
/// `effective` in each lane.
template <class K>
[[nodiscard]] TRILITH_INLINE double effective_of(const K& law, double overlap) {
  return law.effective(overlap);
}
template <class K>
[[nodiscard]] TRILITH_INLINE Lanes effective_of(const K& law, const Lanes& overlap) {
  if constexpr (requires { law.effective_four(overlap); }) {
    return law.effective_four(overlap);
  } else {
    Lanes e;
    for (int i = 0; i < lane_count; ++i) e[i] = law.effective(overlap[i]);
    return e;
  }
}

/// Friction limit under a normal force [N] over a size [m2, or m times the thickness]. `speed()`: slip rate [m/s],
/// called only for laws that depend on it.
template <class K, class Speed>
[[nodiscard]] TRILITH_INLINE double friction_limit_of(const K& law, double normal, double area, Speed&& speed) {
  if constexpr (has_own_friction<K>)
    return normal > 0 && area > 0 ? law.friction(normal / area, speed()) * normal : 0;
  else
    return law.mu * normal;
}

template <class K>
struct PointLaw : Coulomb {
  double thickness;  ///< of the bodies in the plane, 1 in space [m]

  template <class L>
  PointLaw(const L& law, double thick, double step) : Coulomb(law, thick, step), thickness(thick) {}

  static constexpr bool linear = !has_own_effective<K>;

  template <class T>
  TRILITH_INLINE void press(const HalfState<T>* halves, T* active, HalfResponse<T>* out) const;
  template <class T>
  TRILITH_INLINE T slide(HalfState<T>& half, T active, const ShearBefore<T>& before, HalfResponse<T>& out) const;
  template <class T>
  [[nodiscard]] TRILITH_INLINE StretchPressure<T> stretch(T d0, T d1, T c0, T c1) const;
  [[nodiscard]] double over(double area, double d0, double d1, double d2) const;
  [[nodiscard]] double stored(const HalfGaps& gaps, double length, double hold) const;
  [[nodiscard]] HalfPressure pressure(const HalfGaps& gaps, double length, double hold) const;

 protected:
  static constexpr std::array<double, 4> point{0.06943184420297371, 0.33000947820757187, 0.66999052179242813,
                                               0.93056815579702629};  // of Gauss quadrature, on 0 to 1
  static constexpr std::array<double, 4> weight{0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                                0.17392742256872693};

  [[nodiscard]] const K& self() const { return static_cast<const K&>(*this); }
  /// Integrals of the elastic pressure over kn, without and with damping, over a part of a half or section. Overlap and
  /// closing speed are linear on it, from d0 to d1 and from c0 to c1.
  template <class T>
  TRILITH_INLINE void integrate(T d0, T d1, T c0, T c1, T from, T to, LinearStress<T>& elastic,
                                LinearStress<T>& total) const;
  /// Work to reach an overlap, divided by kn [m2].
  [[nodiscard]] double work(double overlap) const {
    double sum = 0;
    for (std::size_t i = 0; i < point.size(); ++i) sum += weight[i] * self().effective(point[i] * overlap);
    return sum * overlap;
  }
};

template <class K>
template <class T>
TRILITH_INLINE void PointLaw<K>::integrate(T d0, T d1, T c0, T c1, T from, T to, LinearStress<T>& elastic,
                                           LinearStress<T>& total) const {
  const T zero{};
  elastic = total = {zero, zero, zero, zero};
  for (std::size_t i = 0; i < point.size(); ++i) {
    const T s = from + point[i] * (to - from), width = weight[i] * (to - from);
    const T spring = effective_of(self(), T(d0 + s * (d1 - d0))),
            pressed = larger(zero, spring + beta * (c0 + s * (c1 - c0)));
    elastic.sum += width * spring, elastic.moment += width * s * spring;
    total.sum += width * pressed, total.moment += width * s * pressed;
  }
}

template <class K>
template <class T>
TRILITH_INLINE void PointLaw<K>::press(const HalfState<T>* halves, T* active, HalfResponse<T>* out) const {
  if constexpr (linear)
    Coulomb::press(halves, active, out);
  else
    for (const int h : {0, 1}) {
      const HalfState<T>& half = halves[h];
      const PositivePart<T> closed(-half.g0, -half.g1);
      HalfStress<T> stress(half, beta, closed.from, closed.to, closed.from, closed.to);
      integrate(-half.g0, -half.g1, -half.r0, -half.r1, closed.from, closed.to, stress.elastic, stress.total);
      active[h] = closed.to - closed.from;
      stress.write(half, kn, out[h]);
    }
}

template <class K>
template <class T>
TRILITH_INLINE T PointLaw<K>::slide(HalfState<T>& half, T active, const ShearBefore<T>& before,
                                    HalfResponse<T>& out) const {
  if constexpr (!has_own_friction<K>) {
    return Coulomb::slide(half, active, before, out);
  } else if constexpr (std::is_same_v<T, double>) {
    const double limit =
        friction_limit_of(self(), out.normal, active * thickness, [&] { return magnitude(half.slip_rate); });
    return slide_within<T>(limit, half, active, before, out);
  } else {
    T limit{};
    for (int i = 0; i < lane_count; ++i)
      limit[i] =
          friction_limit_of(self(), out.normal[i], active[i] * thickness, [&] { return magnitude(half.slip_rate[i]); });
    return slide_within<T>(limit, half, active, before, out);
  }
}

template <class K>
template <class T>
TRILITH_INLINE StretchPressure<T> PointLaw<K>::stretch(T d0, T d1, T c0, T c1) const {
  if constexpr (linear) {
    return Coulomb::stretch(d0, d1, c0, c1);
  } else {
    const T zero{}, one = zero + 1.0;
    StretchPressure<T> out{{zero, zero, zero, zero}, {zero, zero, zero, zero}};
    integrate(d0, d1, c0, c1, zero, one, out.spring, out.total);
    return out;
  }
}

/// Six points, exact to degree 4 (Dunavant, "High degree efficient symmetrical Gaussian quadrature rules for the
/// triangle", Int. J. Numer. Meth. Engng 21, 1985).
template <class K>
double PointLaw<K>::over(double area, double d0, double d1, double d2) const {
  if constexpr (linear) {
    return Coulomb::over(area, d0, d1, d2);
  } else {
    constexpr double near_a = 0.108103018168070, far_a = 0.445948490915965, weight_a = 0.223381589678011;
    constexpr double near_b = 0.816847572980459, far_b = 0.091576213509771, weight_b = 0.109951743655322;
    const auto at = [&](double a, double b, double c) { return self().effective(a * d0 + b * d1 + c * d2); };
    return area * (weight_a * (at(near_a, far_a, far_a) + at(far_a, near_a, far_a) + at(far_a, far_a, near_a)) +
                   weight_b * (at(near_b, far_b, far_b) + at(far_b, near_b, far_b) + at(far_b, far_b, near_b)));
  }
}

template <class K>
double PointLaw<K>::stored(const HalfGaps& gaps, double length, double hold) const {
  if constexpr (linear) {
    return Coulomb::stored(gaps, length, hold);
  } else {
    const PositivePart<double> closed(-gaps.g0, -gaps.g1);
    double sum = 0;
    for (std::size_t i = 0; i < point.size(); ++i) {
      const double s = closed.from + point[i] * (closed.to - closed.from);
      sum += weight[i] * (closed.to - closed.from) * work(std::max(0.0, -gaps.g0 - s * (gaps.g1 - gaps.g0)));
    }
    return kn * length * sum;
  }
}

template <class K>
HalfPressure PointLaw<K>::pressure(const HalfGaps& gaps, double length, double hold) const {
  if constexpr (linear) {
    return Coulomb::pressure(gaps, length, hold);
  } else {
    const PositivePart<double> closed(-gaps.g0, -gaps.g1);
    LinearStress<double> elastic(0, 0, 0, 0), total = elastic;
    integrate(-gaps.g0, -gaps.g1, 0.0, 0.0, closed.from, closed.to, elastic, total);
    return {kn * length * elastic.sum, kn * length * length * elastic.moment};
  }
}

}  // namespace trilith
