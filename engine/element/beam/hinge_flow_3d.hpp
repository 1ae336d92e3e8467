// Flow of one hinge in space: its capacity after a rotation by `length` along `way`, and the derivatives.
//
// Rotations and moments about y are scaled by sqrt(s) and 1/sqrt(s), so that hardening is isotropic and the reach is a
// length. The support function h of the surface has the power b = a/(a - 1), which is dual to a. Then:
//
//   p = from + length n,   most = D (X(p) + c sigma),   sigma = dh/dn,   h = [ (W_y |n_y|)^b + (W_z |n_z|)^b ]^(1/b).
//
// The point sigma of the surface does most work on a flow along n, so the flow is normal to the surface for any n.
#pragma once

#include <Eigen/Core>

#include "element/beam/hinge_law.hpp"

namespace trilith {

/// A hinge during one step.
struct SpaceHinge {
  const HingeLaw* law = nullptr;
  double scale = 1;                                ///< sqrt(s)
  Eigen::Vector2d from = Eigen::Vector2d::Zero();  ///< p before the step, scaled [rad]
  double reach = 0;                                ///< before the step [rad]
  double worn = 1;                                 ///< D due to energy [1]
  bool gone = false;

  [[nodiscard]] bool yields() const { return std::isfinite(law->sagging); }
  /// X before multiplication by D, scaled.
  [[nodiscard]] Eigen::Vector2d back(const Eigen::Vector2d& p) const;
  /// W of the sides to which `way` points.
  [[nodiscard]] Eigen::Vector2d width(const Eigen::Vector2d& way, double reach) const;
  /// D.
  [[nodiscard]] double kept(double reach) const;
};

/// Distance of `moment` from the centre of the surface, relative to it: at most 1 inside.
double gauge(const SpaceHinge& hinge, const Eigen::Vector2d& moment, double share);
/// Unit normal of the surface at `moment`: the direction of flow.
Eigen::Vector2d normal_at(const SpaceHinge& hinge, const Eigen::Vector2d& moment);

/// Columns of the derivatives: by `length`, and by an angle that rotates `way` to the left. A hinge without moment
/// rotates freely by `length` times `way`, whose two components are then the unknowns.
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
