// Where a body is and how it moves as a whole, whatever its kind; and points tied to bodies.
#pragma once

#include "world/model.hpp"
#include "world/state.hpp"

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
double body_mass(const Model<2>& model, int body);
double body_inertia(const Model<2>& model, int body);

/// The body that a node belongs to.
int body_of_node(const Model<2>& model, int node);
/// Where a skin point stands at the start [m].
Vec2 skin_start(const Model<2>& model, int skin);

/// A point tied to a body: in the axes of the node of a rigid body, `place` [m]; in an element of a deformable one, its
/// natural coordinates there. So it moves with the nodes by the shape functions, and turns with the element's axes.
struct Anchor {
  int body = -1, element = -1;
  Vec2 place = Vec2::Zero();
};

inline Anchor anchor_a(const Bearing<2>& b) {
  return {b.body_a, b.element_a, b.point_a};
}
inline Anchor anchor_b(const Bearing<2>& b) {
  return {b.body_b, b.element_b, b.point_b};
}

/// Ties the point that is at `at` [m] at the start. On a deformable body: in the element it lies in, or whose edge is
/// nearest; throws InputError where it is farther from the body than a hundredth of its size.
Anchor tie_point(const Model<2>& model, int body, const Vec2& at, const std::string& owner);

Pose anchor_pose(const Model<2>& model, const State<2>& state, const Anchor& anchor);

/// Adds a force [N] at the anchor and a moment [N m] to the nodes: the transpose of anchor_pose.
void add_at_anchor(const Model<2>& model, const State<2>& state, const Anchor& anchor, const Vec2& force, double moment,
                   std::vector<Vec2>& node_force, std::vector<double>& node_moment);

}  // namespace trilith
