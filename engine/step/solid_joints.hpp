// Solids in space as their joints need them.
#pragma once

#include "contact/joint_plan.hpp"
#include "world/model.hpp"
#include "world/state.hpp"
#include "world/work.hpp"

namespace trilith {

/// Pose and motion of the node that a piece goes with.
inline BodyMotion body_motion(const Model<3>& model, const State<3>& state, int piece) {
  const int n = model.node_of_piece(piece);
  return {state.position[n], state.rotation[n], state.velocity[n], state.spin[n]};
}

/// How a node went along the step behind, where an implicit scheme took it; else nullptr.
inline const StepBehind* step_behind(const Work<3>& work, int node) {
  return work.solids.behind.empty() ? nullptr : &work.solids.behind[static_cast<std::size_t>(node)];
}

/// The same as placed in `work`, with the step behind.
inline BodyMotion body_motion(const Model<3>& model, const State<3>& state, const Work<3>& work, int piece) {
  BodyMotion motion = body_motion(model, state, piece);
  motion.behind = step_behind(work, model.node_of_piece(piece));
  return motion;
}

}  // namespace trilith
