// Rotation of a node within an implicit step (assembly/alpha_scheme.hpp).
//
// In the plane a rotation is a third displacement. In space R is the rotation, w the spin, A its rate, and L = R J R' w
// the angular momentum in world axes. The rotation vector t of the step is in world axes too.
//
//     R' = exp(t) R
//     t / dt = (1 - b/g) exp(t) w + (b/g) w' + dt (1/2 - b/g) exp(t) A        w rotated with the body
//     L' = L + dt ((1 - g) l + g l'),   l = R J R' A + w x L                  ' at the end of the step
//     (1 - alpha_m) l' + alpha_m l = (1 - alpha_f) M' + alpha_f M
//
// So the scheme treats the momentum like velocities, and the rotation in body axes like displacements. At b = 1/4, g =
// 1/2 the rotation is the mean spin of both ends in body axes, and the momentum follows the mean moment. This is the
// algorithm ALGO-C1 of J. C. Simo and K. K. Wong ("Unconditionally stable algorithms for rigid body dynamics that
// exactly preserve energy and momentum", Int. J. Numer. Meth. Engng 31, 1991), except that they take the moment at the
// middle of the step. Without a moment L is conserved. The axis t is the same before and after the rotation, so t . J
// (w' - w) in body axes is 0 and the energy is conserved, at any step length. About a fixed axis this is the scheme of
// one rotation.
//
// A body that is fixed about some axis of the world does not conserve its momentum there. Its spin is taken in world
// axes, and the equation is that for its free axes.
#pragma once

#include <array>

#include "assembly/alpha_scheme.hpp"
#include "assembly/node_forces.hpp"
#include "assembly/tangent/dof_graph.hpp"
#include "base/rotation_3d.hpp"

namespace trilith {

/// A rotation and its rates.
template <int D>
struct TurnMotion {
  Rotation<D> rotation;  ///< [rad] in the plane
  Spin<D> spin;          ///< [rad/s]
  Spin<D> rate;          ///< rate of the spin [rad/s2]
};

/// Rotation between two orientations [rad]; in space a vector in world axes, applied after `from`.
inline double turn_between(double from, double to) {
  return to - from;
}
inline Vec3 turn_between(const UnitQuaternion& from, const UnitQuaternion& to) {
  return angle_of(to * inverse(from));
}
inline double turned_by(double angle, double from) {
  return from + angle;
}
inline UnitQuaternion turned_by(const Vec3& angle, const UnitQuaternion& from) {
  return renormalised(rotation_by(angle) * from);
}
/// Composition of two rotations, `from` first. In space each is below pi.
inline double turned_on(double by, double from) {
  return from + by;
}
inline Vec3 turned_on(const Vec3& by, const Vec3& from) {
  return angle_of(rotation_by(by) * rotation_by(from));
}
/// Rotates about one axis.
inline void turn_about(int /*axis*/, double by, double& rotation) {
  rotation += by;
}
inline void turn_about(int axis, double by, UnitQuaternion& rotation) {
  Vec3 angle = Vec3::Zero();
  angle[axis] = by;
  rotation = rotation_by(angle) * rotation;
}
/// One component of a rotation, a spin or a moment.
inline double& number_at(int /*axis*/, double& of) {
  return of;
}
inline double& number_at(int axis, Vec3& of) {
  return of[axis];
}

/// Motion at the end of a step of length `dt` of a node that began it as `from`, after the rotation `path`, on the
/// `free` axes. On the others spin and rate are taken from `to`, which contains the motion of the support.
TurnMotion<2> turned(const Model<2>& model, int node, const AlphaScheme& scheme, double dt, const TurnMotion<2>& from,
                     double path, const TurnMotion<2>& to);
TurnMotion<3> turned(const Model<3>& model, int node, const AlphaScheme& scheme, double dt, const TurnMotion<3>& from,
                     const Vec3& path, const TurnMotion<3>& to);

/// The path after a further rotation of a node, as in the correction of Newton's method.
double corrected_turn(const Model<2>& model, int node, double path, double by);
Vec3 corrected_turn(const Model<3>& model, int node, const Vec3& path, const Vec3& by);

/// Rate of the angular momentum in world axes [N m]; in the plane inertia times the rate of spin.
inline double moment_taken(double inertia, const TurnMotion<2>& motion) {
  return inertia * motion.rate;
}
Vec3 moment_taken(const Vec3& inertia, const TurnMotion<3>& motion);

/// Rate of spin of a node under a moment, in space with the gyroscopic term; 0 for fixed axes.
double spin_rate_under(const Model<2>& model, const State<2>& state, int node, double moment);
Vec3 spin_rate_under(const Model<3>& model, const State<3>& state, int node, const Vec3& moment);

/// Damping by mass of the momentum and the angular momentum of a node [N], [N m].
Dofs<2> damping_by_mass(const Model<2>& model, const State<2>& state, int node);
Dofs<3> damping_by_mass(const Model<3>& model, const State<3>& state, int node);

/// Derivative of the inertia force of a node with respect to its unknown f, by the node's directions: `inertia` [1/s2]
/// times its mass. For a rotation in space, with the unknown as in Tangent and c = `rate` its change of spin [1/s], it
/// is
///
///   inertia (I + (I [w]x - [L]x) / c).
Dofs<2> inertia_column(const Model<2>& model, const State<2>& state, const Freedom& f, double inertia, double rate);
Dofs<3> inertia_column(const Model<3>& model, const State<3>& state, const Freedom& f, double inertia, double rate);

}  // namespace trilith
