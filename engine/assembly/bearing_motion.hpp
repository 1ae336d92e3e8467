// Relative motion of the second point of a bearing against the first, in the axes of the bearing.
#pragma once

#include <array>
#include <vector>

#include "base/rotation_3d.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

template <int D>
struct BearingMotion {
  decltype(turn_of(Rotation<D>{})) axes;                      ///< axes of the bearing, which move with body a
  std::array<double, Space<D>::dofs> displacement{}, rate{};  ///< see Directions [m] or [rad], and per s
  Vec<D> point = Vec<D>::Zero();                              ///< point of b, in the world [m]

  /// Displacement that laws and limits use: minus the displacement at which the bearing took over, in directions that
  /// count from there.
  [[nodiscard]] std::array<double, Space<D>::dofs> counted(const BearingMemory<D>& memory) const;

  [[nodiscard]] Vec<D> translation() const;
  /// Force and moment on body b in world axes, from forces and couples by direction that resist displacement. The
  /// opposite acts on a, through the same point.
  [[nodiscard]] Vec<D> force(const std::array<double, Space<D>::dofs>& resisting) const;
  [[nodiscard]] Moment<D> moment(const std::array<double, Space<D>::dofs>& resisting) const;
};

/// Motion of bearing `i`. If each end is attached to one node, whole turns count; otherwise the rotation must be below
/// pi.
BearingMotion<2> bearing_motion(const Model<2>& model, const State<2>& state, std::size_t i);
BearingMotion<3> bearing_motion(const Model<3>& model, const State<3>& state, std::size_t i);

/// Mean rates by direction over the last step, of length `dt`: the present rates after an explicit step, the true means
/// after an implicit one.
std::array<double, 3> mean_rates(const Model<2>& model, const State<2>& state, const Bearing<2>& b,
                                 const BearingMotion<2>& now, double dt);
std::array<double, 6> mean_rates(const Model<3>& model, const State<3>& state, const Bearing<3>& b,
                                 const BearingMotion<3>& now, double dt);

/// Adds the force [N] and moment [N m] of a bearing on body b to the nodes of its ends, and the opposite to a's. Both
/// act along one line through b's point, so that they form no couple.
void push_ends(const Model<2>& model, const State<2>& state, const Bearing<2>& bearing, const Vec2& force,
               double moment, std::vector<Vec2>& node_force, std::vector<double>& node_moment);

/// The version for space, with ends attached to one contact frame each (model/contact/contact_frame.hpp).
void push_ends(const Model<3>& model, const State<3>& state, const Bearing<3>& bearing, const Vec3& force,
               const Vec3& moment, std::vector<Vec3>& node_force, std::vector<Vec3>& node_moment);

/// Present position of a point attached to one contact frame in space (model/contact/contact_frame.hpp) [m].
inline Vec3 point_of(const Model<3>& model, const State<3>& state, const Attachment<3>& attachment) {
  const int n = attachment.node[0];
  if (n >= 0) return state.position[n] + turn_of(state.rotation[n]).apply(attachment.arm[0]);
  const BodyMotion at = motion_of(model, state, n);
  return at.place + turn_of(at.rotation).apply(attachment.arm[0]);
}

}  // namespace trilith
