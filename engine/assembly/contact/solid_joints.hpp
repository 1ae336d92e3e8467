// Solids in space as their joints need them.
#pragma once

#include "contact/joint/joint_plan.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Pose and motion of the node that a piece goes with; of a piece that deforms, of its face `face`.
inline BodyMotion body_motion(const Model<3>& model, const State<3>& state, int piece, int face) {
  return motion_of(model, state, model.carrier_of(piece, face));
}

/// How a carrier (model/contact/contact_frame.hpp) went along the step behind, where an implicit scheme took it; else
/// nullptr.
inline const StepBehind* step_behind(const Work<3>& work, int contact_frame) {
  const std::vector<StepBehind>& behind = work.solids.behind;
  if (behind.empty()) return nullptr;
  const std::size_t nodes = behind.size() - work.solids.fitted.size();
  return &behind[contact_frame >= 0 ? static_cast<std::size_t>(contact_frame)
                                    : nodes + static_cast<std::size_t>(-1 - contact_frame)];
}

/// The same as placed in `work`, with the step behind.
inline BodyMotion body_motion(const Model<3>& model, const State<3>& state, const Work<3>& work, int piece, int face) {
  BodyMotion motion = body_motion(model, state, piece, face);
  motion.behind = step_behind(work, model.carrier_of(piece, face));
  return motion;
}

}  // namespace trilith
