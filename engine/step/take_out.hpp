// Bodies that have left the bounds: they stand still where they are and are no longer part of the step.
#pragma once

#include <span>
#include <vector>

#include "step/central_difference.hpp"
#include "world/model.hpp"
#include "world/state.hpp"
#include "world/work.hpp"

namespace trilith {

/// Takes `bodies` out of the step at an evaluated instant, which is evaluated anew. They touch nothing from then on,
/// their bearings fail, and what they held (motion, elastic energy of what they touched) goes to the ledger's
/// EnergyTerm::left_bounds. Gives what is to be told: body.left, and bearing.failed of those that were live.
template <int D>
std::vector<Event> take_out(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
                            std::span<const int> bodies);

/// Holds all that has left by the state, whatever the model says of its supports. True where something has left and
/// nothing is free to move any more.
template <int D>
bool hold_left(Model<D>& model, const State<D>& state);

}  // namespace trilith
