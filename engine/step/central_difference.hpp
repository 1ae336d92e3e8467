// Explicit central differences (leapfrog), the ledger's snapshot, and the rule of one step.
#pragma once

#include "step/step_times.hpp"
#include "world/model.hpp"
#include "world/state.hpp"
#include "world/work.hpp"

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

/// Takes one step from an instant that has been evaluated and committed.
template <int D>
void advance(const Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
             StepTimes* times = nullptr);

/// The ledger at the instant of the last evaluation (before `advance`): stored terms from the state, given-off terms
/// from the running sums. Kinetic energy is that of the leapfrog scheme, half of m v(-) v(+).
template <int D>
Energy energy_now(const Model<D>& model, const State<D>& state, const Work<D>& work, const StepOptions& options);

}  // namespace trilith
