// How a rigid body turns in space.
//
// What lasts is its angular momentum L, in the axes of the world; its spin is w = R J^-1 R^T L with the principal
// moments J in its own axes, to which the rotation R leads. Between blows of moments a body turns freely: L stays, and
// its own axes see l = R^T L go round. The energy is a sum of one term for each axis, E = sum of l_k^2 / (2 J_k), and
// the motion of each term alone is a turn about that axis by dt l_k / J_k, which is exact. In the order
//
//   x by dt/2, y by dt/2, z by dt, y by dt/2, x by dt/2
//
// they make one step of second order, the same forwards and backwards in time: L is kept but for rounding, and the
// energy stays near its own for ever (A. Dullweber, B. Leimkuhler and R. McLachlan 1997, "Symplectic splitting methods
// for rigid body molecular dynamics").
#pragma once

#include <array>

#include "base/space.hpp"

namespace trilith {

/// Angular momentum [kg m2/s] of a spin [rad/s], and the spin of it.
Vec3 momentum_of(const Vec3& inertia, const UnitQuaternion& rotation, const Vec3& spin);
Vec3 spin_of(const Vec3& inertia, const UnitQuaternion& rotation, const Vec3& momentum);

/// The spin [rad/s] a moment [N m] leads to from `spin` in a time `span` [s], the body being turned as now. `free`:
/// about which axes of the world it may turn; about the others its spin becomes that of `held`. The angular momentum of
/// a free body grows by moment times time; a held body is subject to Euler's equation along its free axes.
Vec3 spin_ahead(const Vec3& inertia, const UnitQuaternion& rotation, const Vec3& spin, const Vec3& moment, double span,
                const std::array<bool, 3>& free, const Vec3& held);

/// Rate of the spin [rad/s2] on the free axes that a moment adds, the other axes keeping theirs.
Vec3 spin_rate_by(const Vec3& inertia, const UnitQuaternion& rotation, const Vec3& moment,
                  const std::array<bool, 3>& free);

/// Where a free body of that angular momentum is turned to after `dt` [s].
UnitQuaternion turned_freely(const Vec3& inertia, const UnitQuaternion& rotation, const Vec3& momentum, double dt);

}  // namespace trilith
