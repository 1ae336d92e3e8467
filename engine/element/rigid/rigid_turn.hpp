// Rotation of a rigid body in space.
//
// The state variable is the angular momentum L in world axes. The spin is w = R J^-1 R^T L with the principal moments J
// in body axes and the rotation R from body to world axes. Between moments a body rotates freely: L is constant, and in
// body axes l = R^T L rotates. The energy is a sum over the axes, E = sum of l_k^2 / (2 J_k). The motion of each term
// alone is a rotation about its axis by dt l_k / J_k, which is exact. In the order
//
//   x by dt/2, y by dt/2, z by dt, y by dt/2, x by dt/2
//
// these make one second-order step that is symmetric in time. L is conserved to rounding, and the energy error stays
// bounded (A. Dullweber, B. Leimkuhler and R. McLachlan 1997, "Symplectic splitting methods for rigid body molecular
// dynamics").
#pragma once

#include <array>

#include "base/space.hpp"

namespace trilith {

/// Angular momentum [kg m2/s] of a spin [rad/s], and the inverse.
Vec3 momentum_of(const Vec3& inertia, const UnitQuaternion& rotation, const Vec3& spin);
Vec3 spin_of(const Vec3& inertia, const UnitQuaternion& rotation, const Vec3& momentum);

/// The spin [rad/s] after a moment [N m] has acted on `spin` for `span` [s] at the present orientation. `free`: world
/// axes about which it may rotate; the spin about the others becomes that in `held`. For a free body the angular
/// momentum changes by moment times time; a partly held body follows Euler's equation along its free axes.
Vec3 spin_ahead(const Vec3& inertia, const UnitQuaternion& rotation, const Vec3& spin, const Vec3& moment, double span,
                const std::array<bool, 3>& free, const Vec3& held);

/// Spin rate [rad/s2] on the free axes due to a moment; the other axes keep theirs.
Vec3 spin_rate_by(const Vec3& inertia, const UnitQuaternion& rotation, const Vec3& moment,
                  const std::array<bool, 3>& free);

/// Orientation of a free body with this angular momentum after `dt` [s].
UnitQuaternion turned_freely(const Vec3& inertia, const UnitQuaternion& rotation, const Vec3& momentum, double dt);

}  // namespace trilith
