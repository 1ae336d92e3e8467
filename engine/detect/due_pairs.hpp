// Pairs of which a piece is looked up: what searching asks of the list that there is, in the plane and in space.
#pragma once

#include "world/work.hpp"

namespace trilith {

inline ContactKey key_of(const NearPair& pair) {
  return contact_key(pair.piece_a, pair.piece_b);
}

template <int D>
bool is_due(const PieceSearch<D>& search, const NearPair& pair) {
  return search.is_due[pair.piece_a] != 0 || search.is_due[pair.piece_b] != 0;
}

/// True where the pairs found are those that were there.
template <int D>
bool same_keys(const Work<D>& work) {
  std::size_t next = 0;
  for (const NearPair& pair : work.pairs) {
    if (!is_due(work.search, pair)) continue;
    if (next == work.search.found.size() || work.search.found[next] != key_of(pair)) return false;
    ++next;
  }
  return next == work.search.found.size();
}

}  // namespace trilith
