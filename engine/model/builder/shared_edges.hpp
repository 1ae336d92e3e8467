// Corners and, in space, edges of a body's surface that several of its convex pieces share.
//
//           shared edge
//            /|\ .
//           / | \ .
//          /  |  \ .
//         /  / \  \ .
//        /  /   \  \ .
//
// Contact at the top of a chevron or the corner of a mesh presses two or more pieces at one position. It is a single
// contact: its damping and friction use one direction (assembly/contact/shared_edge_normal.hpp). The hollow below is
// not a shared edge: a wedge in it has a contact with each flank. Where the surface continues straight from piece to
// piece, a shared edge is flat.
//
// Pieces share points at the same position at the start. A corner of one on the side of another is not shared.
#pragma once

#include <span>
#include <vector>

#include "model/model.hpp"

namespace trilith {

/// A shared edge as seen by a piece: the corners of the piece at its ends, twice the same for a shared corner.
struct SharedEdgePart {
  int ridge, from, to;
};

/// All shared edges of a model. Empty if no body has any.
struct SharedEdges {
  std::vector<int> part_first;  ///< [piece + 1]
  std::vector<SharedEdgePart> part;
  std::vector<int> piece_first;  ///< [ridge + 1]
  std::vector<int> piece;        ///< of each shared edge, increasing

  [[nodiscard]] bool empty() const { return part.empty(); }
  [[nodiscard]] std::span<const SharedEdgePart> parts_of(int piece_of) const {
    if (empty()) return {};
    const auto p = static_cast<std::size_t>(piece_of);
    return {part.data() + part_first[p], part.data() + part_first[p + 1]};
  }
  [[nodiscard]] std::span<const int> pieces_of(int ridge) const {
    const auto r = static_cast<std::size_t>(ridge);
    return {piece.data() + piece_first[r], piece.data() + piece_first[r + 1]};
  }
};

/// The shared edges that are convex or flat, including hollows up to 10 degrees, as in meshes of round holes.
template <int D>
SharedEdges shared_edges(const Model<D>& model);
extern template SharedEdges shared_edges(const Model<2>& model);
extern template SharedEdges shared_edges(const Model<3>& model);

}  // namespace trilith
