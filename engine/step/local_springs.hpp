// Springs of contacts on one node or one body of the plane: what bounds of the longest stable step are made of.
#pragma once

#include <algorithm>
#include <cmath>

#include "step/contact_rows.hpp"
#include "world/model.hpp"

namespace trilith {

/// Symmetric 3 x 3 of one body about its node: (x, y, rotation).
struct Local {
  Eigen::Matrix3d k = Eigen::Matrix3d::Zero(), c = Eigen::Matrix3d::Zero();
};

/// A spring of stiffness k along unit direction e at `arm` from the node, spread over `length` along `spread`. Without
/// matrices in between: this is done four times for every contact.
inline void add_spring(Local& local, const Vec2& e, const Vec2& arm, double k, double beta, double length,
                       const Vec2& spread, double weight) {
  // K += k b b', b = (e, arm x e) as the spring is stretched by e . (u + theta x arm); springs spread over `length`
  // turn about their middle with k length^2 / 12 more.
  const double stiffness = weight * k, lever = cross(spread, e);
  const double b[3] = {e.x(), e.y(), cross(arm, e)};
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) {
      double m = stiffness * b[row] * b[column];
      // row = column = 2, the rotation.
      if (row + column == 4) m += stiffness * lever * lever * length * length / 12;
      local.k(row, column) += m;
      local.c(row, column) += beta * m;
    }
}

/// A spring along unit direction e that turns nothing: the same but for what is 0.
inline void add_spring(Local& local, const Vec2& e, double k, double beta, double weight) {
  const double stiffness = weight * k;
  for (int column = 0; column < 2; ++column)
    for (int row = 0; row < 2; ++row) {
      const double m = stiffness * e[row] * e[column];
      local.k(row, column) += m;
      local.c(row, column) += beta * m;
    }
}

/// Where a contact is and how stiff: `length` along left_of(normal), its middle at `at`.
struct ContactSprings {
  Vec2 at, normal;
  double length;
  ContactTangent law;
};

/// Of law `law` at an overlap of `depth` [m] or less.
inline ContactTangent spring_tangent(const Model<2>& model, int law, double depth) {
  return with_kernel(law_in_use(model, law), [&](const auto& kernel) { return kernel.tangent(depth); });
}

/// The largest eigenvalue of a symmetric matrix that has none below 0, from above: Newton's steps on its characteristic
/// polynomial from the largest row sum on, which is at least as much, never pass it but by rounding. A few are enough,
/// as what they leave is on the safe side.
inline double largest_eigenvalue(const Eigen::Matrix3d& m) {
  const auto minor = [&](int i, int j) { return m(i, i) * m(j, j) - m(i, j) * m(i, j); };
  const double sum = m.trace(), minors = minor(0, 1) + minor(1, 2) + minor(2, 0), product = m.determinant();
  double x = m.cwiseAbs().rowwise().sum().maxCoeff();
  for (int i = 0; i < 6; ++i) {
    const double height = ((x - sum) * x + minors) * x - product, slope = (3 * x - 2 * sum) * x + minors;
    if (!(height > 0 && slope > 0)) break;
    x -= height / slope;
  }
  return x;
}

/// ... of what is free, scaled by mass and inertia [1/s2], [1/s]. `is_free`: along x, along y, turning; what is held or
/// driven does not swing.
inline double rate_bound(const Eigen::Matrix3d& m, double mass, double inertia, const std::array<bool, 3>& is_free) {
  const std::array<double, 3> scale = {1 / std::sqrt(mass), 1 / std::sqrt(mass), 1 / std::sqrt(inertia)};
  Eigen::Matrix3d scaled = Eigen::Matrix3d::Zero();
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      if (is_free[r] && is_free[c]) scaled(r, c) = m(r, c) * scale[r] * scale[c];
  return largest_eigenvalue(scaled);
}

/// The larger of `known` and the rate bound of a node's own springs. Where their trace, which is no less than any
/// eigenvalue, is below what is known there is nothing to be found.
inline double larger_rate(const Model<2>& model, int node, const Eigen::Matrix3d& m, double known) {
  const double mass = model.mass[node], inertia = model.inertia[node];
  if ((m(0, 0) + m(1, 1)) / mass + (m(2, 2) > 0 ? m(2, 2) / inertia : 0) <= known) return known;
  const auto& s = model.support[node];
  return std::max(known,
                  rate_bound(m, mass, inertia, {s[0] == Support::free, s[1] == Support::free, s[2] == Support::free}));
}

}  // namespace trilith
