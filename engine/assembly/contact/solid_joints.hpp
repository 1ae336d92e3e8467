// Motion of pieces in space as input of their joints.
#pragma once

#include "contact/joint/joint_plan.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Pose and motion of the node of a piece; for a deformable piece, of its face `face`.
inline BodyMotion body_motion(const Model<3>& model, const State<3>& state, int piece, int face) {
  return motion_of(model, state, model.carrier_of(piece, face));
}

/// Motion of a contact frame (model/contact/contact_frame.hpp) during the last step of an implicit scheme; nullptr
/// after an explicit step.
inline const StepBehind* step_behind(const Work<3>& work, int contact_frame) {
  const std::vector<StepBehind>& behind = work.solids.behind;
  if (behind.empty()) return nullptr;
  const std::size_t nodes = behind.size() - work.solids.fitted.size();
  return &behind[contact_frame >= 0 ? static_cast<std::size_t>(contact_frame)
                                    : nodes + static_cast<std::size_t>(-1 - contact_frame)];
}

/// As above from the kinematics of `work`, with the last step.
inline BodyMotion body_motion(const Model<3>& model, const State<3>& state, const Work<3>& work, int piece, int face) {
  BodyMotion motion = body_motion(model, state, piece, face);
  motion.behind = step_behind(work, model.carrier_of(piece, face));
  return motion;
}

}  // namespace trilith
