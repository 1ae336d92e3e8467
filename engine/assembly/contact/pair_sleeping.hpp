// What two solids do not have to be asked anew before they have gone some way: each by its own, so that what flies past
// wakes none that stand.
#pragma once

#include <cstddef>

#include "model/work.hpp"

namespace trilith {

/// How far the two pieces of a pair have gone together, each by its corner that went farthest [m].
inline double way_of(const Work<3>& work, const NearPair& pair) {
  return work.solids.way[static_cast<std::size_t>(pair.piece_a)] +
         work.solids.way[static_cast<std::size_t>(pair.piece_b)];
}

/// A pair that was found apart sleeps until both may have gone far enough to have come together.
inline bool sleeps(const Work<3>& work, std::size_t row) {
  return way_of(work, work.pairs[row]) < work.asleep_until[row];
}
inline void let_sleep(Work<3>& work, std::size_t row) {
  work.asleep_until[row] = way_of(work, work.pairs[row]) + (1 - 1e-9) * work.solids.separation[row].distance;
}

}  // namespace trilith
