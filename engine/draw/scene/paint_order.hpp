// Painting order of convex pieces, so that each covers the pieces behind it: hidden surfaces without pixels.
#pragma once

#include <vector>

#include "draw/scene/solid_piece.hpp"
#include "draw/scene/view_direction.hpp"

namespace trilith::draw {

/// The pieces from the farthest to the nearest. If two pieces cover each other in the picture, the one on the eye's
/// side of a separating plane comes later, which is exact for convex pieces that do not overlap in space. If three or
/// more form a cycle, one of them is divided. Overlapping pieces are ordered along the direction of least overlap. The
/// run time grows with the pairs that cover each other: 1 s for 5,000 stones in a heap.
std::vector<SolidPiece> paint_order(std::vector<SolidPiece> pieces, const ViewAxes& view);

/// The convex hull of points in the plane, anticlockwise; fewer than 3 points if they lie on a line.
std::vector<Vec2> hull_of(std::vector<Vec2> points);

}  // namespace trilith::draw
