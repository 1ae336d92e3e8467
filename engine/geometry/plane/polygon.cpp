#include "geometry/plane/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/portable.hpp"

namespace trilith {

/// Fan of triangles from the first point. The origin may be far away, so rounding errors about it would be larger.
double signed_area(std::span<const Vec2> outline) {
  double twice = 0;
  for (std::size_t i = 2; i < outline.size(); ++i) twice += cross(outline[i - 1] - outline[0], outline[i] - outline[0]);
  return twice / 2;
}

/// Triangles (0, a, b) from the first point, where c is twice the area of one:
///   area = sum c / 2,   first moment = sum c (a + b) / 6,   polar = sum c (a.a + a.b + b.b) / 12.
/// The polar moment is then moved to the centroid.
PolygonMoments polygon_moments(std::span<const Vec2> outline) {
  const Vec2 origin = outline[0];
  double twice = 0, polar = 0;
  Vec2 first = Vec2::Zero();
  for (std::size_t i = 2; i < outline.size(); ++i) {
    const Vec2 a = outline[i - 1] - origin, b = outline[i] - origin;
    const double c = cross(a, b);
    twice += c;
    first += c * (a + b);
    polar += c * (a.dot(a) + a.dot(b) + b.dot(b));
  }
  if (twice == 0) return {0, origin, 0};
  const double area = twice / 2;
  const Vec2 arm = first / (3 * twice);
  return {area, origin + arm, polar / 12 - area * arm.squaredNorm()};
}

double perimeter(std::span<const Vec2> outline) {
  double length = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) length += (outline[(i + 1) % outline.size()] - outline[i]).norm();
  return length;
}

Box2 bounding_box(std::span<const Vec2> points) {
  Box2 box{points[0], points[0]};
  for (const Vec2& p : points) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

Polygon rectangle(const Vec2& low, const Vec2& high) {
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

double polygon_size(std::span<const Vec2> points) {
  const Box2 box = bounding_box(points);
  return (box.high - box.low).norm();
}

/// The least width of a convex outline is across one of its edges: the height of its farthest corner above the edge.
double least_width(std::span<const Vec2> outline) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 along = outline[(i + 1) % outline.size()] - outline[i];
    const double length = along.norm();
    double farthest = 0;
    for (const Vec2& p : outline) farthest = std::max(farthest, cross(along, p - outline[i]));
    if (length > 0) least = std::min(least, farthest / length);
  }
  return least;
}

int orientation(std::span<const Vec2> outline) {
  const double area = signed_area(outline);
  return area > 0 ? 1 : area < 0 ? -1 : 0;
}

/// Above 0 for a left turn, 0 where an edge has no length.
double turn_sine(const Vec2& before, const Vec2& corner, const Vec2& after) {
  const Vec2 in = corner - before, out = after - corner;
  const double lengths = in.norm() * out.norm();
  return lengths > 0 ? cross(in, out) / lengths : 0;
}

/// No right turn, and a total turn of 2 pi up to rounding.
bool is_convex(std::span<const Vec2> outline) {
  const std::size_t n = outline.size();
  if (n < 3) return false;
  double total_turn = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = outline[i] - outline[(i + n - 1) % n], out = outline[(i + 1) % n] - outline[i];
    const double turn = portable::atan2(cross(in, out), in.dot(out));
    if (turn < -kStraightAngle) return false;
    total_turn += turn;
  }
  return std::abs(total_turn - 2 * std::numbers::pi) < 1;  // a star that winds twice also turns left at each corner
}

namespace {

/// Whether the distance of the point from the segment ab is within the tolerance.
bool within(const Vec2& p, const Vec2& a, const Vec2& b, double tolerance) {
  const Vec2 along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0 ? std::clamp(along.dot(p - a) / squared, 0.0, 1.0) : 0;
  return (p - (a + t * along)).norm() <= tolerance;
}

bool boxes_apart(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d, double tolerance) {
  return ((a.cwiseMax(b).array() + tolerance < c.cwiseMin(d).array()).any()) ||
         ((c.cwiseMax(d).array() + tolerance < a.cwiseMin(b).array()).any());
}

}  // namespace

/// They cross if each segment separates the ends of the other. Otherwise they may meet at an end, within the tolerance.
std::optional<Vec2> meeting_point(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d, double tolerance) {
  if (boxes_apart(a, b, c, d, tolerance)) return std::nullopt;
  // Sides of each line on which the ends of the other segment lie.
  const double side_c = cross(b - a, c - a), side_d = cross(b - a, d - a);
  const double side_a = cross(d - c, a - c), side_b = cross(d - c, b - c);
  const bool parts_cd = (side_c < 0) != (side_d < 0), parts_ab = (side_a < 0) != (side_b < 0);
  if (parts_cd && parts_ab && side_c != side_d) return Vec2(c + (side_c / (side_c - side_d)) * (d - c));
  for (const Vec2& end : {a, b})
    if (within(end, c, d, tolerance)) return end;
  for (const Vec2& end : {c, d})
    if (within(end, a, b, tolerance)) return end;
  return std::nullopt;
}

/// Tests each pair of edges that are not neighbours: outlines have tens of edges, not thousands.
std::optional<Crossing> find_self_crossing(std::span<const Vec2> outline, double tolerance) {
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i + 2 < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      // Neighbours across the end of the list.
      if (i == 0 && j + 1 == n) continue;
      const auto point = meeting_point(outline[i], outline[i + 1], outline[j], outline[(j + 1) % n], tolerance);
      if (point) return Crossing{static_cast<int>(i), static_cast<int>(j), *point};
    }
  return std::nullopt;
}

}  // namespace trilith
