// Options of one explicit time step.
#pragma once

namespace trilith {

/// Damping for consolidation under weight, without physical meaning in dynamics. It is a force against each node's
/// velocity, `share` of its unbalanced force (Cundall 1987, "Distinct element models of rock and soil structure"). Here
/// it acts along the velocity vector, so that it does not depend on the axes.
struct RestDamping {
  double share = 0;  ///< from 0 to below 1
};

struct StepOptions {
  double dt = 0;  ///< length of this step [s]
  RestDamping rest;
};

}  // namespace trilith
