// Candidate pairs: pieces that may touch before the next update, and their opposed faces.
//
// Three levels: fat boxes of the pieces (broad_phase/broad_phase_update.hpp); opposed faces; the exact overlap in the
// contact kernel. The list is patched where pieces have left their boxes. The time of the updates affects which rows
// without contact it has, but no result.
#pragma once

#include <span>

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// True where the list in `work` may miss a contact in the present configuration. Bodies are checked only once the
/// fastest point has travelled far enough for one of them to have left its box.
bool pairs_outdated(const Model<2>& model, const State<2>& state, Work<2>& work);

/// Updates the candidate pairs of the pieces that are due in the present configuration, or of all pieces where `work`
/// is not valid (work.skin must be placed). Writes the broad-phase part of `work`. A pair with a memory stays. Returns
/// false if the rows are unchanged.
bool find_pairs(const Model<2>& model, const State<2>& state, Work<2>& work);

/// The face pair of two pieces that touch flatly, if there is exactly one; with a bond, the pair with the smallest gap.
/// Sets the face fields of `pair`. Depends on the present configuration alone.
bool choose_face_pair(const Model<2>& model, const Work<2>& work, bool bonded, NearPair& pair);

/// The face pair with the smallest gap of two pieces with a bond, which lasts when its faces tilt, up to 0.2. Edges
/// next to them differ by more. As above otherwise.
bool choose_bonded_faces(const Model<2>& model, const Work<2>& work, NearPair& pair);

/// Index of the contact law between two bodies' surfaces, -1 for none.
int contact_law(const Model<2>& model, int body_a, int body_b);

}  // namespace trilith
