// Seats: whether the end of a span still lies on its support.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Adds an event to work.events for each seat that is lost in this step. A loss is permanent and stored in
/// State::seat_lost.
template <int D>
void seat_events(const Model<D>& model, State<D>& state, Work<D>& work);

}  // namespace trilith
