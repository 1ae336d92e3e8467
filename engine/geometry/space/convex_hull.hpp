// The convex hull of a few points in space, as a solid with plane faces.
#pragma once

#include <span>
#include <string_view>

#include "geometry/space/polyhedron.hpp"

namespace trilith {

/// Smallest convex solid around `points` [m], at least 4 that are not coplanar. Its corners are the points that stand
/// out by more than `flat` times the size, in the given order. Triangles whose corners are coplanar within this
/// tolerance are merged into one face. Use 1e-5 for coordinates rounded to 6 digits. Throws InputError for fewer than 4
/// points, coordinates that are not finite, coplanar points, and where check_convex does. `owner` begins every message.
///
/// Starts with a tetrahedron and adds the point farthest outside until none is left: the triangles visible from it are
/// replaced by triangles between it and their rim. Time grows as points times faces times points, so use it for up to
/// several hundred points.
Polyhedron convex_hull(std::span<const Vec3> points, std::string_view owner, double flat = kFlatFace);

}  // namespace trilith
