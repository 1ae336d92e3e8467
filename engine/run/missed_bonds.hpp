// Faces that a law would bond if there were no gap between them. They are reported before a run, because nothing else
// shows them.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Pairs of opposed faces under a bonding law that are not bonded because of a gap of up to 1 % of the smaller body's
/// size.
struct MissedBonds {
  int count = 0;
  // The first pair:
  int body_a = -1, body_b = -1, law = -1;
  double gap = 0;  ///< largest gap between its faces [m]
};

/// Missed bonds of a model in the given state. Gaps wider than the search range of contacts are not found.
MissedBonds missed_bonds(const Model<2>& model, const State<2>& state);
MissedBonds missed_bonds(const Model<3>& model, const State<3>& state);

}  // namespace trilith
