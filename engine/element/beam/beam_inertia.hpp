// Consistent mass of a straight beam: the kinetic energy of a cubic between its ends, co-rotational with its chord.
//
//     T = y' m y / 2,   y = (along_0, across_0, spin_0, along_1, across_1, spin_1): velocities of its ends in its axes
//
//     along:   mu L / 6 [2, 1; 1, 2]
//     across:  mu L / 420 [156, 22 L, 54, -13 L; . , 4 L^2, 13 L, -3 L^2; ., ., 156, -22 L; ., ., ., 4 L^2]
//              + mu (I/A) / (30 L) [36, 3 L, -36, 3 L; ., 4 L^2, -3 L, -L^2; ., ., 36, -3 L; ., ., ., 4 L^2]
//
// The second term across is the rotary inertia of the sections. At a pinned end the beam rotates by 3/2 of its chord's
// rotation minus half of the other end's, like a cubic without moment there. Archer, "Consistent mass matrix for
// distributed mass systems", J. Struct. Div. ASCE 89, 1963; Przemieniecki, "Theory of matrix structural analysis",
// 1968, ch. 11.
//
// The chord rotates with the ends, so inertia forces follow from Lagrange's equations with m rotated by the chord's
// angle beta: d/dt (T' m T y) - dT/dx. Momentum and energy are conserved for any size of motion.
#pragma once

#include <Eigen/Core>

#include <array>

#include "base/space.hpp"
#include "element/section/section.hpp"

namespace trilith {

using BeamMatrix = Eigen::Matrix<double, 6, 6>;
using BeamVector = Eigen::Matrix<double, 6, 1>;

/// Inertia of a beam with consistent mass.
struct BeamInertia {
  BeamMatrix consistent = BeamMatrix::Zero();  ///< m, [kg], [kg m] and [kg m2]
  double lumped = 0;                           ///< mass at each node in lumped form [kg]
  std::array<double, 2> turning{};             ///< rotational inertia at each node in lumped form [kg m2]
};

/// `mass` [kg] and `length` [m] above 0; the lumped values stay 0.
BeamInertia beam_inertia(double mass, double length, const Section& section, const std::array<bool, 2>& pinned);

/// Motion of the ends in world axes: velocities or accelerations along x and y, and about the plane's normal.
struct BeamMotion {
  Vec2 along;       ///< unit vector of the chord
  double length;    ///< of the chord [m]
  BeamVector rate;  ///< velocities of the ends
  BeamVector rise;  ///< accelerations of the ends
};

/// m in world axes.
BeamMatrix turned(const BeamMatrix& m, const Vec2& along);

/// Inertia forces [N] and moments [N m] of this motion of the ends.
BeamVector inertia_forces(const BeamMatrix& m, const BeamMotion& motion);

}  // namespace trilith
