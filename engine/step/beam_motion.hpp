// A beam of a frame where its nodes put it.
#pragma once

#include "body/beam_element.hpp"
#include "body/beam_element_3d.hpp"
#include "world/model.hpp"
#include "world/state.hpp"

namespace trilith {

/// The flexible end of a beam, carried rigidly by its node; `arm` from there [m]. Most have none.
inline BeamEnd end_of(const State<2>& state, const Beam& beam, std::size_t side, Vec2& arm) {
  const int n = beam.node[side];
  arm = beam.arm[side];
  if (arm.x() == 0 && arm.y() == 0) return {state.position[n], state.rotation[n], state.velocity[n], state.spin[n]};
  arm = Turn(state.rotation[n]).apply(arm);
  return {state.position[n] + arm, state.rotation[n], state.velocity[n] + cross(state.spin[n], arm), state.spin[n]};
}

/// The beam itself.
inline BeamNow now_of(const State<2>& state, const Beam& beam) {
  Vec2 arm;
  return {end_of(state, beam, 0, arm), end_of(state, beam, 1, arm), beam.length, beam.angle};
}

/// An end of a beam in space, and the beam itself.
inline BeamEnd3 end_of(const State<3>& state, const Beam3& beam, std::size_t side) {
  const auto n = static_cast<std::size_t>(beam.node[side]);
  return {state.position[n], turn_of(state.rotation[n] * beam.axes[side]), state.velocity[n], state.spin[n]};
}
inline BeamNow3 now_of(const State<3>& state, const Beam3& beam) {
  return {end_of(state, beam, 0), end_of(state, beam, 1), beam.length};
}

}  // namespace trilith
