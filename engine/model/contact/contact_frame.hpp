// The contact frame of a piece of a body in space, or of one of its faces. It is a node with rotation, or several nodes
// without, to which position and rotation are fitted.
//
// A frame has one index: from 0 on a node of a rigid body or a frame structure; negative values -1 - k are the fit k of
// Model::fits. A piece of a body whose nodes have no rotation is a convex solid between the planes of one element's
// faces. Each of these planes is fitted to the nodes of its face (see FaceFit), so a face stays plane and tilts as the
// element bends; the corners are intersections of three planes. For contact such a face is a rigid plate that moves
// with its fit:
//
//     position = sum of a_i x_i,   velocity = sum of a_i v_i,   rotation and spin: element/corotation_3d.hpp.
//
// A force and a moment about that position are distributed to the nodes by the transpose, f_i = a_i f + R ((t R'm) x
// g_i). A pressure along the normal does the same work on the plate as on the nodes, whatever its distribution.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/rotation_3d.hpp"
#include "contact/joint/joint_plan.hpp"
#include "geometry/space/convex_solid.hpp"

namespace trilith {

template <int D>
struct Model;
template <int D>
struct State;

inline constexpr int most_fit_nodes = 10;

/// A fit to some nodes.
struct Fit {
  int nodes = 0;
  bool is_face = false;  ///< its gradients lie in the plane of the face, and its third axis is the normal
  std::array<int, most_fit_nodes> node{};
  int first_number = 0;  ///< index in Model::fit_number: a_i [1] and the three components of g_i [1/m] of each node
};

/// Present position and motion of a fit.
struct Fitted {
  Vec3 place = Vec3::Zero(), velocity = Vec3::Zero(), spin = Vec3::Zero();  ///< [m], [m/s], [rad/s]
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(), couple = Eigen::Matrix3d::Identity();

  [[nodiscard]] BodyMotion motion() const { return {place, rotation_of(axes), velocity, spin}; }
  [[nodiscard]] Vec3 velocity_at(const Vec3& x) const { return velocity + cross(spin, Vec3(x - place)); }
};

/// For nodes with these positions and velocities.
Fitted fitted(const Model<3>& model, const Fit& fit, std::span<const Vec3> position, std::span<const Vec3> velocity);

/// Adds a force [N] and a moment about the position of the fit [N m] to the nodes.
void spread_fitted(const Model<3>& model, const Fit& fit, const Fitted& now, const Vec3& force, const Vec3& moment,
                   std::vector<Vec3>& node_force);

/// Pose and motion of a contact frame.
BodyMotion motion_of(const Model<3>& model, const State<3>& state, int contact_frame);
/// The pose at the beginning of the last implicit step. Velocities are undefined.
BodyMotion motion_before(const Model<3>& model, const State<3>& state, int contact_frame);
/// The pose at the start.
BodyMotion start_of(const Model<3>& model, int contact_frame);

/// Adds a force [N] at a point [m] and a moment [N m] on a contact frame to the nodes.
void push_contact_frame(const Model<3>& model, const State<3>& state, int contact_frame, const Vec3& point,
                        const Vec3& force, const Vec3& moment, std::vector<Vec3>& node_force,
                        std::vector<Vec3>& node_moment);

/// Corners and normals of a piece between the planes of its faces; `now` has their fits.
void place_between(const ConvexSolid& solid, std::span<const Fitted> now, std::vector<Vec3>& corners,
                   std::vector<Vec3>& normals);

}  // namespace trilith
