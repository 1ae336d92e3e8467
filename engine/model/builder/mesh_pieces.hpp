// Elements of a mesh as pieces for contact, and the neighbours of skin points along straight sides.
#pragma once

#include "geometry/plane/mesh.hpp"
#include "model/model.hpp"

namespace trilith {

/// Elements as pieces for contact: all of them, or those with an edge on the boundary.
void append_element_pieces(const Mesh& mesh, bool all, int body, Model<2>& model);

/// Skin points are their own neighbours, except where a side is straight.
void fill_lines(Model<2>& model);

}  // namespace trilith
