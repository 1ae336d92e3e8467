// Co-rotational formulation of an element.
//
// With the nodes X of the reference shape and the present nodes x, both relative to their mean, and the mean gradients
// g of the shape functions, F = sum x (x) g is the mean deformation gradient. The axes are rotated by R of its polar
// decomposition F = R U, with tan = (sum g cross x) / (sum g . x). In these axes the deformation d = R'x - X contains
// no rigid motion, however large. So a rigid rotation causes no strain, and a homogeneous stretch gives U - 1
// (Belytschko and Hsieh, "Non-linear transient finite element analysis with convected co-ordinates", Int. J. Numer.
// Meth. Engng 7, 1973; Felippa and Haugen, Comput. Methods Appl. Mech. Engng 194, 2005).
//
// Forces h conjugate to d give the nodal forces f = R (h - m/r left(g)), with m = sum (X + d) cross h and r = sum (R g)
// . x. The second term is the couple due to the rotation of the axes. f has no resultant and no moment about the
// present positions of the nodes. If h is the gradient of an energy, so is f.
#pragma once

#include <array>
#include <cmath>

#include "base/simd/lanes.hpp"
#include "base/space.hpp"

namespace trilith {

/// Positions or velocities of the nodes of one element, or of four elements in SIMD lanes.
template <int N, class T>
struct NodeColumns {
  T x[N], y[N];
};

/// Deformation of an element of N nodes in co-rotating axes, or of four elements of one shape.
template <int N, class T = double>
struct Deformation {
  T c, s;                ///< cosine and sine of the rotation of the axes
  T inverse;             ///< 1 / r [1]
  std::array<T, 8> d{};  ///< x0, y0, x1, ... [m]; rows beyond 2 N are 0

  /// `shape`: X and g, eight numbers each.
  TRILITH_INLINE Deformation(const double* shape, const NodeColumns<N, T>& place) {
    const double* const gradient = shape + 8;
    T mx{}, my{};
    for (int i = 0; i < N; ++i) mx += place.x[i], my += place.y[i];
    mx /= N, my /= N;
    T dot{}, turn{};
    for (int i = 0; i < N; ++i) {
      d[2 * i] = place.x[i] - mx, d[2 * i + 1] = place.y[i] - my;
      dot += gradient[2 * i] * d[2 * i] + gradient[2 * i + 1] * d[2 * i + 1];
      turn += gradient[2 * i] * d[2 * i + 1] - gradient[2 * i + 1] * d[2 * i];
    }
    const T r = root(dot * dot + turn * turn), one = T{} + 1.0;
    const auto spread = r > T{};  // false: all nodes coincide
    inverse = select(spread, 1.0 / r, T{});
    c = select(spread, dot * inverse, one), s = turn * inverse;
    for (int i = 0; i < N; ++i) {
      const T x = d[2 * i], y = d[2 * i + 1];
      d[2 * i] = c * x + s * y - shape[2 * i];
      d[2 * i + 1] = c * y - s * x - shape[2 * i + 1];
    }
  }

  /// Its rate, from the nodes' velocities [m/s].
  [[nodiscard]] TRILITH_INLINE std::array<T, 8> rate(const double* shape, const NodeColumns<N, T>& velocity) const {
    const double* const gradient = shape + 8;
    std::array<T, 8> v{};
    T spin{};  // of the axes [rad/s]
    for (int i = 0; i < N; ++i) {
      v[2 * i] = c * velocity.x[i] + s * velocity.y[i];
      v[2 * i + 1] = c * velocity.y[i] - s * velocity.x[i];
      spin += gradient[2 * i] * v[2 * i + 1] - gradient[2 * i + 1] * v[2 * i];
    }
    spin *= inverse;
    for (int i = 0; i < N; ++i) {
      v[2 * i] += spin * (shape[2 * i + 1] + d[2 * i + 1]);
      v[2 * i + 1] -= spin * (shape[2 * i] + d[2 * i]);
    }
    return v;
  }

  /// Nodal forces in world axes, conjugate to d through h.
  TRILITH_INLINE NodeColumns<N, T> forces(const double* shape, const std::array<T, 8>& h) const {
    const double* const gradient = shape + 8;
    T moment{};
    for (int i = 0; i < N; ++i)
      moment += (shape[2 * i] + d[2 * i]) * h[2 * i + 1] - (shape[2 * i + 1] + d[2 * i + 1]) * h[2 * i];
    const T couple = moment * inverse;
    NodeColumns<N, T> out;
    for (int i = 0; i < N; ++i) {
      const T x = h[2 * i] + couple * gradient[2 * i + 1], y = h[2 * i + 1] - couple * gradient[2 * i];
      out.x[i] = c * x - s * y;
      out.y[i] = s * x + c * y;
    }
    return out;
  }
};

/// k d for a symmetric matrix of eight rows, of which the first 2 N are used, stored by columns.
template <int N>
TRILITH_INLINE std::array<double, 8> multiply(const double* k, const std::array<double, 8>& d) {
  Lanes low{}, high{};
  for (int j = 0; j < 2 * N; ++j) {
    Lanes a, b;
    __builtin_memcpy(&a, k + 8 * j, sizeof a);
    __builtin_memcpy(&b, k + 8 * j + 4, sizeof b);
    low += a * d[j];
    high += b * d[j];
  }
  std::array<double, 8> out;
  __builtin_memcpy(out.data(), &low, sizeof low);
  __builtin_memcpy(out.data() + 4, &high, sizeof high);
  return out;
}
/// For four deformations.
template <int N>
TRILITH_INLINE std::array<Lanes, 8> multiply(const double* k, const std::array<Lanes, 8>& d) {
  std::array<Lanes, 8> out{};
  for (int j = 0; j < 2 * N; ++j)
    for (int i = 0; i < 2 * N; ++i) out[i] += k[8 * j + i] * d[j];
  return out;
}

}  // namespace trilith
