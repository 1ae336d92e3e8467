// Solids in space as their joints need them.
#pragma once

#include "contact/joint_plan.hpp"
#include "world/model.hpp"
#include "world/state.hpp"

namespace trilith {

/// Pose and motion of the node that a piece goes with; of a piece that deforms, of its face `face`.
inline BodyMotion body_motion(const Model<3>& model, const State<3>& state, int piece, int face) {
  return motion_of(model, state, model.carrier_of(piece, face));
}

}  // namespace trilith
