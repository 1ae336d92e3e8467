// Co-rotating axes of points in space: for an element, or for a plane face.
//
// With the present points x_i and the gradients g_i of weights over their reference shape (sum of g_i = 0), F = sum x_i
// g_i' is a mean deformation gradient. The axes are rotated by R of its polar decomposition F = R U. Its rate gives W =
// R'F' = O U + U', where O is the skew matrix of the spin w in these axes. Then W - W' = O U + U O gives
//
//     (tr(U) 1 - U) w = sum of g_i x R'v_i        so that        w = t sum of g_i x R'v_i,   t = (tr(U) 1 - U)^-1.
//
// A couple m in these axes is conjugate to the forces f_i = R ((t m) x g_i) on the points, which have no resultant and
// the moment R m. For a plane face g_i have two components in its plane, U is two-dimensional, and the third column of
// R is the normal; all else is equal. The deformation of an element is d_i = R'(x_i - mean) - X_i, its rate R'(v_i -
// mean) - w x (X_i + d_i): free of any rigid motion (Felippa and Haugen, Comput. Methods Appl. Mech. Engng 194, 2005;
// in the plane element/corotation.hpp).
#pragma once

#include <Eigen/Dense>

#include <cmath>

#include "base/space.hpp"

namespace trilith {

/// R and t as above.
struct FittedTurn {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(), couple = Eigen::Matrix3d::Identity();
};

/// For a gradient with a determinant above 0. Newton's method X <- (X + X'^-1) / 2 (Higham 1986) converges
/// quadratically.
inline FittedTurn fitted_turn(const Eigen::Matrix3d& f) {
  Eigen::Matrix3d r = f;
  for (int round = 0; round < 30; ++round) {
    const Eigen::Matrix3d next = 0.5 * (r + r.inverse().transpose());
    const double change = (next - r).cwiseAbs().maxCoeff();
    r = next;
    if (!(change > 1e-15)) break;
  }
  Eigen::Matrix3d u = r.transpose() * f;
  u = (0.5 * (u + u.transpose())).eval();
  return {r, (u.trace() * Eigen::Matrix3d::Identity() - u).inverse()};
}

/// For a face: f has its two columns first. U = (C + root(det C) 1) / root(tr C + 2 root(det C)) with C = F'F.
inline FittedTurn fitted_face_turn(const Vec3& along, const Vec3& across) {
  Eigen::Matrix2d c;
  c << along.dot(along), along.dot(across), along.dot(across), across.dot(across);
  const double root = std::sqrt(c.determinant()), size = std::sqrt(c.trace() + 2 * root);
  const Eigen::Matrix2d u = (c + root * Eigen::Matrix2d::Identity()) / size, back = u.inverse();
  FittedTurn out;
  out.axes.col(0) = back(0, 0) * along + back(1, 0) * across;
  out.axes.col(1) = back(0, 1) * along + back(1, 1) * across;
  out.axes.col(2) = cross(along, across).normalized();
  out.couple.setZero();
  out.couple.topLeftCorner<2, 2>() = u / root;
  out.couple(2, 2) = 1 / u.trace();
  return out;
}

}  // namespace trilith
