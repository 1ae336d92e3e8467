// Where a body is and how it moves as a whole, whatever its kind; and points tied to bodies.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Place, turn and motion of a body or of a point of it.
struct Pose {
  Vec2 place = Vec2::Zero();     ///< [m]
  double rotation = 0;           ///< since the start [rad]
  Vec2 velocity = Vec2::Zero();  ///< [m/s]
  double spin = 0;               ///< [rad/s]
};

/// Of a rigid body: its node. Of a deformable one: its centre of mass, and the turn that fits all its nodes best by
/// least squares weighed with their masses, between -pi and pi.
Pose body_pose(const Model<2>& model, const State<2>& state, int body);
/// At the start.
Vec2 body_start(const Model<2>& model, int body);
/// Mass [kg], and moment of inertia at the start about the centre of mass [kg m2].
template <int D>
double body_mass(const Model<D>& model, int body);
double body_inertia(const Model<2>& model, int body);

/// Place, turn and motion of a body in space: of a rigid one its node; of a frame its centre of mass and that one's
/// velocity, with the turn and spin of its first joint; of elements the same with the turn that fits all their nodes
/// best, weighed with their masses.
struct Pose3 {
  Vec3 place = Vec3::Zero(), moved = Vec3::Zero();  ///< now and since the start [m]
  UnitQuaternion turned;                            ///< since the start
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();
};
Pose3 body_pose(const Model<3>& model, const State<3>& state, int body);

/// The node of a body that a place at the start [m] is nearest to.
int nearest_node(const Model<3>& model, int body, const Vec3& at);
/// What carries a point of a body that is at `at` [m] at the start (model/contact/contact_frame.hpp): the nearest node,
/// or of a body of elements the nearest face of its skin.
int contact_frame_near(const Model<3>& model, int body, const Vec3& at);
/// The point tied to it.
Attachment<3> tie_point(const Model<3>& model, int body, const Vec3& at);

/// The body that a node belongs to.
template <int D>
int body_of_node(const Model<D>& model, int node);

/// Ties the point of a body that is at `at` [m] at the start. On a body that deforms: in the element it lies in, or
/// whose edge is nearest; throws InputError where it is farther from the body than a hundredth of its size.
Attachment<2> tie_point(const Model<2>& model, int body, const Vec2& at, const std::string& owner);

/// Where a tied point is and how it moves, and how what is tied there turns.
Pose pose_at(const Model<2>& model, const State<2>& state, const Attachment<2>& attachment);
/// Where it was as the step behind began, which an implicit scheme took. Velocities are of no meaning.
Pose pose_before(const Model<2>& model, const State<2>& state, const Attachment<2>& attachment);

/// Adds a force [N] at the point and a moment [N m] to the nodes: the transpose of pose_at.
void apply_force(const Model<2>& model, const State<2>& state, const Attachment<2>& attachment, const Vec2& force,
                 double moment, std::vector<Vec2>& node_force, std::vector<double>& node_moment);

}  // namespace trilith
