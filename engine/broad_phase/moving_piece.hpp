// Two moving convex pieces: their penetration depth, and a lower bound of the time until it increases.
#pragma once

#include <array>

#include "contact/plane/overlap_pair.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// A piece in the world, counter-clockwise, and its motion.
struct MovingPiece {
  int corners = 0;
  std::array<Vec2, max_piece_corners> at, velocity;  ///< [corner] [m], [m/s]
  const std::uint8_t* is_face = nullptr;             ///< [corner] see Model::edge_is_face
  double bend = 0;                                   ///< largest acceleration of a corner due to rotation [m/s2]
};

/// The piece `later` [s] after the state (before it if negative), at constant velocity and spin.
MovingPiece moving_piece(const Model<2>& model, const State<2>& state, int piece, double later = 0);

/// The least translation that separates two pieces.
struct PieceOverlap {
  double depth;  ///< through the surface of one of them: inner cuts of a body do not count [m]
  Vec2 at;       ///< the middle of the overlap [m]
  Vec2 normal;   ///< unit vector out of the overlap
  double whole;  ///< the same with inner cuts counted, at most `depth` [m]; not above 0: the pieces are apart
};
PieceOverlap overlap_of(const MovingPiece& a, const MovingPiece& b);

/// Lower bound, at most `longest` [s], of the time within which the penetration grows by no more than `depth` [m] if
/// the pieces continue their present motion. Pieces that are apart stay apart by `depth`, or approach by at most
/// `depth`. So an approaching piece does not reach the other one at the end of a long step. Above 0 where `longest` and
/// `depth` are.
///
/// The overlap of two pieces is at most their overlap along any direction. Along a fixed direction the overlap of
/// corners in straight motion is convex in time, so only its end value matters. Rotation adds at most half its
/// acceleration times the time squared. The directions tried are the normals of all edges.
double time_to_depth(const MovingPiece& a, const MovingPiece& b, double longest, double depth);

}  // namespace trilith
