// The least length that two faces share where mortar bonds them.
#pragma once

#include <algorithm>

#include "model/model.hpp"

namespace trilith {

/// Faces that share less than this share of the smaller body's size are neighbours across a corner, displaced slightly
/// by settlement; no mortar bonds them [1].
inline constexpr double least_bonded_share = 1e-3;

/// Size of the smaller of the bodies of two pieces [m].
inline double smaller_size(const Model<2>& model, int piece_a, int piece_b) {
  return 2 * std::min(model.body_radius[model.piece_body[piece_a]], model.body_radius[model.piece_body[piece_b]]);
}

}  // namespace trilith
