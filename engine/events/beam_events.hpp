// Events of members that yield.
#pragma once

#include "model/work.hpp"

namespace trilith {

/// Adds an event for each fibre beam that yields for the first time, and for each hinge that yields or is lost in this
/// step. The events follow from a comparison of the trial memories with the state.
template <int D>
void beam_events(const Model<D>& model, const State<D>& state, Work<D>& work);

}  // namespace trilith
