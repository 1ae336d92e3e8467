// Springs of contacts on one node or one body in the plane, from which the stable step is bounded.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "assembly/contact/contact_rows.hpp"
#include "base/simd/lanes.hpp"
#include "model/model.hpp"

namespace trilith {

/// Symmetric 3 x 3 matrices of one body about its node: (x, y, rotation).
struct Local {
  Eigen::Matrix3d k = Eigen::Matrix3d::Zero(), c = Eigen::Matrix3d::Zero();
};

/// Adds a spring of stiffness k along unit direction e at `arm` from the node, distributed over `length` along
/// `spread`. Written without temporary matrices, because it runs four times for every contact.
inline void add_spring(Local& local, const Vec2& e, const Vec2& arm, double k, double beta, double length,
                       const Vec2& spread, double weight) {
  // K += k b b', b = (e, arm x e), because the elongation of the spring is e . (u + theta x arm). Distributed springs
  // rotate about their middle with k length^2 / 12 in addition.
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

/// Adds a spring along unit direction e without rotation: the same sums without the zero terms.
inline void add_spring(Local& local, const Vec2& e, double k, double beta, double weight) {
  const double stiffness = weight * k;
  for (int column = 0; column < 2; ++column)
    for (int row = 0; row < 2; ++row) {
      const double m = stiffness * e[row] * e[column];
      local.k(row, column) += m;
      local.c(row, column) += beta * m;
    }
}

/// Position and stiffness of a contact: `length` along left_of(normal), with its middle at `at`.
struct ContactSprings {
  Vec2 at, normal;
  double length;
  ContactTangent law;
};

/// Largest tangent of law `law` at an overlap of at most `depth` [m].
inline ContactTangent spring_tangent(const Model<2>& model, int law, double depth) {
  return with_kernel(law_in_use(model, law), [&](const auto& kernel) { return kernel.tangent(depth); });
}

/// Characteristic polynomial x^3 - sum x^2 + minors x - product of a symmetric matrix, and the bound of its largest
/// root at which Newton's steps begin.
struct CharacteristicCubic {
  double sum, minors, product, from;
  explicit CharacteristicCubic(const Eigen::Matrix3d& m)
      : sum(m.trace()), product(m.determinant()), from(m.cwiseAbs().rowwise().sum().maxCoeff()) {
    const auto minor = [&](int i, int j) { return m(i, i) * m(j, j) - m(i, j) * m(i, j); };
    minors = minor(0, 1) + minor(1, 2) + minor(2, 0);
  }
};

/// Upper bounds of the largest eigenvalues of two symmetric positive semidefinite matrices. Newton's steps on their
/// characteristic polynomials start at the largest row sum, which is an upper bound, and stay above the root except for
/// rounding. A few steps are sufficient, because the remaining error is on the safe side. Two matrices are processed
/// together, because each step depends on the one before.
inline std::array<double, 2> largest_eigenvalues(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  const CharacteristicCubic of_a(a), of_b(b);
  const LanePair sum{of_a.sum, of_b.sum}, minors{of_a.minors, of_b.minors}, product{of_a.product, of_b.product};
  LanePair x{of_a.from, of_b.from};
  for (int i = 0; i < 6; ++i) {
    const LanePair height = ((x - sum) * x + minors) * x - product, slope = (3 * x - 2 * sum) * x + minors;
    const auto goes = (height > LanePair{}) & (slope > LanePair{});
    if ((goes[0] | goes[1]) == 0) break;
    x = goes ? x - height / slope : x;
  }
  return {x[0], x[1]};
}

/// Rate bound of stiffness and damping `of` on the free directions, scaled by mass and inertia. `is_free`: along x,
/// along y, rotation; fixed and driven directions do not vibrate.
inline RateBound rate_bound(const Local& of, double mass, double inertia, const std::array<bool, 3>& is_free) {
  const std::array<double, 3> scale = {1 / std::sqrt(mass), 1 / std::sqrt(mass), 1 / std::sqrt(inertia)};
  Eigen::Matrix3d k = Eigen::Matrix3d::Zero(), c = Eigen::Matrix3d::Zero();
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      if (is_free[row] && is_free[column]) {
        k(row, column) = of.k(row, column) * scale[row] * scale[column];
        c(row, column) = of.c(row, column) * scale[row] * scale[column];
      }
  const auto [stiffness, damping] = largest_eigenvalues(k, c);
  return {stiffness, damping};
}

/// The larger of `known` and the rate bounds of a node's own springs. If the traces, which bound all eigenvalues, are
/// below the known bounds, no eigenvalue is computed.
inline RateBound larger_rates(const Model<2>& model, int node, const Local& of, const RateBound& known) {
  const double mass = model.mass[node], inertia = model.inertia[node];
  const auto trace = [&](const Eigen::Matrix3d& m) {
    return (m(0, 0) + m(1, 1)) / mass + (m(2, 2) > 0 ? m(2, 2) / inertia : 0);
  };
  const bool stiffer = trace(of.k) > known.stiffness, damped = trace(of.c) > known.damping;
  if (!stiffer && !damped) return known;
  const auto& s = model.support[node];
  const RateBound own =
      rate_bound(of, mass, inertia, {s[0] == Support::free, s[1] == Support::free, s[2] == Support::free});
  return {stiffer ? std::max(known.stiffness, own.stiffness) : known.stiffness,
          damped ? std::max(known.damping, own.damping) : known.damping};
}

}  // namespace trilith
