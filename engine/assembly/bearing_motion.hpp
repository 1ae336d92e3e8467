// How the second point of a bearing moves against the first, in the bearing's axes.
#pragma once

#include <array>
#include <vector>

#include "base/rotation_3d.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

template <int D>
struct BearingMotion {
  decltype(turn_of(Rotation<D>{})) axes;                      ///< of the bearing, as they go with body a
  std::array<double, Space<D>::dofs> displacement{}, rate{};  ///< see Directions [m] or [rad], and per s
  Vec<D> point = Vec<D>::Zero();                              ///< of b, in the world [m]

  /// Displacement as laws and limits count it: less that at which the bearing took over, where it counts from there.
  [[nodiscard]] std::array<double, Space<D>::dofs> counted(const BearingMemory<D>& memory) const;

  [[nodiscard]] Vec<D> translation() const;
  /// What forces and couples by direction, which resist displacement, are on body b, in the axes of the world. The
  /// opposite acts on a, through the same point.
  [[nodiscard]] Vec<D> force(const std::array<double, Space<D>::dofs>& resisting) const;
  [[nodiscard]] Moment<D> moment(const std::array<double, Space<D>::dofs>& resisting) const;
};

/// Of bearing `i`. Between ends tied to one node each, whole turns count; else turns stay below half a circle.
BearingMotion<2> bearing_motion(const Model<2>& model, const State<2>& state, std::size_t i);
BearingMotion<3> bearing_motion(const Model<3>& model, const State<3>& state, std::size_t i);

/// Mean rates over the step of length `dt` behind, by direction: those of now, but where an implicit scheme took it.
std::array<double, 3> mean_rates(const Model<2>& model, const State<2>& state, const Bearing<2>& b,
                                 const BearingMotion<2>& now, double dt);
std::array<double, 6> mean_rates(const Model<3>& model, const State<3>& state, const Bearing<3>& b,
                                 const BearingMotion<3>& now, double dt);

/// Adds the force [N] and moment [N m] of a bearing on body b to the nodes of its ends, and the opposite to a's. Both
/// bodies are pushed along one line, through b's point, so that no couple is made between them.
void push_ends(const Model<2>& model, const State<2>& state, const Bearing<2>& bearing, const Vec2& force,
               double moment, std::vector<Vec2>& node_force, std::vector<double>& node_moment);

/// The same in space, of ends tied to one carrier each (model/contact/contact_frame.hpp).
void push_ends(const Model<3>& model, const State<3>& state, const Bearing<3>& bearing, const Vec3& force,
               const Vec3& moment, std::vector<Vec3>& node_force, std::vector<Vec3>& node_moment);

/// A point tied to one carrier in space (model/contact/contact_frame.hpp), where it stands [m].
inline Vec3 point_of(const Model<3>& model, const State<3>& state, const Attachment<3>& attachment) {
  const int n = attachment.node[0];
  if (n >= 0) return state.position[n] + turn_of(state.rotation[n]).apply(attachment.arm[0]);
  const BodyMotion at = motion_of(model, state, n);
  return at.place + turn_of(at.rotation).apply(attachment.arm[0]);
}

}  // namespace trilith
