// Pairs of pieces that may touch before the next search, and the faces of theirs that look at each other.
//
// Three levels: boxes that each piece keeps within until it is looked up again (broad_phase/broad_phase_update.hpp);
// facing of faces; the exact overlap, which is the contact kernel's own. The list is patched where pieces have left
// their boxes; which rows it has beyond those that touch depends on when that was, and no result does.
#pragma once

#include <span>

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// True where the list in `work` may miss a contact at the present pose. Bodies are looked at only once the fastest
/// point has travelled so far that one of them may have left its box.
bool pairs_outdated(const Model<2>& model, const State<2>& state, Work<2>& work);

/// Finds the pairs of the pieces that are due at the present pose, or of all where `work` is not valid (work.skin must
/// be placed). Writes the detect part of `work`. A pair that remembers something stays. False: the rows are as before.
bool find_pairs(const Model<2>& model, const State<2>& state, Work<2>& work);

/// The one pair of faces of two pieces that touch flatly, if there is just one; where a bond holds, the pair at the
/// smallest gap. Fills the face fields of `pair`. A function of the present pose alone.
bool choose_face_pair(const Model<2>& model, const Work<2>& work, bool bonded, NearPair& pair);

/// Law between two bodies' surfaces, -1 for none.
int contact_law(const Model<2>& model, int body_a, int body_b);

}  // namespace trilith
