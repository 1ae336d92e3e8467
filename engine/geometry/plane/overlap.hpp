// How two convex polygons lie to each other: the area they share and how far they are apart or within each other;
// and where a point lies to an outline.
#pragma once

#include <span>
#include <vector>

#include "base/space.hpp"

namespace trilith {

/// Room for the corners of an overlap, kept by the caller so that repeated calls allocate nothing.
struct OverlapBuffer {
  std::vector<Vec2> corners;  ///< the overlap, counter-clockwise, m; empty where there is none
  std::vector<Vec2> spare;    ///< scratch
};

/// Area shared by two convex polygons.
struct Overlap {
  double area;    ///< m2, never below 0; exactly 0 for faces that only touch along axis-parallel or identical lines
  Vec2 centroid;  ///< of the shared area, m; zero where there is none
};

/// Clips convex `a` by the edges of convex `b` (both counter-clockwise, at least 3 points, collinear corners allowed;
/// Sutherland and Hodgman 1974). The corners stay in `buffer.corners`: at most as many as `a` and `b` have together.
Overlap convex_overlap(std::span<const Vec2> a, std::span<const Vec2> b, OverlapBuffer& buffer);

/// How far two convex polygons are apart along the best of their face normals.
struct Penetration {
  double separation;  ///< m. Negative: exact least distance of a translation that parts them. Positive: they are apart
                      ///< by at least this much (exact where a corner faces an edge)
  Vec2 axis;          ///< unit vector from `a` towards `b` along which it is measured
  bool face_of_a;     ///< the face belongs to `a`, else to `b`
  int face;           ///< index of the face's edge in that polygon
  int corner;         ///< corner of the other polygon that lies deepest (or nearest): the first of equals
};

/// Largest separation over all face normals of both convex polygons (separating axes; both counter-clockwise). Of equal
/// ones the first is taken, those of `a` before those of `b`.
Penetration penetration(std::span<const Vec2> a, std::span<const Vec2> b);

/// True if `point` lies inside a simple outline of either order (even-odd rule). A point on the boundary may count
/// as either; ask boundary_point for its distance.
bool contains(std::span<const Vec2> outline, const Vec2& point);

/// Nearest point of an outline's boundary.
struct BoundaryPoint {
  double distance;  ///< from the asked point, m, never below 0
  int edge;         ///< index of the nearest edge, the first of equals
  Vec2 at;          ///< the nearest point itself, m
};

/// Nearest boundary point of an outline of at least 2 points to `point`.
BoundaryPoint boundary_point(std::span<const Vec2> outline, const Vec2& point);

}  // namespace trilith
