// Solids in space as their joints need them.
#pragma once

#include "contact/joint_plan.hpp"
#include "world/model.hpp"
#include "world/state.hpp"

namespace trilith {

/// Pose and motion of the body that a piece belongs to.
inline BodyMotion body_motion(const Model<3>& model, const State<3>& state, int piece) {
  const int n = model.bodies[model.piece_body[piece]].first_node;
  return {state.position[n], state.rotation[n], state.velocity[n], state.spin[n]};
}

}  // namespace trilith
