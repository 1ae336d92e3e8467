// Cache of pairs of rigid pieces that are tilted so much that no two faces can form a face pair, valid within a range
// of their relative rotation.
//
// Among tumbling bodies nearly all pairs are tilted, and stay so for many steps. A face of a rigid piece rotates with
// its body, so the angle between two faces changes by at most the change of the relative rotation. The cache affects no
// result: it gives the same answer as a search over all edges.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Rotation of the second piece's body relative to the first one's [rad].
inline double turned_against(const Model<2>& model, const State<2>& state, const Work<2>& work, const NearPair& pair) {
  const auto rotation = [&](int piece) { return state.rotation[work.body[model.piece_body[piece]].node]; };
  return rotation(pair.piece_b) - rotation(pair.piece_a);
}

/// True where the cache shows that no two faces of the pair oppose each other within face_pair_max_tilt.
inline bool is_tilted(const Model<2>& model, const State<2>& state, const Work<2>& work, const NearPair& pair) {
  if (!(pair.tilted_from < pair.tilted_to)) return false;
  const double turned = turned_against(model, state, work, pair);
  return turned > pair.tilted_from && turned < pair.tilted_to;
}

/// Caches, for two pieces without a face pair now, the range of relative rotation without one. Does nothing for
/// deformable bodies (Work must be placed from `state`).
void remember_tilt(const Model<2>& model, const State<2>& state, const Work<2>& work, NearPair& pair);

}  // namespace trilith
