// What happens to members that yield.
#pragma once

#include "model/work.hpp"

namespace trilith {

/// Adds an event for each beam of fibres that yields for the first time, and for each hinge that yields or is lost in
/// this step: what the trial memories say that the state does not.
template <int D>
void beam_events(const Model<D>& model, const State<D>& state, Work<D>& work);

}  // namespace trilith
