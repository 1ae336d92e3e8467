// Adjacency of the skin's pieces of a mesh in space: data of neighbouring pieces that contact needs.
//
//      ___________________________
//     |\    a     /\           b /
//     | \        /  \         /
//     |c \      /    \      /
//     |___\____/______\___/
//
// Coplanar faces continue each other. With the length of the continuation, contact can distinguish a sliver of a flat
// joint from an edge. Piece c, which has only a face on the left, also ends at the plane above, where face a bounds it
// along an edge.
#pragma once

#include "model/model.hpp"

namespace trilith {

/// Computes ConvexSolid::goes_on of the pieces of a body of elements, from `first_piece` to the model's last piece.
/// Beyond an edge common to two skin faces it is the extent of the other face, if their normals differ by no more than
/// the limit for flat faces. Pieces without any continuation are unchanged.
void find_faces_in_line(Model<3>& model, int first_piece);

/// Computes Model::piece_bounds of the same pieces. The list has skin faces that share a corner with the piece and have
/// the whole piece on their inner side. At that corner they face away from the piece's own faces, and no inner face of
/// the piece is a part of them.
void find_bounds(Model<3>& model, int first_piece);

}  // namespace trilith
