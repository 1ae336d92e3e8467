// Rows of contacts in the plane, parted between threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace trilith {

/// One whose processor is held up leaves runs to others; the more of them, the more bodies lie between two.
inline constexpr int runs_a_thread = 4;

/// Runs of rows that are answered one after the other, the same in every step, so that what they hold stays in the
/// cache of the thread that answers them.
struct RowShares {
  int threads = 0;                   ///< that they were made for; 0: not made since the pairs were found
  int evaluations = 0;               ///< since then
  std::vector<int> first;            ///< [run, and one more] the row that it begins with
  std::vector<std::uint8_t> border;  ///< [row] sides whose body has rows in more than one run, as bits
  std::vector<int> share_of;         ///< [body] room

  [[nodiscard]] int runs() const { return static_cast<int>(first.size()) - 1; }
  /// The pairs are others now.
  void forget() { threads = evaluations = 0; }
};

/// Rows of a list that one thread answers one after the other, and the first of the fours that keep what they come to.
struct RowRun {
  std::size_t first, last, four;
};

}  // namespace trilith
