// In which order convex pieces are painted so that each covers what is behind it: hidden surfaces without a pixel.
#pragma once

#include <vector>

#include "draw/scene/solid_piece.hpp"
#include "draw/scene/view_direction.hpp"

namespace trilith::draw {

/// The pieces from the farthest to the nearest. Of two that cover each other in the picture the one on the eye's side
/// of a plane between them comes later: exact for convex pieces that do not overlap in space. Where three or more lie
/// around in a ring, each before the next, one of them is divided; what overlaps in space is ordered along the
/// direction in which it does so least. Time grows as the pairs that cover each other: a second for 5,000 stones in a
/// heap.
std::vector<SolidPiece> paint_order(std::vector<SolidPiece> pieces, const ViewAxes& view);

/// The convex polygon around points of the plane, anticlockwise; fewer than 3 where they lie on a line.
std::vector<Vec2> hull_of(std::vector<Vec2> points);

}  // namespace trilith::draw
