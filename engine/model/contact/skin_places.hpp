// Position of a skin point: it moves with one node and rotates with one, which may be a different one
// (Model::skin_node, Model::skin_turn).
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// At the start [m].
template <int D>
Vec<D> skin_start(const Model<D>& model, int skin) {
  const Vec<D> arm = turn_of(model.start_rotation[model.skin_turn[skin]]).apply(model.skin_place[skin]);
  return model.start_position[model.skin_node[skin]] + arm;
}

/// In `state` [m].
template <int D>
Vec<D> skin_now(const Model<D>& model, const State<D>& state, int skin) {
  const Vec<D> arm = turn_of(state.rotation[model.skin_turn[skin]]).apply(model.skin_place[skin]);
  return state.position[model.skin_node[skin]] + arm;
}

}  // namespace trilith
