// Partition of contact rows in the plane over threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace trilith {

/// Number of runs per thread. A delayed thread leaves runs to others; but more runs have more bodies on their borders.
inline constexpr int runs_a_thread = 4;

/// Runs of rows that are computed in order, the same in every step, so that their data stays in the cache of one
/// thread.
struct RowShares {
  int threads = 0;         ///< number of threads of the partition; 0: not partitioned after the last pair update
  int evaluations = 0;     ///< number of evaluations with the partition
  std::vector<int> first;  ///< [run + 1] first row of each run
  std::vector<std::uint8_t> border;  ///< [row] bit set of the sides whose body has rows in more than one run
  std::vector<int> share_of;         ///< [body] scratch

  [[nodiscard]] int runs() const { return static_cast<int>(first.size()) - 1; }
  /// Invalidates the partition after a change of the pairs.
  void forget() { threads = evaluations = 0; }
};

/// Rows of a list that one thread computes in order, and the index of their first group of four results.
struct RowRun {
  std::size_t first, last, four;
};

}  // namespace trilith
