// Explicit central differences (leapfrog), the ledger's snapshot, and the rule of one step.
#pragma once

#include "assembly/step_options.hpp"
#include "assembly/step_times.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Takes one step from an instant that has been evaluated and committed.
template <int D>
void advance(const Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
             StepTimes* times = nullptr);

/// The ledger at the instant of the last evaluation (before `advance`): stored terms from the state, given-off terms
/// from the running sums. Kinetic energy is that of the leapfrog scheme, half of m v(-) v(+).
template <int D>
Energy energy_now(const Model<D>& model, const State<D>& state, const Work<D>& work, const StepOptions& options);

}  // namespace trilith
