// How a node turns within an implicit step (assembly/alpha_scheme.hpp).
//
// In the plane a rotation is a third displacement. In space, with R the rotation, w the spin and L = R J R' w the
// angular momentum in the axes of the world, t the rotation vector of the step, also there, and A the rate of w,
//
//   R' = exp(t) R
//   t / dt = (1 - b/g) exp(t) w + (b/g) w' + dt (1/2 - b/g) exp(t) A        w carried along with the body
//   L' = L + dt ((1 - g) l + g l'),   l = R J R' A + w x L                  ' at the end of the step
//   (1 - alpha_m) l' + alpha_m l = (1 - alpha_f) M' + alpha_f M
//
// so that what the scheme does to velocities it does to the momentum, and what it does to displacements to the turn in
// the axes of the body. At b = 1/4, g = 1/2 the turn is that of the mean spin of both ends in the axes of the body and
// the momentum goes by the mean moment: the algorithm ALGO-C1 of J. C. Simo and K. K. Wong ("Unconditionally stable
// algorithms for rigid body dynamics that exactly preserve energy and momentum", Int. J. Numer. Meth. Engng 31, 1991)
// but for the moment, which is theirs at the middle of the step. With no moment L is kept, and as t, being the axis, is
// the same before and after the turn, t . J (w' - w) in the body's axes is 0: so is the energy, at any length of step.
// About a fixed axis all of it is the scheme of one rotation.
//
// A body that is held about some axis of the world has no momentum of its own to keep there: its spin is taken in the
// axes of the world, and the equation is that of its free axes.
#pragma once

#include <array>

#include "assembly/alpha_scheme.hpp"
#include "assembly/node_forces.hpp"
#include "assembly/tangent/dof_graph.hpp"
#include "base/rotation_3d.hpp"

namespace trilith {

/// A rotation, and how it changes.
template <int D>
struct TurnMotion {
  Rotation<D> rotation;  ///< [rad] in the plane
  Spin<D> spin;          ///< [rad/s]
  Spin<D> rate;          ///< of the spin [rad/s2]
};

/// What a node turns by [rad]; in space about the axes of the world, after what it has turned.
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
/// Two turns, one after the other, as one; the first is `from`. In space each less than half a circle.
inline double turned_on(double by, double from) {
  return from + by;
}
inline Vec3 turned_on(const Vec3& by, const Vec3& from) {
  return angle_of(rotation_by(by) * rotation_by(from));
}
/// Turns about one axis.
inline void turn_about(int /*axis*/, double by, double& rotation) {
  rotation += by;
}
inline void turn_about(int axis, double by, UnitQuaternion& rotation) {
  Vec3 angle = Vec3::Zero();
  angle[axis] = by;
  rotation = rotation_by(angle) * rotation;
}
/// One number of a turn, a spin or a moment.
inline double& number_at(int /*axis*/, double& of) {
  return of;
}
inline double& number_at(int axis, Vec3& of) {
  return of[axis];
}

/// Where the turn `path` of a step of length `dt` leads a node that began it as `from`, on the axes that are `free`; on
/// the others spin and rate are those of `to`, which hold the motion of the support.
TurnMotion<2> turned(const Model<2>& model, int node, const AlphaScheme& scheme, double dt, const TurnMotion<2>& from,
                     double path, const TurnMotion<2>& to);
TurnMotion<3> turned(const Model<3>& model, int node, const AlphaScheme& scheme, double dt, const TurnMotion<3>& from,
                     const Vec3& path, const TurnMotion<3>& to);

/// The path after a further turn of a node, as Newton's method corrects it.
double corrected_turn(const Model<2>& model, int node, double path, double by);
Vec3 corrected_turn(const Model<3>& model, int node, const Vec3& path, const Vec3& by);

/// Rate of the angular momentum in the axes of the world [N m]. In the plane spin times inertia.
inline double moment_taken(double inertia, const TurnMotion<2>& motion) {
  return inertia * motion.rate;
}
Vec3 moment_taken(const Vec3& inertia, const TurnMotion<3>& motion);

/// The rate of the spin of a node under a moment, and in space of what turns with it; 0 where it is held.
double spin_rate_under(const Model<2>& model, const State<2>& state, int node, double moment);
Vec3 spin_rate_under(const Model<3>& model, const State<3>& state, int node, const Vec3& moment);

/// What damping by mass takes of the momentum and the angular momentum of a node [N], [N m].
Dofs<2> damping_by_mass(const Model<2>& model, const State<2>& state, int node);
Dofs<3> damping_by_mass(const Model<3>& model, const State<3>& state, int node);

/// How the inertia of a node answers to its unknown f, by the node's own directions: `inertia` [1/s2] times its mass;
/// of a turn in space, with the unknown as in Tangent and c = `rate` the change of spin by it [1/s],
///
///   inertia (I + (I [w]x - [L]x) / c)
Dofs<2> inertia_column(const Model<2>& model, const State<2>& state, const Freedom& f, double inertia, double rate);
Dofs<3> inertia_column(const Model<3>& model, const State<3>& state, const Freedom& f, double inertia, double rate);

}  // namespace trilith
