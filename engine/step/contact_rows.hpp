// What the contact stages, the step estimate and the ledger share: a law's numbers, and a piece where it stands.
#pragma once

#include "contact/face_pair.hpp"
#include "contact/overlap_pair.hpp"
#include "world/work.hpp"

namespace trilith {

/// The numbers of law `law` times the model's thickness, for a step `dt` [s].
FaceLaw face_law(const Model<2>& model, int law, double dt);

/// A piece's corners where they stand, and the motion of its body; views into Model and `corners`.
PlacedPiece placed_piece(const Model<2>& model, const State<2>& state, const Work<2>& work, int piece,
                         std::span<Vec2> corners);

}  // namespace trilith
