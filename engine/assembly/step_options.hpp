// Options of one explicit time step.
#pragma once

namespace trilith {

/// Damping that helps a structure to rest under its weight and belongs to no dynamics: a force against each node's
/// velocity, `share` of its unbalanced force (Cundall 1987, "Distinct element models of rock and soil structure";
/// here along the velocity vector, so that it does not depend on the axes).
struct RestDamping {
  double share = 0;  ///< 0 to below 1
};

struct StepOptions {
  double dt = 0;  ///< length of this step [s]
  RestDamping rest;
};

}  // namespace trilith
