// Pair sleeping in space: pairs that are apart are skipped until their own motion may have brought them together. The
// motion is measured for each piece, so that a fast piece wakes only its own pairs.
#pragma once

#include <cstddef>

#include "model/work.hpp"

namespace trilith {

/// Sum of the travels of the two pieces of a pair, each by its farthest corner [m].
inline double way_of(const Work<3>& work, const NearPair& pair) {
  return work.solids.way[static_cast<std::size_t>(pair.piece_a)] +
         work.solids.way[static_cast<std::size_t>(pair.piece_b)];
}

/// True while a separated pair cannot have come into contact.
inline bool sleeps(const Work<3>& work, std::size_t row) {
  return way_of(work, work.pairs[row]) < work.asleep_until[row];
}
inline void let_sleep(Work<3>& work, std::size_t row) {
  work.asleep_until[row] = way_of(work, work.pairs[row]) + (1 - 1e-9) * work.solids.separation[row].distance;
}

}  // namespace trilith
