// What the contacts remember, row by row.
#pragma once

#include <cstdint>
#include <vector>

#include "contact/list.hpp"

namespace trilith {

/// The two pieces of a contact, lower index first, in one sortable number.
using ContactKey = std::uint64_t;
constexpr ContactKey contact_key(int piece_a, int piece_b) {
  return static_cast<ContactKey>(static_cast<std::uint32_t>(piece_a)) << 32 | static_cast<std::uint32_t>(piece_b);
}
constexpr int first_piece(ContactKey key) {
  return static_cast<int>(key >> 32);
}
constexpr int second_piece(ContactKey key) {
  return static_cast<int>(key & 0xffffffffU);
}

/// Sorted by key; every contact that remembers something, and any number of empty ones.
struct ContactHistory {
  std::vector<ContactKey> key;        ///< [contact]
  std::vector<ContactMemory> memory;  ///< [contact]
  std::vector<LawRow> law_row;        ///< [contact]
  std::vector<double> law_memory;     ///< what the laws remember beside that, row after row

  [[nodiscard]] std::size_t size() const { return key.size(); }
  /// What the law of a contact remembers.
  [[nodiscard]] const double* law_numbers(std::size_t row) const { return law_memory.data() + law_row[row].first; }
  [[nodiscard]] double* law_numbers(std::size_t row) { return law_memory.data() + law_row[row].first; }
  /// Lets a contact forget everything.
  void clear(std::size_t row);
  /// The row of a contact, or -1.
  [[nodiscard]] int find(ContactKey contact) const;
};

}  // namespace trilith
