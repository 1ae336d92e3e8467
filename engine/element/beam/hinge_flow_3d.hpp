// How one hinge in space flows: what it carries as it turns by `length` along `way`, and how that answers.
//
// Rotations and moments about y are scaled by sqrt(s) and 1/sqrt(s), so that hardening is alike about both axes and the
// reach is a length. Then, with h the support function of the surface, whose power b = a/(a - 1) is dual to a,
//
//   p = from + length n,   most = D (X(p) + c sigma),   sigma = dh/dn,   h = [ (W_y |n_y|)^b + (W_z |n_z|)^b ]^(1/b)
//
// sigma is the point of the surface that does most work on a flow along n: so the flow is normal to it whatever n.
#pragma once

#include <Eigen/Core>

#include "element/beam/hinge_law.hpp"

namespace trilith {

/// A hinge during one step.
struct SpaceHinge {
  const HingeLaw* law = nullptr;
  double scale = 1;                                ///< sqrt(s)
  Eigen::Vector2d from = Eigen::Vector2d::Zero();  ///< p before, scaled [rad]
  double reach = 0;                                ///< before [rad]
  double worn = 1;                                 ///< D by energy [1]
  bool gone = false;

  [[nodiscard]] bool yields() const { return std::isfinite(law->sagging); }
  /// X before D, scaled.
  [[nodiscard]] Eigen::Vector2d back(const Eigen::Vector2d& p) const;
  /// W of the sides that `way` points to.
  [[nodiscard]] Eigen::Vector2d width(const Eigen::Vector2d& way, double reach) const;
  /// D.
  [[nodiscard]] double kept(double reach) const;
};

/// How far `moment` is out on the surface: at most 1 within it.
double gauge(const SpaceHinge& hinge, const Eigen::Vector2d& moment, double share);
/// The way it would flow at `moment`: the normal of the surface, unit.
Eigen::Vector2d normal_at(const SpaceHinge& hinge, const Eigen::Vector2d& moment);

/// Columns of the derivatives: by `length`, and by an angle that turns `way` to the left. A hinge that is gone turns
/// freely by `length` times `way`, whose two numbers are the unknowns then.
struct SpaceFlow {
  Eigen::Vector2d way = Eigen::Vector2d::UnitY();
  double length = 0;                                  ///< [rad]
  Eigen::Vector2d p, most = Eigen::Vector2d::Zero();  ///< scaled [rad], [N m]
  Eigen::Vector2d outward = Eigen::Vector2d::Zero();  ///< D sigma: d most / dc
  double work = 0;                                    ///< D h length: the flow along N over -dc/dN [N m]
  Eigen::Matrix2d p_by = Eigen::Matrix2d::Identity(), most_by = Eigen::Matrix2d::Zero();
  Eigen::RowVector2d work_by = Eigen::RowVector2d::Zero();
};
SpaceFlow flow_along(const SpaceHinge& hinge, const Eigen::Vector2d& way, double length, double share);

}  // namespace trilith
