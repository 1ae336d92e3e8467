// The convex hull of a few points in space, as a solid of plane faces.
#pragma once

#include <span>
#include <string_view>

#include "geometry/space/polyhedron.hpp"

namespace trilith {

/// Smallest convex solid around `points` [m], at least 4 that do not lie in one plane. Corners are the points that
/// stand out by more than `flat` times the size, in the order given; triangles whose corners lie within that of one
/// plane become one face. For coordinates rounded to 6 digits take 1e-5. Refused with InputError: fewer than 4 points,
/// numbers that are not finite, points in a plane, and what check_convex refuses. `owner` begins every message.
///
/// Begins with a tetrahedron and takes in the point farthest outside until none is left: the triangles that see it give
/// way to those between it and their rim. Time grows as points times faces times points: for some hundreds of them.
Polyhedron convex_hull(std::span<const Vec3> points, std::string_view owner, double flat = kFlatFace);

}  // namespace trilith
