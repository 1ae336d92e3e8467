// The friction limit of an area that slides and turns at once, depending on the shape of the area.
//
// The force V in the plane is relative to mu N, and the couple T to mu N a (contact/joint/friction_limit.hpp). The
// limit is
//
//     m = 2 V.AV + |V|^2 (|V|^2 - 2 V.AV) + T^2 (1 + V.CV) = 1.
//
// It is 1 for V alone in any direction and for T alone. A = I/2 and C = 0 give the ellipse. A long line with V acting
// across it has a = 1 and c = 0 exactly, T = 1 - V^2. In between, A and C depend on the tensor D: twice the area's
// second moments divided by their trace, minus the identity. Its principal values are +d along the length and -d across
// it, with d = (r^2 - 1) / (r^2 + 1) for a rectangle r : 1.
//
//     A = (0.629 - 0.021 d^2 - 0.005 d^4) I - (0.423 - 0.047 d^2) D
//     C = (0.236 - 0.163 d^2 + 0.047 d^4) I + (0.415 - 0.345 d^2) D
//
// For a uniform pressure on a rectangle from 1 : 1 to 5 : 1 that turns about any point of its axes of symmetry, V and T
// are accurate to 0.016 (1.6 % of their largest values). The limit is convex for all r.
#pragma once

#include <array>

#include "base/simd/lane_vectors.hpp"
#include "contact/joint/friction_limit.hpp"
#include "contact/joint/shear_3d.hpp"

namespace trilith {

/// A symmetric tensor in two axes in the contact plane.
template <class T>
struct LimitTensor {
  T xx, xy, yy;

  [[nodiscard]] TRILITH_INLINE Pair2<T> applied(const T& x, const T& y) const {
    return {xx * x + xy * y, xy * x + yy * y};
  }
};
/// A and C in these axes.
template <class T>
struct LimitShape {
  LimitTensor<T> a, c;
};
inline constexpr double square_slide = 0.629, square_turn = 0.236;  ///< a and c of a square
inline constexpr LimitShape<double> square_limit{{square_slide, 0, square_slide}, {square_turn, 0, square_turn}};
inline constexpr double most_turn = 0.45;  ///< upper bound of c; the upper bound of a is 1

/// A = a I - along_a B and C = c I - along_c B with B = I + D = p p' + q q'; the two arms p and q have products that
/// sum to the second moments of the area.
template <class T>
struct LimitSpread {
  T a, along_a, c, along_c;
  Triple<T> p, q;

  TRILITH_INLINE LimitSpread() : a(T{} + square_slide), along_a{}, c(T{} + square_turn), along_c{}, p{}, q{} {}
  TRILITH_INLINE LimitSpread(const Triple<T>& one_arm, const Triple<T>& other_arm) {
    const T zero{}, one = zero + 1.0, trace = one_arm.square() + other_arm.square(), twice = 2.0 / trace;
    const T d2 = larger<T>(zero, one - twice * twice * cross(one_arm, other_arm).square());
    const Mask<T> wide = trace > zero;
    along_a = select(wide, 0.423 - 0.047 * d2, zero), along_c = select(wide, 0.345 * d2 - 0.415, zero);
    a = select(wide, square_slide - d2 * (0.021 + 0.005 * d2), zero + square_slide) + along_a;
    c = select(wide, square_turn - d2 * (0.163 - 0.047 * d2), zero + square_turn) + along_c;
    const T scale = select(wide, root(twice), zero);
    p = select<T>(wide, one_arm * scale, Triple<T>{}), q = select<T>(wide, other_arm * scale, Triple<T>{});
  }
  /// Squared ratio of an in-plane force and a couple to the limit along their ray; see beyond_curve. (Far beyond the
  /// limit m itself decreases again.)
  [[nodiscard]] TRILITH_INLINE T beyond_square(const Triple<T>& v, const T& turn) const {
    const T v2 = v.square(), t2 = turn * turn, along = p.dot(v), aside = q.dot(v), b = along * along + aside * aside,
            slide = 2.0 * (a * v2 - along_a * b), first = slide + t2,
            second = v2 * (v2 - slide) + t2 * (c * v2 - along_c * b);
    return 0.5 * (first + root(first * first + 4.0 * second));
  }
  [[nodiscard]] TRILITH_INLINE LimitShape<T> in(const Triple<T>& x, const Triple<T>& y) const {
    const T px = p.dot(x), py = p.dot(y), qx = q.dot(x), qy = q.dot(y);
    const T xx = px * px + qx * qx, xy = px * py + qx * qy, yy = py * py + qy * qy, none{};
    return {{a - along_a * xx, none - along_a * xy, a - along_a * yy},
            {c - along_c * xx, none - along_c * xy, c - along_c * yy}};
  }
};

/// The admissible friction force nearest to one beyond the limit: nearest_on_limit with `shape` in its axes.
Vec3 nearest_on_limit(const Vec3& spring, double lean, double reach, const LimitShape<double>& shape);

/// FrictionLimit of an area with the orientation given by two arms (spread_arms); of a square if the arms are zero.
struct AreaLimit : FrictionLimit {
  LimitSpread<double> spread;

  explicit AreaLimit(const FrictionLimit& square) : FrictionLimit(square) {}
  AreaLimit(double held, const Vec3& across, const Vec3& from_middle, double gyration, double mean_distance,
            const std::array<Vec3, 2>& arms);

  /// As in FrictionLimit.
  [[nodiscard]] bool is_below(const Vec3& spring) const;
  [[nodiscard]] Vec3 nearest_to(const Vec3& spring) const;
};

/// slide() of contact/joint/shear_3d.hpp with the limit of an area instead of the limit in `motion`.
SlidingResponse slide(const SlidingMotion& motion, const AreaLimit& limit, double area, const SlidingForce& before,
                      const SlidingLaw& law);

}  // namespace trilith
