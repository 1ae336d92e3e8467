// Events as a forest of causes, with the part to show first.
#pragma once

#include <cstddef>
#include <vector>

#include "results/file/results.hpp"

namespace trilith::results {

/// Rows sorted by time; `effects[i]` are the rows that row i caused, sorted by time; `roots` are rows without a cause
/// in the tree.
struct EventTree {
  std::vector<EventRow> rows;
  std::vector<std::vector<std::size_t>> effects;
  std::vector<std::size_t> roots;
  std::vector<std::size_t> offspring;  ///< of each row: number of rows that it caused, directly or indirectly
  std::vector<bool> shown;             ///< of each row: shown at first; with a row all its causes are shown
};

/// A bond, a support, a member or an element is lost.
bool is_failure(const EventRow& event);

/// The events of `chosen` (sorted by time, a part of `all`), each below the nearest chosen one in its chain of causes
/// in `all`. About `room` rows are shown: the first failure, lost bearings and seats, then the rows with most effects,
/// and finally the fastest impacts, up to a sixth of the rows.
EventTree event_tree(const std::vector<EventRow>& all, std::vector<EventRow> chosen, std::size_t room);

}  // namespace trilith::results
