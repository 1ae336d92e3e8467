// Incremental update of the broad phase: finds the pieces that have left their fat boxes and gives them new ones.
//
// Each piece has a fat AABB around its position at the last update, enlarged by a motion budget: a share of its size,
// and a distance along its path if it is fast. Two pieces whose boxes do not meet cannot touch while all their corners
// stay within their budgets. So only pieces that leave their boxes are updated, and standing pieces cost nothing while
// others fall.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Resets all pieces: each one is due for an update (Work must be placed).
void update_broad_phase(const Model<2>& model, const State<2>& state, Work<2>& work);

/// True where a piece has left its box. Then `due` of work.search lists all pieces that have left or will leave
/// shortly, so that they are updated together. Otherwise the next check is postponed until the fastest point has used
/// up the remaining budget.
bool some_are_due(const Model<2>& model, const State<2>& state, Work<2>& work);

/// Builds new boxes around the present positions of the pieces that are due.
void place_boxes(const Model<2>& model, const State<2>& state, Work<2>& work);

/// Upper bound of the distance that a corner of a piece may move from its position at this update until the piece's
/// next update [m].
double reach_of(const BroadPhaseState<2>& search, int piece);

}  // namespace trilith
