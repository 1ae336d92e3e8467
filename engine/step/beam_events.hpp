// What happens to members that yield.
#pragma once

#include "world/work.hpp"

namespace trilith {

/// Adds an event for each beam of fibres that yields for the first time, and for each hinge that yields or is lost in
/// this step: what the trial memories say that the state does not.
void beam_events(const Model<2>& model, const State<2>& state, Work<2>& work);
void beam_events(const Model<3>& model, const State<3>& state, Work<3>& work);

}  // namespace trilith
