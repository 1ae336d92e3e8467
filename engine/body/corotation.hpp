// An element in axes that turn with it.
//
// With X the nodes of the reference shape and x those of now, both from their mean, and g the mean gradients of the
// shape functions, F = sum x (x) g is the mean deformation gradient. The axes are turned by R of its polar
// decomposition F = R U, tan = (sum g cross x) / (sum g . x). In these axes the deformation d = R'x - X is free of
// rigid motion, however large, so that a rigid turn makes no strain, and a homogeneous stretch makes U - 1 (Belytschko
// and Hsieh, "Non-linear transient finite element analysis with convected co-ordinates", Int. J. Numer. Meth. Engng 7,
// 1973; Felippa and Haugen, Comput. Methods Appl. Mech. Engng 194, 2005). Forces h that do the work h . rate of d are f
// = R (h - m/r left(g)), with m = sum (X + d) cross h and r = sum (R g) . x: the couple that the turning of the axes
// takes. f has no resultant and no moment about where the nodes are, and where h is the gradient of an energy, so is f.
#pragma once

#include <array>
#include <cmath>

#include "base/lanes.hpp"
#include "base/space.hpp"

namespace trilith {

/// Deformation of an element of N nodes and its rate, in turning axes.
template <int N>
struct Deformation {
  double c = 1, s = 0;        ///< of the angle of the axes
  double inverse = 0;         ///< 1 / r [1]
  double spin = 0;            ///< of the axes [rad/s]
  std::array<double, 8> d{};  ///< x0, y0, x1, ... [m]; rows beyond 2 N are 0
  std::array<double, 8> v{};  ///< its rate [m/s]

  /// `shape`: X and g, eight numbers each. `position`, `velocity`: by node.
  TRILITH_INLINE Deformation(const double* shape, const Vec2* const* position, const Vec2* const* velocity) {
    const double* const gradient = shape + 8;
    double mx = 0, my = 0;
    for (int i = 0; i < N; ++i) mx += position[i]->x(), my += position[i]->y();
    mx /= N, my /= N;
    double dot = 0, turn = 0;
    for (int i = 0; i < N; ++i) {
      d[2 * i] = position[i]->x() - mx, d[2 * i + 1] = position[i]->y() - my;
      dot += gradient[2 * i] * d[2 * i] + gradient[2 * i + 1] * d[2 * i + 1];
      turn += gradient[2 * i] * d[2 * i + 1] - gradient[2 * i + 1] * d[2 * i];
    }
    const double r = std::sqrt(dot * dot + turn * turn);
    if (r > 0) {  // else all nodes stand in one place
      inverse = 1 / r;
      c = dot * inverse, s = turn * inverse;
    }
    for (int i = 0; i < N; ++i) {
      const double x = d[2 * i], y = d[2 * i + 1], u = velocity[i]->x(), w = velocity[i]->y();
      d[2 * i] = c * x + s * y - shape[2 * i];
      d[2 * i + 1] = c * y - s * x - shape[2 * i + 1];
      v[2 * i] = c * u + s * w;
      v[2 * i + 1] = c * w - s * u;
      spin += gradient[2 * i] * v[2 * i + 1] - gradient[2 * i + 1] * v[2 * i];
    }
    spin *= inverse;
    for (int i = 0; i < N; ++i) {
      v[2 * i] += spin * (shape[2 * i + 1] + d[2 * i + 1]);
      v[2 * i + 1] -= spin * (shape[2 * i] + d[2 * i]);
    }
  }

  /// Forces on the nodes, in world axes, that do the work of h in the rate of d. Their sign: taken from `out`.
  TRILITH_INLINE void subtract(const double* shape, const double* h, Vec2* const* out) const {
    const double* const gradient = shape + 8;
    double moment = 0;
    for (int i = 0; i < N; ++i)
      moment += (shape[2 * i] + d[2 * i]) * h[2 * i + 1] - (shape[2 * i + 1] + d[2 * i + 1]) * h[2 * i];
    const double couple = moment * inverse;
    for (int i = 0; i < N; ++i) {
      const double x = h[2 * i] + couple * gradient[2 * i + 1], y = h[2 * i + 1] - couple * gradient[2 * i];
      out[i]->x() -= c * x - s * y;
      out[i]->y() -= s * x + c * y;
    }
  }
};

/// k d of a symmetric matrix of eight rows, of which `columns` count.
TRILITH_INLINE void multiply(const double* k, const std::array<double, 8>& d, int columns, double* out) {
  Lanes low{}, high{};
  for (int j = 0; j < columns; ++j) {
    Lanes a, b;
    __builtin_memcpy(&a, k + 8 * j, sizeof a);
    __builtin_memcpy(&b, k + 8 * j + 4, sizeof b);
    low += a * d[j];
    high += b * d[j];
  }
  __builtin_memcpy(out, &low, sizeof low);
  __builtin_memcpy(out + 4, &high, sizeof high);
}

}  // namespace trilith
