// What the contact stages, the step estimate and the ledger share: a law's numbers, and a piece where it stands.
#pragma once

#include <array>

#include "contact/face_pair.hpp"
#include "contact/overlap_pair.hpp"
#include "world/work.hpp"

namespace trilith {

/// The numbers of law `law` times the model's thickness, for a step `dt` [s].
FaceLaw face_law(const Model<2>& model, int law, double dt);

/// Room for a piece's corners where they stand and, where its body deforms, their velocities.
struct PieceCorners {
  std::array<Vec2, max_piece_corners> place, velocity;
};

/// A piece where it stands and how it moves; views into Model and `corners`.
PlacedPiece placed_piece(const Model<2>& model, const State<2>& state, const Work<2>& work, int piece,
                         PieceCorners& corners);

}  // namespace trilith
