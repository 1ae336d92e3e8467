// Position and motion of a body as a whole, whatever its kind; and points attached to bodies.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Position, rotation and motion of a body or of one of its points.
struct Pose {
  Vec2 place = Vec2::Zero();     ///< [m]
  double rotation = 0;           ///< from the start [rad]
  Vec2 velocity = Vec2::Zero();  ///< [m/s]
  double spin = 0;               ///< [rad/s]
};

/// For a rigid body: its node. For a deformable one: its centre of mass, and the mass-weighted least-squares rotation
/// of all its nodes, between -pi and pi.
Pose body_pose(const Model<2>& model, const State<2>& state, int body);
/// At the start.
Vec2 body_start(const Model<2>& model, int body);
/// Mass [kg], and moment of inertia at the start about the centre of mass [kg m2].
template <int D>
double body_mass(const Model<D>& model, int body);
double body_inertia(const Model<2>& model, int body);

/// Position, rotation and motion of a body in space. For a rigid one: its node. For a frame: its centre of mass with
/// its velocity, and rotation and spin of its first joint. For elements: the centre of mass, and the mass-weighted
/// least-squares rotation of all nodes.
struct Pose3 {
  Vec3 place = Vec3::Zero(), moved = Vec3::Zero();  ///< now, and displacement from the start [m]
  UnitQuaternion turned;                            ///< rotation from the start
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();
};
Pose3 body_pose(const Model<3>& model, const State<3>& state, int body);

/// The node of a body nearest to a position at the start [m].
int nearest_node(const Model<3>& model, int body, const Vec3& at);
/// The contact frame (model/contact/contact_frame.hpp) of a body's point at `at` [m] at the start: the nearest node, or
/// for a body of elements the nearest face of its skin.
int contact_frame_near(const Model<3>& model, int body, const Vec3& at);
/// The point attached to this frame.
Attachment<3> tie_point(const Model<3>& model, int body, const Vec3& at);

/// The body of a node.
template <int D>
int body_of_node(const Model<D>& model, int node);

/// Attaches the body's point at `at` [m] at the start. On a deformable body: to the element that contains it, or with
/// the nearest edge; throws InputError where it is farther from the body than a hundredth of its size.
Attachment<2> tie_point(const Model<2>& model, int body, const Vec2& at, const std::string& owner);

/// Position, rotation and motion of an attached point.
Pose pose_at(const Model<2>& model, const State<2>& state, const Attachment<2>& attachment);
/// The pose at the beginning of the last implicit step. Velocities are undefined.
Pose pose_before(const Model<2>& model, const State<2>& state, const Attachment<2>& attachment);

/// Adds a force [N] at the point and a moment [N m] to the nodes: the transpose of pose_at.
void apply_force(const Model<2>& model, const State<2>& state, const Attachment<2>& attachment, const Vec2& force,
                 double moment, std::vector<Vec2>& node_force, std::vector<double>& node_moment);

}  // namespace trilith
