// Events as a forest of causes, with the part of it that is worth a reader's first look.
#pragma once

#include <cstddef>
#include <vector>

#include "results/file/results.hpp"

namespace trilith::results {

/// Rows in time; `effects[i]` are the rows that row i led to, in time; `roots` those that nothing here led to.
struct EventTree {
  std::vector<EventRow> rows;
  std::vector<std::vector<std::size_t>> effects;
  std::vector<std::size_t> roots;
  std::vector<std::size_t> offspring;  ///< of each row: how many rows it led to, over all steps
  std::vector<bool> shown;             ///< of each row: among the chosen; where a row is chosen, so is what led to it
};

/// Loss of a bearing, a seat or a bond.
bool is_failure(const EventRow& event);

/// The events of `chosen` (in time, a part of `all`), each below the nearest of them in its chain of causes among
/// `all`. About `room` rows are shown: the first failure, lost bearings and seats, then what
/// led to most, and at last a sixth as many impacts, the fastest.
EventTree event_tree(const std::vector<EventRow>& all, std::vector<EventRow> chosen, std::size_t room);

}  // namespace trilith::results
