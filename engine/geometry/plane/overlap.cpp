#include "geometry/plane/overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/plane/polygon.hpp"

namespace trilith {
namespace {

/// Keeps the part of `from` to the left of the line from `a` to `b`. For each corner: the crossing between it and its
/// predecessor, if any, and the corner itself where it is kept.
void clip_left(const std::vector<Vec2>& from, const Vec2& a, const Vec2& b, std::vector<Vec2>& into) {
  into.clear();
  if (from.empty()) return;
  const Vec2 along = b - a;
  Vec2 before = from.back();
  double side_before = cross(along, before - a);
  for (const Vec2& p : from) {
    const double side = cross(along, p - a);
    // a corner exactly on the line is kept and makes no additional crossing
    if ((side > 0 && side_before < 0) || (side < 0 && side_before > 0))
      into.push_back(before + (side_before / (side_before - side)) * (p - before));
    if (side >= 0) into.push_back(p);
    before = p;
    side_before = side;
  }
}

}  // namespace

/// Polygon a is clipped by the edges of b one after the other (Sutherland and Hodgman, "Reentrant polygon clipping",
/// Comm. ACM 17, 1974); the remainder is the intersection.
Overlap convex_overlap(std::span<const Vec2> a, std::span<const Vec2> b, OverlapBuffer& buffer) {
  buffer.corners.assign(a.begin(), a.end());
  for (std::size_t i = 0; i < b.size() && !buffer.corners.empty(); ++i) {
    clip_left(buffer.corners, b[i], b[i + 1 == b.size() ? 0 : i + 1], buffer.spare);
    buffer.corners.swap(buffer.spare);
  }
  // Touching polygons may leave a sliver without area, or with its orientation reversed by rounding: no overlap.
  if (buffer.corners.size() >= 3) {
    const PolygonMoments moments = polygon_moments(buffer.corners);
    if (moments.area > 0) return {moments.area, moments.centroid};
  }
  buffer.corners.clear();
  return {0, Vec2::Zero()};
}

namespace {

/// Best face of `a` as seen from `b`; the outward normal is the axis, no owner set. The separation along a face's
/// normal is the height of the other's lowest corner above it. The best face has the largest one; it is above 0 where
/// the polygons are apart.
Penetration best_face(std::span<const Vec2> a, std::span<const Vec2> b) {
  Penetration best{-std::numeric_limits<double>::infinity(), Vec2::Zero(), true, 0, 0};
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec2 along = (a[i + 1 == a.size() ? 0 : i + 1] - a[i]).normalized();
    const Vec2 outward(along.y(), -along.x());
    double least = std::numeric_limits<double>::infinity();
    std::size_t deepest = 0;
    for (std::size_t k = 0; k < b.size(); ++k) {
      const double height = outward.dot(b[k] - a[i]);
      if (height < least) {
        least = height;
        deepest = k;
      }
    }
    if (least > best.separation) best = {least, outward, true, static_cast<int>(i), static_cast<int>(deepest)};
  }
  return best;
}

}  // namespace

Penetration penetration(std::span<const Vec2> a, std::span<const Vec2> b) {
  const Penetration from_a = best_face(a, b);
  Penetration from_b = best_face(b, a);
  if (from_a.separation >= from_b.separation) return from_a;
  from_b.axis = -from_b.axis;
  from_b.face_of_a = false;
  return from_b;
}

/// Even-odd rule: a ray to the left from an inner point crosses the outline an odd number of times.
bool contains(std::span<const Vec2> outline, const Vec2& point) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], &b = outline[i + 1 == outline.size() ? 0 : i + 1];
    // half-open in y, so that a ray through a corner is counted once
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double side = cross(b - a, point - a);
    if ((b.y() > a.y()) ? side > 0 : side < 0) inside = !inside;
  }
  return inside;
}

BoundaryPoint boundary_point(std::span<const Vec2> outline, const Vec2& point) {
  BoundaryPoint best{std::numeric_limits<double>::infinity(), 0, Vec2::Zero()};
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], along = outline[i + 1 == outline.size() ? 0 : i + 1] - a;
    const double squared = along.squaredNorm();
    const double t = squared > 0 ? std::clamp(along.dot(point - a) / squared, 0.0, 1.0) : 0;
    const Vec2 at = a + t * along;
    const double distance = (point - at).norm();
    if (distance < best.distance) best = {distance, static_cast<int>(i), at};
  }
  return best;
}

}  // namespace trilith
