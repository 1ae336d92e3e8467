// Two pieces that may be about to touch, or do: how far apart, how fast, and how stiff the contact between them is.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Along the direction that parts two convex pieces best.
struct ApproachEstimate {
  double gap = 0;        ///< below 0 where they overlap [m]
  double speed = 0;      ///< at which their nearest parts close as they touch, or now; below 0 where they open [m/s]
  double touches = 0;    ///< time until they touch, with what forces and motions add to the speed on the way [s]
  double stiffness = 0;  ///< of the contact over the area that they would share, at least what it will be [N/m]
  double mass = 0;       ///< m_a m_b / (m_a + m_b), of what does not move without end [kg]
  bool apart = false;    ///< they stay apart all along the step; the others are then bounds, or not found
};

/// Of pieces p and q within `dt` [s], between whose bodies a contact law holds. Work must be placed. From State alone.
ApproachEstimate approach_estimate(const Model<2>& model, const State<2>& state, const Work<2>& work, int p, int q,
                                   double dt);
ApproachEstimate approach_estimate(const Model<3>& model, const State<3>& state, const Work<3>& work, int p, int q,
                                   double dt);

}  // namespace trilith
