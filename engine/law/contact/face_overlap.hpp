// Shared length of two opposed faces, and the gap along it.
//
// A's face runs from a.0 to a.1, B's from b.0 to b.1, each counter-clockwise around its body, so they run in opposite
// directions. Their common direction d weights both equally, and n = (dy, -dx) points from A to B. The coordinate s is
// measured along d from a.0. Written for T = double or Lanes.
#pragma once

#include "base/simd/lanes.hpp"

namespace trilith {

/// Limits within which two faces count as a face pair; beyond them the contact is a general one. At the transition the
/// energies differ by a share of these limits. At 0.005, elastic collisions of nearly parallel faces, and of wedges in
/// notches, conserve energy to half a percent.
inline constexpr double face_pair_max_tilt = 0.005;   ///< difference of slopes [1]
inline constexpr double face_pair_max_depth = 0.005;  ///< overlap over shared length [1]

/// Positions [m] and velocities [m/s] of the two ends of a face.
template <class T>
struct FaceEnds {
  T x0, y0, x1, y1;
  T u0, v0, u1, v1;
};

template <class T>
struct FaceOverlap {
  T dx, dy;          ///< d
  T sb1;             ///< s of b.1, the end of B's face with the lower s [m]
  T inv_a, inv_b;    ///< 1 / length of each face along d [1/m]
  T lo, hi, shared;  ///< s at both ends of the shared length, and the length [m]
  T gap_lo, gap_hi;  ///< gap along n at both ends, negative where overlapping [m]
  T tilt;            ///< difference of the slopes of the faces [1]
  Mask<T> sane;      ///< the faces oppose each other and share some length

  FaceOverlap() = default;
  TRILITH_INLINE FaceOverlap(const FaceEnds<T>& a, const FaceEnds<T>& b) {
    const T zero{}, one = zero + 1.0;
    const T dxa = a.x1 - a.x0, dya = a.y1 - a.y0;
    dx = dxa - (b.x1 - b.x0);
    dy = dya - (b.y1 - b.y0);
    const T scale = one / root(dx * dx + dy * dy);
    dx *= scale;
    dy *= scale;
    const T sa1 = dx * dxa + dy * dya, ha1 = dy * dxa - dx * dya;
    const T rx0 = b.x0 - a.x0, ry0 = b.y0 - a.y0, rx1 = b.x1 - a.x0, ry1 = b.y1 - a.y0;
    const T sb0 = dx * rx0 + dy * ry0, hb0 = dy * rx0 - dx * ry0;
    const T hb1 = dy * rx1 - dx * ry1;
    sb1 = dx * rx1 + dy * ry1;
    const T length_b = sb0 - sb1, inverse = one / (sa1 * length_b);  // one division for both
    inv_a = length_b * inverse;
    inv_b = sa1 * inverse;
    lo = larger(zero, sb1);
    hi = smaller(sa1, sb0);
    shared = hi - lo;
    const T slope_a = ha1 * inv_a, slope_b = (hb0 - hb1) * inv_b;
    gap_lo = hb1 + slope_b * (lo - sb1) - slope_a * lo;
    gap_hi = hb1 + slope_b * (hi - sb1) - slope_a * hi;
    tilt = magnitude(slope_b - slope_a);
    sane = (sa1 > zero) & (sb0 > sb1) & (shared > zero);
  }

  /// True where the overlap is so shallow and the faces so parallel that no other faces of the two pieces matter.
  TRILITH_INLINE Mask<T> is_flat(T corner) const {
    const T depth = -smaller(gap_lo, gap_hi);
    return (tilt < face_pair_max_tilt + T{}) & (depth * corner <= shared * face_pair_max_depth);
  }
};

}  // namespace trilith
