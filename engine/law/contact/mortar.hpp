// Bonded faces: the common part of brittle and softening bonds. Mortar that fills a joint where its faces were apart
// when it set, and integrals of the gaps that act on the bond of a half.
#pragma once

#include "law/contact/coulomb.hpp"

namespace trilith {

/// A kernel with cohesion and tension. Its memory has at least `set`: the gaps at both ends when the mortar set [m].
struct Mortar : Coulomb {
  double cohesion, tension;  ///< [N per m of length]

  template <class L>
  Mortar(const L& law, double thickness, double step)
      : Coulomb(law, thickness, step), cohesion(law.cohesion * thickness), tension(law.tension * thickness) {}

  static constexpr bool bonds = true;
  static constexpr bool softens = false;  ///< loses its strength gradually

  /// Loss of shear strength per tension [1]: the slope of the Coulomb line. If tension is beyond the line's apex, the
  /// slope of the line from cohesion to tension.
  [[nodiscard]] double tension_slope() const { return mu * tension > cohesion ? cohesion / tension : mu; }
  /// Opening at the tensile strength of an undamaged bond [m].
  [[nodiscard]] double first_opening() const { return tension / kn; }
  // The law at one point of a bond, for a half of two faces in the plane and for a patch of two faces in space.

  /// Shear strength at the mean overlap of the closed part and the mean opening of the rest [m].
  template <class T>
  [[nodiscard]] TRILITH_INLINE T shear_strength(T closed, T open) const {
    return cohesion + kn * (mu * closed - tension_slope() * open);
  }
  /// True where a brittle bond of this size is lost: by its largest opening [m] or by its shear [N].
  template <class T>
  [[nodiscard]] TRILITH_INLINE Mask<T> exceeded(T widest, T shear, T strength, T size) const {
    return (kn * widest > tension + T{}) | (shear > strength * size);
  }

  /// True where the opening of a half exceeds the limit: failure in tension, not in shear.
  [[nodiscard]] bool pulled(const std::array<HalfGaps, 2>& gaps) const {
    return std::any_of(gaps.begin(), gaps.end(), [&](const HalfGaps& half) {
      return std::max(half.g0 - half.filling.end0, half.g1 - half.filling.end1) > first_opening();
    });
  }

  template <class T>
  TRILITH_INLINE static void fill(FaceHalves<T>& halves, const T* set) {
    if (any((set[0] > T{}) | (set[1] > T{}))) halves.fill(set);
  }
};

/// Integral over a half of the product of two linear gaps as they act on a bond [m3]: the present gap, and the gap with
/// the ends `p0`, `p1` [m]. They count where both are open; each may close at another place of the half. `begin`,
/// `end`: part of the half over which it is integrated.
template <class T>
TRILITH_INLINE T open_product(const HalfState<T>& h, T p0, T p1, double begin = 0, double end = 1) {
  const T zero{};
  const PositivePart<T> now(h.g0, h.g1), then(p0, p1);
  const T from = larger(larger(now.from, then.from), zero + begin);
  const T to = larger(from, smaller(smaller(now.to, then.to), zero + end));
  const T rise = h.g1 - h.g0, rise_then = p1 - p0;
  const T g_from = h.g0 + rise * from, g_to = h.g0 + rise * to;
  const T p_from = p0 + rise_then * from, p_to = p0 + rise_then * to;
  const T open = (to - from) * (2.0 * (p_from * g_from + p_to * g_to) + p_from * g_to + p_to * g_from) * (1.0 / 6.0);
  const bool whole = begin == 0 && end == 1;
  const Filling<T> filling = whole ? h.filling : h.filling.within(begin, end);
  return h.length * (open + filling.product(h.g0, h.g1, p0, p1));
}

/// Mean over a half of the opening, counting closed parts as 0 [m].
template <class T>
TRILITH_INLINE T mean_opening(const HalfState<T>& h) {
  const T zero{}, one = zero + 1.0;
  const T b0 = h.bond0(), b1 = h.bond1();
  const T o0 = larger(b0, zero), o1 = larger(b1, zero), sum = o0 + o1, span = magnitude(b1 - b0);
  const Mask<T> crosses = (smaller(b0, b1) < zero) & (sum > zero);
  return 0.5 * sum * select(crosses, sum / select(crosses, span, one), one);
}

}  // namespace trilith
