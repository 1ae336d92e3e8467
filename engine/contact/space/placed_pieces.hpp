// Pieces placed by the general contact in one evaluation: once each, whatever the number of contacts.
#pragma once

#include <vector>

#include "contact/plane/overlap_pair.hpp"

namespace trilith {

/// Indices of the data that a piece is placed from: its first corner, the skin point of this corner, its first node.
struct PieceSource {
  int corner, skin, node;
};

/// Scratch data of one evaluation; kept for its capacity. Spans and pointers in `piece` point here.
struct PlacedPieces {
  std::vector<std::uint8_t> is_placed;  ///< [piece] see make_once: the other data is up to date
  std::vector<PlacedPiece> piece;       ///< [piece] views are kept between steps; cleared when pairs are new
  std::vector<PlacedPiece> over_step;   ///< [piece] with mean velocities; empty in explicit stages
  std::vector<Vec2> place;              ///< [corner] [m]
  std::vector<Vec2> velocity;           ///< [corner] [m/s] if a body deforms; else empty
  std::vector<Vec2> mean;               ///< [corner] [m/s] empty in explicit stages
  std::vector<EdgeRow> row;             ///< edges of a piece from first_row(...) on
  std::vector<PieceSource> source;      ///< [piece] kept between steps

  /// First row of a piece's edges: computed without a look-up, with capacity for groups of four.
  static constexpr std::size_t first_row(int piece, int first_corner) {
    return static_cast<std::size_t>((first_corner / lane_count + piece) * lane_count);
  }
};

}  // namespace trilith
