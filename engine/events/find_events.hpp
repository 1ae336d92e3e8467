// What happened in a step: bonds, bearings, contacts, seats, impacts, rest; and the discrete changes that follow.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Compares State (before) with the trial memories, appends to work.events in a fixed order (bonds and contacts by
/// row, bearings, seats, bodies), and lets failed bearings hand on to their successors.
void find_events(const Model<2>& model, State<2>& state, Work<2>& work);
void find_events(const Model<3>& model, State<3>& state, Work<3>& work);

/// Length the end still reaches over the edge of its seat [m]; not above 0: the seat is lost.
double seat_length(const Model<2>& model, const State<2>& state, const Seat<2>& seat);
double seat_length(const Model<3>& model, const State<3>& state, const Seat<3>& seat);

}  // namespace trilith
