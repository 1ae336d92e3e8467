// How the pieces of the skin of a mesh in space hang together: what contact of one of them asks of those next to it.
//
//      ___________________________
//     |\    a     /\           b /   Faces in one plane go on in each other: with how far each reaches, contact tells a
//     | \        /  \         /      sliver of a flat joint from an edge. And piece c, which has a face on the left
//     alone, |c \      /    \      /        ends at the plane above too, where a bounds it along an edge.
//     |___\____/______\___/
#pragma once

#include "model/model.hpp"

namespace trilith {

/// Fills ConvexSolid::goes_on of the pieces of a body of elements, from `first_piece` to the last of the model: beyond
/// an edge that two faces of the skin have in common, as far as the other one reaches, where their normals differ by no
/// more than those of faces that lie flat. Pieces none of whose faces goes on are left without.
void find_faces_in_line(Model<3>& model, int first_piece);

/// Fills Model::piece_bounds of the same pieces: faces of the skin that have a corner in common with a piece which lies
/// all on their inner side, look elsewhere than its own faces at that corner, and of which no inner face of it is a
/// part.
void find_bounds(Model<3>& model, int first_piece);

}  // namespace trilith
