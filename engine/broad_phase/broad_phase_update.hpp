// Which pieces have to be looked up again, as they have gone as far as their boxes allow, and the boxes they get.
//
// Each piece has a box around where it was looked up, wider by what it may move: by its size, and along its way where
// it is fast. Two pieces whose boxes do not meet cannot touch as long as all of their corners keep within what was
// allowed them. So only what leaves its box is looked up again, and what stands costs nothing while something else
// falls.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Forgets all pieces: every one is due (Work must be placed).
void update_broad_phase(const Model<2>& model, const State<2>& state, Work<2>& work);

/// True where some piece has left its box; then `due` of work.search has all that have or will have shortly, so that
/// they are looked up together. Else the next look is put off until the fastest point has gone as far as is left.
bool some_are_due(const Model<2>& model, const State<2>& state, Work<2>& work);

/// Gives the pieces that are due new boxes around where they are now.
void place_boxes(const Model<2>& model, const State<2>& state, Work<2>& work);

/// The farthest that a corner of a piece may be moved from where it is, at the last search, up to the next time that it
/// is looked up [m].
double reach_of(const BroadPhaseState<2>& search, int piece);

}  // namespace trilith
