// Events of a step: bonds, bearings, contacts, seats, impacts, rest. The discrete changes that follow are applied too.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Compares State (committed) with the trial memories and appends to work.events in a fixed order: bonds and contacts
/// by row, bearings, seats, bodies. Failed bearings hand over to their successors.
void find_events(const Model<2>& model, State<2>& state, Work<2>& work);
void find_events(const Model<3>& model, State<3>& state, Work<3>& work);

/// Remaining overlap of the end of a span with its seat [m]; the seat is lost at 0 and below.
double seat_length(const Model<2>& model, const State<2>& state, const Seat<2>& seat);
double seat_length(const Model<3>& model, const State<3>& state, const Seat<3>& seat);

}  // namespace trilith
