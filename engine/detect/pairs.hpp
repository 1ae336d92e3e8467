// Pairs of pieces that may touch before the next search, and the faces of theirs that look at each other.
//
// Three levels: boxes on a grid, widened by a margin; facing of faces; the exact overlap, which is the contact
// kernel's own. The list holds until some body has moved half the margin beside what all have moved by together, as
// those of a structure do that goes with its ground.
#pragma once

#include <span>

#include "world/model.hpp"
#include "world/state.hpp"
#include "world/work.hpp"

namespace trilith {

/// True where the list in `work` may miss a contact at the present pose. Bodies are looked at only once the fastest
/// point has travelled so far that one of them may have moved half the margin.
bool pairs_outdated(const Model<2>& model, const State<2>& state, Work<2>& work);

/// Finds the pairs at the present pose (work.skin must be placed). Writes the detect part of `work`.
void find_pairs(const Model<2>& model, const State<2>& state, Work<2>& work);

/// The one pair of faces of two pieces that touch flatly, if there is just one; where a bond holds, the pair at the
/// smallest gap. Fills the face fields of `pair`. A function of the present pose alone.
bool choose_face_pair(const Model<2>& model, const Work<2>& work, bool bonded, NearPair& pair);

/// Law between two bodies' surfaces, -1 for none.
int contact_law(const Model<2>& model, int body_a, int body_b);

/// What the bearings between two pieces make of their contact: held off while one of them lives; after its failure, the
/// law it became. `bearings`: [bearing] their memories.
void apply_bearings(const Model<2>& model, std::span<const BearingMemory> bearings, NearPair& pair);

}  // namespace trilith
