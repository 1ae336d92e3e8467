// Solids in space as their joints need them.
#pragma once

#include "contact/joint_plan.hpp"
#include "world/model.hpp"
#include "world/state.hpp"

namespace trilith {

/// Pose and motion of the node that a piece goes with.
inline BodyMotion body_motion(const Model<3>& model, const State<3>& state, int piece) {
  const int n = model.node_of_piece(piece);
  return {state.position[n], state.rotation[n], state.velocity[n], state.spin[n]};
}

}  // namespace trilith
