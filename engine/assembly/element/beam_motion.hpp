// A beam of a frame in the position that its nodes determine.
#pragma once

#include "element/beam/beam_element.hpp"
#include "element/beam/beam_element_3d.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// The flexible end of a beam, which moves rigidly with its node; `arm` from the node [m]. Most beams have no arms.
inline BeamEnd end_of(const State<2>& state, const Beam& beam, std::size_t side, Vec2& arm) {
  const int n = beam.node[side];
  arm = beam.arm[side];
  if (arm.x() == 0 && arm.y() == 0) return {state.position[n], state.rotation[n], state.velocity[n], state.spin[n]};
  arm = Turn(state.rotation[n]).apply(arm);
  return {state.position[n] + arm, state.rotation[n], state.velocity[n] + cross(state.spin[n], arm), state.spin[n]};
}

/// The beam in its present position.
inline BeamNow now_of(const State<2>& state, const Beam& beam) {
  Vec2 arm;
  return {end_of(state, beam, 0, arm), end_of(state, beam, 1, arm), beam.length, beam.angle};
}

/// True if an end of a beam in space has an offset from its node.
inline bool has_arm(const Beam3& beam, std::size_t side) {
  return beam.arm[side] != Vec3(0, 0, 0);
}
/// Present offset of that end from its node [m].
inline Vec3 arm_of(const State<3>& state, const Beam3& beam, std::size_t side) {
  if (!has_arm(beam, side)) return Vec3::Zero();
  return turn_of(state.rotation[static_cast<std::size_t>(beam.node[side])]).apply(beam.arm[side]);
}

/// The end of a beam in space, for a node with this position and motion.
inline BeamEnd3 carried_end(const Beam3& beam, std::size_t side, const Vec3& place, const UnitQuaternion& rotation,
                            const Vec3& velocity, const Vec3& spin) {
  BeamEnd3 end{place, turn_of(rotation * beam.axes[side]), velocity, spin};
  if (!has_arm(beam, side)) return end;
  const Vec3 arm = turn_of(rotation).apply(beam.arm[side]);
  end.place += arm, end.velocity += cross(spin, arm);
  return end;
}

/// An end of a beam in space in its present position.
inline BeamEnd3 end_of(const State<3>& state, const Beam3& beam, std::size_t side) {
  const auto n = static_cast<std::size_t>(beam.node[side]);
  return carried_end(beam, side, state.position[n], state.rotation[n], state.velocity[n], state.spin[n]);
}
inline BeamNow3 now_of(const State<3>& state, const Beam3& beam) {
  return {end_of(state, beam, 0), end_of(state, beam, 1), beam.length};
}

/// Forces of a beam in space on its nodes, from the `action` on its ends; arms add moments.
inline BeamAction3 on_nodes(const State<3>& state, const Beam3& beam, BeamAction3 action) {
  if (has_arm(beam, 0)) action.moment[0] += cross(arm_of(state, beam, 0), action.force);
  if (has_arm(beam, 1)) action.moment[1] -= cross(arm_of(state, beam, 1), action.force);
  return action;
}

}  // namespace trilith
