// Functions shared by the contact stages, the step estimate and the ledger: laws in use, contact memories, and pieces
// in their present position.
#pragma once

#include <algorithm>
#include <array>

#include "contact/plane/overlap_pair.hpp"
#include "model/work.hpp"

namespace trilith {

/// Law `law` between the model's bodies, for a step `dt` [s].
inline LawInUse law_in_use(const Model<2>& model, int law, double dt = 0) {
  return {model.laws[law], model.thickness, dt};
}

/// The ends of the face between two skin points, in the kinematics of Work.
inline FaceEnds<double> face_ends(const Work<2>& work, int from, int to) {
  const SkinMotion<2>&p = work.skin[from], &q = work.skin[to];
  return {p.x, p.y, q.x, q.y, p.u, p.v, q.u, q.v};
}

/// The shared length of the two faces of a pair, in the kinematics of Work.
inline FaceOverlap<double> face_overlap(const Work<2>& work, const NearPair& p) {
  return {face_ends(work, p.a0, p.a1), face_ends(work, p.b0, p.b1)};
}

/// Buffers for the corners of a piece and, for a deformable body or after an implicit step, for their velocities.
struct PieceRoom {
  Vec2 *place, *velocity, *mean;
  PlacedPiece* over_step;  ///< with the mean velocities of an implicit step
};

/// Buffers for any piece.
struct PieceCorners {
  std::array<Vec2, max_piece_corners> place, velocity, mean;
  PlacedPiece over_step;

  PieceRoom room() { return {place.data(), velocity.data(), mean.data(), &over_step}; }
};

/// Connects `placed` with the data of a piece: views into Model and `room`, which remain valid from step to step.
/// move_piece() fills them.
void lay_piece(const Model<2>& model, const Work<2>& work, int piece, const PieceRoom& room, PlacedPiece& placed);
/// Writes the present position and motion of a piece to `room` and to `placed`, which lay_piece() connected. After an
/// implicit step this includes the mean velocities over the step, which determine slip and dissipation.
void move_piece(const Model<2>& model, const State<2>& state, const Work<2>& work, int piece, const PieceRoom& room,
                PlacedPiece& placed);
/// lay_piece() and move_piece(), returned as a value.
PlacedPiece placed_piece(const Model<2>& model, const State<2>& state, const Work<2>& work, int piece,
                         const PieceRoom& room);
inline PlacedPiece placed_piece(const Model<2>& model, const State<2>& state, const Work<2>& work, int piece,
                                PieceCorners& corners) {
  return placed_piece(model, state, work, piece, corners.room());
}

/// Marks all pieces of work.placed as not placed, and sizes the buffers.
void place_none(const Model<2>& model, Work<2>& work);
/// Places a piece in its present position, with its edges, in work.placed. The first contact that needs it does so, in
/// any thread.
void place_once(const Model<2>& model, const State<2>& state, Work<2>& work, int piece);

}  // namespace trilith
