// Candidate pairs of solids in space.
//
// Like broad_phase/broad_phase_update.hpp in the plane. Each piece has a box enlarged by a margin, and along its path
// where it is fast. Only pieces that have left their boxes, or will shortly, are updated.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// The AABB of a placed solid, and a box enlarged by a length on every side [m].
FatBox<3> box_around(const PlacedSolid& solid);
FatBox<3> widened(FatBox<3> box, double by);

/// True where a piece has left its box (work.solids must be placed); then `due` of work.search lists all such pieces.
/// Otherwise the next check is postponed until the fastest point has used up the remaining budget.
bool solids_are_due(const Model<3>& model, const State<3>& state, Work<3>& work);

/// Updates the due pieces and patches the list of pairs, in the order of their keys; false where it is unchanged.
/// Writes the broad-phase part of `work`. A pair with a memory stays, at any distance.
bool find_solid_pairs(const Model<3>& model, const State<3>& state, Work<3>& work);

}  // namespace trilith
