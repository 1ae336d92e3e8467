// Rows of contacts in the plane, parted between threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace trilith {

/// Which thread answers which rows, the same in every step, so that what they hold stays in its cache.
struct RowShares {
  int threads = 0;                   ///< that they were made for; 0: not made since the pairs were found
  int evaluations = 0;               ///< since then
  std::vector<int> first;            ///< [thread, and one more] the row that its share begins with
  std::vector<std::uint8_t> border;  ///< [row] sides whose body has rows in more than one share, as bits
  std::vector<int> share_of;         ///< [body] room

  /// The pairs are others now.
  void forget() { threads = evaluations = 0; }
};

/// Rows of a list that one thread answers one after the other, and the first of the fours that keep what they come to.
struct RowRun {
  std::size_t first, last, four;
};

}  // namespace trilith
