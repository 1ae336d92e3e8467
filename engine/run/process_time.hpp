// Shift of the time courses of a model by a process, for runs that are continued after it.
#pragma once

#include "model/model.hpp"
#include "run/stage.hpp"

namespace trilith {

/// Repeats the shifts of a process that ended with this report, with the same rounding: the model is then as it was at
/// its end.
template <int D>
void postpone_by_process(Model<D>& model, const FieldProcess& process, const StageReport& ended);

}  // namespace trilith
