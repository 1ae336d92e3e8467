// Pairs of solids that may touch before the next search.
//
// As broad_phase/broad_phase_update.hpp in the plane: each piece has a box that is wider than it by a margin, and along
// its way where it is fast, and only pieces that have left theirs or will have shortly are looked up again.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// The box of a solid where it stands, and one that is wider by some length on every side [m].
FatBox<3> box_around(const PlacedSolid& solid);
FatBox<3> widened(FatBox<3> box, double by);

/// True where some piece has left its box (work.solids must be placed); then `due` of work.search has them all. Else
/// the next look is put off until the fastest point has gone as far as is left.
bool solids_are_due(const Model<3>& model, const State<3>& state, Work<3>& work);

/// Looks up the pieces that are due and patches the list of pairs, in the order of their keys; false where it is as it
/// was. Writes the detect part of `work`. A pair that remembers something stays, however far apart it is.
bool find_solid_pairs(const Model<3>& model, const State<3>& state, Work<3>& work);

}  // namespace trilith
