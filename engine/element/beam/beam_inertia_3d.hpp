// Consistent mass of a straight beam in space: element/beam/beam_inertia.hpp with two transverse directions.
//
//   T = mu L / 12 (2 f_0^2 + 2 f_0 f_1 + 2 f_1^2) + A' (m x 1) A / 2,     A = (a_0, b_0, a_1, b_1)
//   f_i = v_i . e,   a_i = v_i - f_i e,   b_i = w_i x e.
//
// Here v_i and w_i are velocities and spins of its ends, e is the direction of the chord, and m is the 4 x 4 matrix of
// a transverse cubic. The form is vectorial: it depends on no section axes. At a pinned end b follows as in the plane.
// The rotary inertia of the sections, a share of (thickness / L)^2, stays lumped at the nodes.
//
// Inertia forces follow from Lagrange's equations: d/dt dT/dv - dT/dx, and d/dt dT/dw - w x dT/dw for rotations,
// because spins are not rates of coordinates (Boltzmann and Hamel; J. G. Papastavridis, "Analytical Mechanics", 2002,
// ch. 3).
#pragma once

#include <Eigen/Core>

#include <array>

#include "base/space.hpp"

namespace trilith {

using BeamMatrix3 = Eigen::Matrix<double, 12, 12>;
using BeamVector3 = Eigen::Matrix<double, 12, 1>;

/// Inertia of a beam in space with consistent mass.
struct BeamInertia3 {
  double mass = 0;                                   ///< [kg]; each node has half of it in lumped form
  Eigen::Matrix4d across = Eigen::Matrix4d::Zero();  ///< m, [kg], [kg m] and [kg m2]
};

/// `mass` [kg] and `length` [m] above 0.
BeamInertia3 beam_inertia_in_space(double mass, double length, const std::array<bool, 2>& pinned);

/// Motion of the ends in world axes: velocity and spin of end 0, then of end 1, or their rates.
struct BeamMotion3 {
  Vec3 along;        ///< unit vector of the chord
  double length;     ///< of the chord [m]
  BeamVector3 rate;  ///< velocities and spins
  BeamVector3 rise;  ///< their rates
};

/// The mass matrix for a chord along `along`.
BeamMatrix3 mass_in_space(const BeamInertia3& inertia, const Vec3& along);

/// Inertia forces [N] and moments [N m] of this motion of the ends.
BeamVector3 inertia_forces(const BeamInertia3& inertia, const BeamMotion3& motion);

}  // namespace trilith
