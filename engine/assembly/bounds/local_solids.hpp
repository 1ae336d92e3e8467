// Springs of contacts and bearings on nodes in space, from which the stable step is bounded.
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

/// Stiffness and damping of one body over its mass and principal moments: sums over columns sqrt(k) b and sqrt(c) b.
struct LocalSolid {
  Matrix6 k = Matrix6::Zero(), c = Matrix6::Zero();

  void add(const Vector6& b, double stiffness, double beta) {
    const Matrix6 m = stiffness * b * b.transpose();
    k += m, c += beta * m;
  }
  /// Adds a purely rotational spring.
  void add_turn(const Vec3& b, double stiffness, double beta) {
    const Eigen::Matrix3d m = stiffness * b * b.transpose();
    k.bottomRightCorner<3, 3>() += m, c.bottomRightCorner<3, 3>() += beta * m;
  }
};

/// Scaled body: displacement of a point for a unit motion along each of the body's axes.
struct ScaledNode {
  Turn3 turn;
  double mass;   ///< square root of the mass
  Vec3 inertia;  ///< square roots of the principal moments

  /// Translation along e at `arm` from the node, both in world axes.
  [[nodiscard]] Vector6 along(const Vec3& e, const Vec3& arm) const {
    Vector6 b;
    b.head<3>() = turn.undo(e) / mass;
    b.tail<3>() = turn.undo(cross(arm, e)).cwiseQuotient(inertia);
    return b;
  }
  /// Rotation about e.
  [[nodiscard]] Vec3 about(const Vec3& e) const { return turn.undo(e).cwiseQuotient(inertia); }
};

inline ScaledNode scaled_node(const Model<3>& model, int node, const UnitQuaternion& rotation) {
  return {turn_of(rotation), std::sqrt(model.mass[node]), model.inertia[node].cwiseSqrt()};
}

/// Scaled meshed body, as if it were rigid. Any root of its inertia is valid, because eigenvalues do not depend on the
/// choice.
struct ScaledWhole {
  double mass;              ///< square root of the mass
  Eigen::Matrix3d unscale;  ///< inverse of L, for the inertia L L'
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

/// An area in contact, at `arm` from the node. If its normal is zero, it is equally stiff along every direction.
struct AreaSprings {
  Vec3 arm, normal;
  double area, radius;
  std::array<Vec3, 2> spread;
  ContactTangent law;
};

/// Springs on the nodes of a fit: row sums of the stiffness, scaled by the masses, for the largest of all directions. A
/// motion of the nodes moves the middle of the area by sum w_i u_i, and its second moments by the arms. A dyad of
/// weights v v' has the row sum |v_i| sum |v_j|, added for each node.
struct NodeRows {
  std::vector<double> k, c;  ///< [node] 1/s2, 1/s

  /// `weight`: [node of the fit] nodal force per unit force.
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

/// Nodal forces of a fit per unit force at a point [m], or per unit force along `arm` minus one at its foot.
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

/// Adds a contact area on a fit. It counts as stiff along every direction as along its stiffest one.
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

/// Upper bound of the largest eigenvalue of a positive semidefinite matrix: the fourth root of the norm of its fourth
/// power.
inline double largest_bound(const Matrix6& m) {
  const Matrix6 square = m * m, fourth = square * square;
  return std::sqrt(std::sqrt(fourth.norm()));
}

inline ContactTangent solid_tangent(const Model<3>& model, int law, double depth) {
  return with_kernel({model.laws[law], model.thickness, 0}, [&](const auto& kernel) { return kernel.tangent(depth); });
}

}  // namespace trilith
