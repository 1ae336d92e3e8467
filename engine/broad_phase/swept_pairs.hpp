// Pieces that may meet within a time, as everything moves now, however far that is.
#pragma once

#include <utility>
#include <vector>

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// True where the fastest points move by less than `share` of any thickness, against each other, in `dt` [s]: one
/// comparison. Work must be placed.
inline bool goes_slowly(const Model<2>& model, const Work<2>& work, double dt, double share) {
  // Two against each other, and a fourth of that for what turning adds in so short a time.
  return 2.5 * work.fastest * dt <= share * model.least_thickness;
}

/// Pairs of pieces (lower index first, sorted) of two bodies with a contact law, one of which moves, that may meet in
/// the time from now to `dt` [s] later, or earlier where dt is below 0, and move against each other by more than
/// `share` of the thinner one's thickness in it. What all move by together does not count. Work must be placed.
std::vector<std::pair<int, int>> swept_pairs(const Model<2>& model, const State<2>& state, const Work<2>& work,
                                             double dt, double share);

}  // namespace trilith
