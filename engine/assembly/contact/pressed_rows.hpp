// Rows of polyhedra of any shape whose pressed triangles are summed and that wait for the kernel of four contacts
// (contact/space/pressed_contact.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "contact/space/pressed_contact.hpp"

namespace trilith {

class PressedRows {
 public:
  /// Destination of the sums of the next row.
  [[nodiscard]] PairSums& next() { return sums_[count_]; }
  void add(int row) { row_[count_++] = row; }
  [[nodiscard]] bool full() const { return count_ == row_.size(); }
  [[nodiscard]] std::span<const int> rows() const { return {row_.data(), count_}; }
  /// Takes out all rows; lanes beyond the last row repeat it.
  std::array<int, lane_count> take(PressedContacts& in) {
    for (; count_ < row_.size(); ++count_) row_[count_] = row_[count_ - 1], sums_[count_] = sums_[count_ - 1];
    for (std::size_t i = 0; i < sums_.size(); ++i) in.sums[i] = &sums_[i];
    count_ = 0;
    return row_;
  }

 private:
  std::size_t count_ = 0;
  std::array<int, lane_count> row_;
  std::array<PairSums, lane_count> sums_;
};

}  // namespace trilith
