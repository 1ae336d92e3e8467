// How deep the bodies of two pieces are in each other, where pieces are thin against their bodies: elements of a fine
// mesh. Two of these overlap by no more than the thinner one's width, however deep their bodies are in each other.
#pragma once

#include "model/model.hpp"
#include "model/work.hpp"

namespace trilith {

/// Overlap of the bodies of pieces `p` and `q` where the two pieces overlap: distances from the middle of the shared
/// area to the surfaces of both bodies, together [m]. 0 where they share no area. `most`: any result below this is
/// accurate enough where the pieces' own surfaces show that the overlap is no larger. For work that is placed.
double body_depth(const Model<2>& model, const Work<2>& work, int p, int q, double most);

/// Depth of the surface of one piece in the body of the other after the surfaces have passed each other [m]. Inner
/// elements have no contact force, however deep their bodies are in each other. 0 where no surface is deeper in the
/// other body than its element is wide.
double passed_depth(const Model<2>& model, const Work<2>& work, int p, int q);

/// True where two pieces may overlap far less than their bodies: one is an element thinner than `allowed` [m].
bool is_thin_for(const Model<2>& model, const Work<2>& work, int p, int q, double allowed);

/// Least width of a piece as it is placed [m].
double piece_width(const Model<2>& model, const Work<2>& work, int piece);

/// Least thickness of a body behind its surface [m].
double body_thickness(const Model<2>& model, int body);

}  // namespace trilith
