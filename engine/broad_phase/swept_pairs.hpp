// Pieces that may meet within a time at their present motion, however far that is.
#pragma once

#include <utility>
#include <vector>

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// True where the fastest points move, relative to each other, by less than `share` of any thickness in `dt` [s]: one
/// comparison. Work must be placed.
inline bool goes_slowly(const Model<2>& model, const Work<2>& work, double dt, double share) {
  // Factor 2 for two pieces against each other, and a quarter more for rotation in such a short time.
  return 2.5 * work.fastest * dt <= share * model.least_thickness;
}

/// Pairs of pieces (lower index first, sorted) that may meet between now and `dt` [s] later, or earlier where dt is
/// negative. The two bodies have a contact law, one of them moves, and their relative motion exceeds `share` of the
/// thinner piece's thickness. Common motion of all bodies does not count. Work must be placed.
std::vector<std::pair<int, int>> swept_pairs(const Model<2>& model, const State<2>& state, const Work<2>& work,
                                             double dt, double share);

}  // namespace trilith
