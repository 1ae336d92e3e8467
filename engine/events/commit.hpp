// The end of a step: what was evaluated becomes the state.
#pragma once

#include "assembly/step_times.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Finds the events of the step that led to the evaluated instant (Work::events), then makes the trial memories and the
/// ledger's sums those of the state. Time and motion are the integrator's.
template <int D>
void commit(const Model<D>& model, State<D>& state, Work<D>& work, StepTimes* times = nullptr);

}  // namespace trilith
