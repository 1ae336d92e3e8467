// Two convex pieces that move: how deep they are in each other, and how long until they are deeper.
#pragma once

#include <array>

#include "contact/plane/overlap_pair.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// A piece where it stands, counter-clockwise, and how it moves.
struct MovingPiece {
  int corners = 0;
  std::array<Vec2, max_piece_corners> at, velocity;  ///< [corner] m, m/s
  const std::uint8_t* is_face = nullptr;             ///< [corner] see Model::edge_is_face
  double bend = 0;                                   ///< largest acceleration of a corner from turning [m/s2]
};

/// The piece `later` [s] than the state, which may be earlier, if all go on as they do now.
MovingPiece moving_piece(const Model<2>& model, const State<2>& state, int piece, double later = 0);

/// The least by which one of two pieces would have to be moved for them to be apart.
struct PieceOverlap {
  double depth;  ///< out of the surface of one of them: inner cuts of a body do not count [m]
  Vec2 at;       ///< the middle of it [m]
  Vec2 normal;   ///< the way out, a unit vector
  double whole;  ///< of the two pieces as they are, cuts and all, no more than `depth` [m]; not above 0: they are apart
};
PieceOverlap overlap_of(const MovingPiece& a, const MovingPiece& b);

/// The longest time up to `longest` [s] within which the two, as they move now, for certain get no deeper into each
/// other than by `depth` [m] more than now. Where they are apart they stay so by `depth`, or come no nearer than by
/// `depth`: what flies in does not meet the other at the end of a long step. Above 0 where `longest` and `depth` are.
///
/// Two pieces overlap by at most as much as they do along any one direction. Along a fixed direction the overlap of
/// corners that move straight on is convex in time, so it is enough to look at its end; turning adds half its
/// acceleration times the time squared at most. The directions tried are the normals of all edges.
double time_to_depth(const MovingPiece& a, const MovingPiece& b, double longest, double depth);

}  // namespace trilith
