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

/// Largest row sum of what is free, scaled by mass and inertia: at least the largest eigenvalue [1/s2], [1/s].
/// `is_free`: along x, along y, turning.
inline double row_bound(const Eigen::Matrix3d& m, double mass, double inertia, const std::array<bool, 3>& is_free) {
  const std::array<double, 3> scale = {1 / std::sqrt(mass), 1 / std::sqrt(mass), 1 / std::sqrt(inertia)};
  double most = 0;
  for (int r = 0; r < 3; ++r) {
    double row = 0;
    for (int c = 0; c < 3; ++c)
      // What is held or driven does not swing.
      if (is_free[r] && is_free[c]) row += std::abs(m(r, c)) * scale[r] * scale[c];
    most = std::max(most, row);
  }
  return most;
}

}  // namespace trilith
