// What bearings make of the contact of the two pieces they sit between.
#pragma once

#include <span>

#include "world/model.hpp"
#include "world/piece_search.hpp"
#include "world/state.hpp"
#include "world/work.hpp"

namespace trilith {

/// Notes in `search` the bearings that alter a contact, by the pieces they sit between.
template <int D>
void list_bearings(const Model<D>& model, PieceSearch<D>& search);

/// What the bearings between two pieces make of their contact: held off while one of them lives; after its failure, the
/// law it became. `bearings`: [bearing] their memories; `search` has them by the pieces they sit between.
template <int D>
void apply_bearings(const Model<D>& model, const PieceSearch<D>& search, std::span<const BearingMemory<D>> bearings,
                    NearPair& pair);

/// Whether a contact in space whose force is `force` [N] is the flat one that a live bearing stands for: the bearing's
/// axial direction is tilted on b against a by no more than faces may be to lie flat (face_pair_max_tilt), and the
/// force is nearer to it than to the seat's plane. Corners of what tilts, and what strikes from the side, touch.
bool presses_flat(const Model<3>& model, const State<3>& state, const PieceSearch<3>& search,
                  std::span<const BearingMemory<3>> bearings, const NearPair& pair, const Vec3& force);

}  // namespace trilith
