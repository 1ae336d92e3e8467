// Cutting polygons by a straight line.
#pragma once

#include <vector>

#include "geometry/plane/polygon.hpp"

namespace trilith {

/// The side of a line on which normal . p <= offset; `normal` of any length above 0.
struct HalfPlane {
  Vec2 normal;
  double offset;
};

/// What of a simple counter-clockwise polygon lies in the half-plane: none, one or (of a concave outline) several
/// simple counter-clockwise polygons, in the order in which the outline first enters them. A corner on the line counts
/// as outside, but where none lies beyond the line. Corners nearer to each other than `same` (m, not below 0) become
/// one; what has no area then is left out.
std::vector<Polygon> cut_by(const Polygon& outline, const HalfPlane& half_plane, double same);

/// The outline without corners that lie nearer than `same` (m) to the one before; empty where fewer than 3 are left.
Polygon without_doubles(const Polygon& outline, double same);

}  // namespace trilith
