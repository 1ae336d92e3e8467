// Update of the pair list for the pieces that are due, in the plane and in space.
#pragma once

#include <algorithm>
#include <vector>

#include "model/work.hpp"

namespace trilith {

inline ContactKey key_of(const NearPair& pair) {
  return contact_key(pair.piece_a, pair.piece_b);
}

template <int D>
bool is_due(const BroadPhaseState<D>& search, const NearPair& pair) {
  return search.is_due[pair.piece_a] != 0 || search.is_due[pair.piece_b] != 0;
}

/// Lists the rows that contain a piece that is due: BroadPhaseState::due_rows. `keys`: of all rows; they are denser in
/// memory than the pairs.
template <int D>
void list_due_rows(const std::vector<ContactKey>& keys, BroadPhaseState<D>& search) {
  search.due_rows.resize(keys.size());
  std::size_t due = 0;
  for (std::size_t row = 0; row < keys.size(); ++row) {
    search.due_rows[due] = static_cast<int>(row);
    due += search.is_due[first_piece(keys[row])] | search.is_due[second_piece(keys[row])];
  }
  search.due_rows.resize(due);
}

/// True where the pairs found equal the listed rows. Call after list_due_rows.
template <int D>
bool are_same(const Work<D>& work) {
  const BroadPhaseState<D>& search = work.search;
  return std::equal(search.due_rows.begin(), search.due_rows.end(), search.found.begin(), search.found.end(),
                    [&](int row, ContactKey key) { return key_of(work.pairs[row]) == key; });
}

}  // namespace trilith
