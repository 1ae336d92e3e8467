// Relative position of two convex polygons: shared area, and distance or penetration depth. Also the position of a
// point relative to an outline.
#pragma once

#include <span>
#include <vector>

#include "base/space.hpp"

namespace trilith {

/// Scratch buffer for the corners of an overlap, kept by the caller so that repeated calls allocate nothing.
struct OverlapBuffer {
  std::vector<Vec2> corners;  ///< the overlap, counter-clockwise [m]; empty if there is none
  std::vector<Vec2> spare;    ///< scratch
};

/// Intersection of two convex polygons.
struct Overlap {
  double area;    ///< [m2], never below 0; exactly 0 for faces that only touch along axis-parallel or identical lines
  Vec2 centroid;  ///< of the shared area [m]; zero if there is none
};

/// Clips convex `a` by the edges of convex `b` (Sutherland and Hodgman 1974). Both are counter-clockwise with at least
/// 3 points; collinear corners are allowed. The corners stay in `buffer.corners`: at most as many as `a` and `b` have
/// together.
Overlap convex_overlap(std::span<const Vec2> a, std::span<const Vec2> b, OverlapBuffer& buffer);

/// Distance of two convex polygons along the best of their face normals.
struct Penetration {
  double separation;  ///< [m]. Negative: exact least translation that separates them. Positive: lower bound of the
                      ///< distance (exact where a corner faces an edge)
  Vec2 axis;          ///< unit vector from `a` towards `b` along which it is measured
  bool face_of_a;     ///< the face belongs to `a`, else to `b`
  int face;           ///< index of the face's edge in that polygon
  int corner;         ///< deepest (or nearest) corner of the other polygon, the first of equal ones
};

/// Largest separation over all face normals of both convex polygons (separating axis test; both counter-clockwise). Of
/// equal ones the first is returned, normals of `a` before normals of `b`.
Penetration penetration(std::span<const Vec2> a, std::span<const Vec2> b);

/// True if `point` lies inside a simple outline of either orientation (even-odd rule). For a point on the boundary the
/// result is arbitrary; boundary_point returns its distance.
bool contains(std::span<const Vec2> outline, const Vec2& point);

/// Nearest point of an outline's boundary.
struct BoundaryPoint {
  double distance;  ///< from the given point [m], never below 0
  int edge;         ///< index of the nearest edge, the first of equal ones
  Vec2 at;          ///< the nearest point [m]
};

/// Nearest boundary point of an outline of at least 2 points to `point`.
BoundaryPoint boundary_point(std::span<const Vec2> outline, const Vec2& point);

}  // namespace trilith
