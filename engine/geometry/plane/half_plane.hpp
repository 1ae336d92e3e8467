// Clips polygons by a straight line.
#pragma once

#include <vector>

#include "geometry/plane/polygon.hpp"

namespace trilith {

/// The half-plane normal . p <= offset; `normal` has any length above 0.
struct HalfPlane {
  Vec2 normal;
  double offset;
};

/// The part of a simple counter-clockwise polygon in the half-plane: no, one or, for a concave outline, several simple
/// counter-clockwise polygons, in the order in which the outline first enters them. A corner on the line counts as
/// outside, unless no corner lies beyond the line. Corners nearer to each other than `same` (not below 0) [m] are
/// merged; parts without area are left out.
std::vector<Polygon> cut_by(const Polygon& outline, const HalfPlane& half_plane, double same);

/// The outline without corners nearer than `same` [m] to their predecessor; empty where fewer than 3 are left.
Polygon without_doubles(const Polygon& outline, double same);

}  // namespace trilith
