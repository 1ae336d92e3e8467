// Estimate of a contact between two pieces that touch or may soon touch: gap, closing speed and contact stiffness.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Estimate along the direction that separates two convex pieces best.
struct ApproachEstimate {
  double gap = 0;        ///< negative if the pieces overlap [m]
  double speed = 0;      ///< closing speed of the nearest parts at touch, or now if they touch; negative while they
                         ///< open [m/s]
  double touches = 0;    ///< time until the pieces touch, with the present accelerations [s]
  double stiffness = 0;  ///< contact stiffness over the expected shared area, or larger [N/m]
  double mass = 0;       ///< m_a m_b / (m_a + m_b); the mass of a body that does not move is infinite [kg]
  bool apart = false;    ///< the pieces do not touch during the step; the other values are then bounds, or not set
};

/// Estimate for the pieces p and q within `dt` [s]. Their bodies must have a contact law, and update_kinematics must
/// have run. The result depends on State alone.
ApproachEstimate approach_estimate(const Model<2>& model, const State<2>& state, const Work<2>& work, int p, int q,
                                   double dt);
ApproachEstimate approach_estimate(const Model<3>& model, const State<3>& state, const Work<3>& work, int p, int q,
                                   double dt);

}  // namespace trilith
