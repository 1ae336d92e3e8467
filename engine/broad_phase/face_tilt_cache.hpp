// Pairs of rigid pieces so tilted against each other that no two of their faces can be a pair of faces, for as long as
// they turn against each other by less than is left to that.
//
// In what tumbles nearly all pairs are so, and stay so for many steps. A face of a rigid piece turns as its body does,
// so the angle between two faces changes by no more than the rotations of both bodies change against each other. No
// result depends on what is remembered here: it answers what would be found if all edges were looked at again.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// The rotation of the second piece's body against that of the first [rad].
inline double turned_against(const Model<2>& model, const State<2>& state, const Work<2>& work, const NearPair& pair) {
  const auto rotation = [&](int piece) { return state.rotation[work.body[model.piece_body[piece]].node]; };
  return rotation(pair.piece_b) - rotation(pair.piece_a);
}

/// True where, by what is remembered, no two faces of the pair oppose each other within face_pair_max_tilt.
inline bool is_tilted(const Model<2>& model, const State<2>& state, const Work<2>& work, const NearPair& pair) {
  if (!(pair.tilted_from < pair.tilted_to)) return false;
  const double turned = turned_against(model, state, work, pair);
  return turned > pair.tilted_from && turned < pair.tilted_to;
}

/// Remembers of two pieces, none of whose faces are a pair of faces now, how far they may turn before two can be; of
/// bodies that deform nothing (Work must be placed from `state`).
void remember_tilt(const Model<2>& model, const State<2>& state, const Work<2>& work, NearPair& pair);

}  // namespace trilith
