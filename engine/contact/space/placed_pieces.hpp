// Pieces as the general contact of one evaluation has placed them: each once, however many contacts it has.
#pragma once

#include <vector>

#include "contact/plane/overlap_pair.hpp"

namespace trilith {

/// Where what a piece is placed from begins: all that a contact must know to ask for it early.
struct PieceSource {
  int corner, skin, node;
};

/// Of no meaning outside the evaluation that fills it; kept for its room. Spans and pointers in `piece` point here.
struct PlacedPieces {
  std::vector<std::uint8_t> is_placed;  ///< [piece] see make_once: the rest is of now
  std::vector<PlacedPiece> piece;       ///< [piece] their views stay from step to step. Emptied where pairs are new
  std::vector<PlacedPiece> over_step;   ///< [piece] with mean velocities; empty in explicit stages
  std::vector<Vec2> place;              ///< [corner] m
  std::vector<Vec2> velocity;           ///< [corner] where a body deforms; else empty m/s
  std::vector<Vec2> mean;               ///< [corner] empty in explicit stages m/s
  std::vector<EdgeRow> row;             ///< of a piece from first_row(...) on
  std::vector<PieceSource> source;      ///< [piece] they stay too

  /// Where the edges of a piece begin: with as much room as fours of them may need, and no list to look it up in.
  static constexpr std::size_t first_row(int piece, int first_corner) {
    return static_cast<std::size_t>((first_corner / lane_count + piece) * lane_count);
  }
};

}  // namespace trilith
