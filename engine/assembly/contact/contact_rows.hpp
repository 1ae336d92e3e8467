// What the contact stages, the step estimate and the ledger share: laws in use, what they remember, and pieces where
// they stand.
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

/// The ends of the face between two skin points, as Work is placed.
inline FaceEnds<double> face_ends(const Work<2>& work, int from, int to) {
  const SkinMotion<2>&p = work.skin[from], &q = work.skin[to];
  return {p.x, p.y, q.x, q.y, p.u, p.v, q.u, q.v};
}

/// Where the two faces of a pair share length, as Work is placed.
inline FaceOverlap<double> face_overlap(const Work<2>& work, const NearPair& p) {
  return {face_ends(work, p.a0, p.a1), face_ends(work, p.b0, p.b1)};
}

/// Where a piece's corners go, and where its body deforms or an implicit step was taken, their velocities.
struct PieceRoom {
  Vec2 *place, *velocity, *mean;
  PlacedPiece* over_step;  ///< with the mean velocities of an implicit step
};

/// Such room for any piece.
struct PieceCorners {
  std::array<Vec2, max_piece_corners> place, velocity, mean;
  PlacedPiece over_step;

  PieceRoom room() { return {place.data(), velocity.data(), mean.data(), &over_step}; }
};

/// Makes `placed` a piece that move_piece() will find: views into Model and `room`, which stay from step to step.
void lay_piece(const Model<2>& model, const Work<2>& work, int piece, const PieceRoom& room, PlacedPiece& placed);
/// Writes to `room` and to `placed`, which was laid in it, where a piece stands and how it moves. Where an implicit
/// step was taken it comes with its mean velocities over the step, by which slip and losses go.
void move_piece(const Model<2>& model, const State<2>& state, const Work<2>& work, int piece, const PieceRoom& room,
                PlacedPiece& placed);
/// Both, as a value.
PlacedPiece placed_piece(const Model<2>& model, const State<2>& state, const Work<2>& work, int piece,
                         const PieceRoom& room);
inline PlacedPiece placed_piece(const Model<2>& model, const State<2>& state, const Work<2>& work, int piece,
                                PieceCorners& corners) {
  return placed_piece(model, state, work, piece, corners.room());
}

/// None of the pieces of work.placed is placed; there is room for all.
void place_none(const Model<2>& model, Work<2>& work);
/// A piece as it stands now, with its edges, in work.placed: placed by the first of its contacts that asks, in whatever
/// thread.
void place_once(const Model<2>& model, const State<2>& state, Work<2>& work, int piece);

}  // namespace trilith
