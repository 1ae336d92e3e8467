// Springs of contacts and bearings on nodes of solids in space: what bounds of the longest stable step are made of.
#pragma once

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

#include "assembly/bearing_motion.hpp"
#include "assembly/whole_body.hpp"
#include "contact/space/solid_pressure.hpp"

namespace trilith {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Stiffness and damping of one body over its mass and principal moments: columns of sqrt(k) b and sqrt(c) b.
struct LocalSolid {
  Matrix6 k = Matrix6::Zero(), c = Matrix6::Zero();

  void add(const Vector6& b, double stiffness, double beta) {
    const Matrix6 m = stiffness * b * b.transpose();
    k += m, c += beta * m;
  }
  /// The same of a turn alone.
  void add_turn(const Vec3& b, double stiffness, double beta) {
    const Eigen::Matrix3d m = stiffness * b * b.transpose();
    k.bottomRightCorner<3, 3>() += m, c.bottomRightCorner<3, 3>() += beta * m;
  }
};

/// A body as springs see it: how a motion of 1 along each of its own axes moves what hangs on it.
struct ScaledNode {
  Turn3 turn;
  double mass;   ///< root of it
  Vec3 inertia;  ///< roots of the principal moments

  /// A translation e at `arm` from the node, both in the axes of the world.
  [[nodiscard]] Vector6 along(const Vec3& e, const Vec3& arm) const {
    Vector6 b;
    b.head<3>() = turn.undo(e) / mass;
    b.tail<3>() = turn.undo(cross(arm, e)).cwiseQuotient(inertia);
    return b;
  }
  /// A turn about e.
  [[nodiscard]] Vec3 about(const Vec3& e) const { return turn.undo(e).cwiseQuotient(inertia); }
};

inline ScaledNode scaled_node(const Model<3>& model, int node, const UnitQuaternion& rotation) {
  return {turn_of(rotation), std::sqrt(model.mass[node]), model.inertia[node].cwiseSqrt()};
}

/// A body of elements likewise, as if it were rigid: any root of its inertia will do, as no eigenvalue depends on it.
struct ScaledWhole {
  double mass;              ///< root of it
  Eigen::Matrix3d unscale;  ///< of the inertia L L', the inverse of L
  Vec3 centre;

  explicit ScaledWhole(const WholeBody<3>& whole) : mass(std::sqrt(whole.mass)), centre(whole.centre) {
    unscale = whole.inertia.llt().matrixL().solve(Eigen::Matrix3d::Identity());
  }
  [[nodiscard]] Vector6 along(const Vec3& e, const Vec3& arm) const {
    Vector6 b;
    b.head<3>() = e / mass;
    b.tail<3>() = unscale * cross(arm, e);
    return b;
  }
  [[nodiscard]] Vec3 about(const Vec3& e) const { return unscale * e; }
};

/// An area under pressure, at `arm` from the node; where its force points nowhere, as stiff along every line.
struct AreaSprings {
  Vec3 arm, normal;
  double area, radius;
  std::array<Vec3, 2> spread;
  ContactTangent law;
};

/// Springs on the nodes of a fit: sums of rows of the stiffness, scaled by the masses, of the largest of all
/// directions. A motion of the nodes moves the middle of the area by sum w_i u_i, and its second moments by the arms; a
/// dyad of weights v v' has the row |v_i| sum |v_j|, and is added for each.
struct NodeRows {
  std::vector<double> k, c;  ///< [node] 1/s2, 1/s

  /// `weight`: [node of the fit] what a unit force gives each.
  void add(const Model<3>& model, const Fit& fit, const std::array<double, most_fit_nodes>& weight, double stiffness,
           double dashpot) {
    double sum = 0;
    for (int i = 0; i < fit.nodes; ++i)
      sum +=
          std::abs(weight[static_cast<std::size_t>(i)]) / std::sqrt(model.mass[fit.node[static_cast<std::size_t>(i)]]);
    for (int i = 0; i < fit.nodes; ++i) {
      const auto n = static_cast<std::size_t>(fit.node[static_cast<std::size_t>(i)]);
      const double row = std::abs(weight[static_cast<std::size_t>(i)]) * sum / std::sqrt(model.mass[n]);
      k[n] += stiffness * row, c[n] += dashpot * row;
    }
  }
};

inline NodeRows rows_of(const Model<3>& model) {
  const std::size_t nodes = model.fits.empty() ? 0 : model.mass.size();
  return {std::vector<double>(nodes), std::vector<double>(nodes)};
}

/// What a unit force at a point [m] gives each node of a fit, and a unit force along `arm` less one at its foot.
inline std::array<double, most_fit_nodes> weights_at(const Model<3>& model, const Fit& fit, const Fitted& now,
                                                     const Vec3& at, bool is_arm) {
  const Vec3 s = now.axes.transpose() * (is_arm ? at : Vec3(at - now.place));
  std::array<double, most_fit_nodes> out{};
  for (int i = 0; i < fit.nodes; ++i) {
    const double* const w = &model.fit_number[static_cast<std::size_t>(fit.first_number + 4 * i)];
    out[static_cast<std::size_t>(i)] = (is_arm ? 0 : w[0]) + w[1] * s.x() + w[2] * s.y() + w[3] * s.z();
  }
  return out;
}

/// An area under pressure on a fit: it stands as stiff along every line as along its stiffest.
inline void add_area_to_fit(const Model<3>& model, const Fit& fit, const Fitted& now, const AreaSprings& s,
                            double weight, NodeRows& rows) {
  const double stiffness = weight * s.area * std::max(s.law.normal, s.law.shear), dashpot = s.law.beta * stiffness;
  rows.add(model, fit, weights_at(model, fit, now, s.arm, false), stiffness, dashpot);
  for (const Vec3& a : s.spread) rows.add(model, fit, weights_at(model, fit, now, a, true), stiffness, dashpot);
}

/// `node`: a ScaledNode or a ScaledWhole.
template <class Scaled>
void add_area(const AreaSprings& s, const Scaled& node, double weight, LocalSolid& local) {
  const bool known = s.normal.squaredNorm() > 0;
  const Vec3 n = known ? s.normal : Vec3(Vec3::UnitZ()), across = line_across(n), other = cross(n, across);
  const double normal = weight * s.area * (known ? s.law.normal : std::max(s.law.normal, s.law.shear)),
               shear = weight * s.area * (known ? s.law.shear : std::max(s.law.normal, s.law.shear));
  local.add(node.along(n, s.arm), normal, s.law.beta);
  for (const Vec3& e : {across, other}) local.add(node.along(e, s.arm), shear, s.law.beta);
  for (const Vec3& a : s.spread) local.add_turn(node.about(cross(a, n)), normal, s.law.beta);
  local.add_turn(node.about(n), shear * s.radius * s.radius, s.law.beta);
}

/// At least the largest eigenvalue of a matrix that has none below 0: the fourth root of the norm of its fourth power.
inline double largest_bound(const Matrix6& m) {
  const Matrix6 square = m * m, fourth = square * square;
  return std::sqrt(std::sqrt(fourth.norm()));
}

inline ContactTangent solid_tangent(const Model<3>& model, int law, double depth) {
  return with_kernel({model.laws[law], model.thickness, 0}, [&](const auto& kernel) { return kernel.tangent(depth); });
}

}  // namespace trilith
