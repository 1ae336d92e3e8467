// The end of a step: the evaluated memories and sums become State.
#pragma once

#include "assembly/step_times.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Finds the events of the step that led to the evaluated instant (Work::events). Then copies the trial memories and
/// the ledger sums to State. The integrator updates time and motion.
template <int D>
void commit(const Model<D>& model, State<D>& state, Work<D>& work, StepTimes* times = nullptr);

}  // namespace trilith
