// Pairs of solids that may touch before the next search.
//
// As detect/pairs.hpp in the plane: boxes widened by half a margin each; the list holds until some point has gone that
// far.
#pragma once

#include "world/model.hpp"
#include "world/state.hpp"
#include "world/work.hpp"

namespace trilith {

/// True where the list in `work` may miss a contact at the present pose.
bool pairs_outdated(const Work<3>& work);

/// Finds the pairs at the present pose (work.solids must be placed), in the order of their keys. Writes the detect part
/// of `work`.
void find_pairs(const Model<3>& model, const State<3>& state, Work<3>& work);

}  // namespace trilith
