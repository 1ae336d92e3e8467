// Corners and, in space, edges of a body's surface that several of its convex pieces share.
//
//          ridge
//           /|\           What presses the ridge of a chevron or the corner of a mesh presses two pieces or more at one
//          / | \          place. That is one contact: its damping and its friction know one direction
//         /  |  \         (assembly/contact/shared_edge_normal.hpp). The hollow below is no ridge: a wedge in it has a
//         contact with either
//        /  / \  \        flank.
//       /  /   \  \       Where the surface goes straight on from piece to piece, a ridge is flat.
//
// Pieces share what stands at the same place at the start. A corner of one on the side of another is not shared.
#pragma once

#include <span>
#include <vector>

#include "model/model.hpp"

namespace trilith {

/// A ridge as a piece has it: the corners of the piece at its ends, the same corner twice where it is a corner.
struct SharedEdgePart {
  int ridge, from, to;
};

/// All ridges of a model. Empty where no body has any.
struct SharedEdges {
  std::vector<int> part_first;  ///< [piece + 1]
  std::vector<SharedEdgePart> part;
  std::vector<int> piece_first;  ///< [ridge + 1]
  std::vector<int> piece;        ///< of each ridge rising

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

/// Those that stand out or are flat, up to hollows of 10 degrees, which meshes of round holes have.
template <int D>
SharedEdges shared_edges(const Model<D>& model);
extern template SharedEdges shared_edges(const Model<2>& model);
extern template SharedEdges shared_edges(const Model<3>& model);

}  // namespace trilith
