// Simple polygons of the plane: measures, and the check that makes a user's list of points one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/space.hpp"

namespace trilith {

/// Outline of a simple polygon: corners in counter-clockwise order, m, not closed (the last point is not the first
/// again). Edge i runs from point i to point i + 1 (the last one back to point 0). Corners between collinear edges are
/// allowed: they part one straight side into several faces.
using Polygon = std::vector<Vec2>;

/// A corner turns the wrong way only if it turns by more than this, rad. Smaller turns count as straight.
inline constexpr double kStraightAngle = 1e-9;

/// Two points nearer than this times the size of the polygon are one point.
inline constexpr double kSamePoint = 1e-12;

/// Area with sign, m2: positive where the points run counter-clockwise. Shoelace formula about the first point.
double signed_area(std::span<const Vec2> outline);

/// Area, centroid and second moment of one outline, each exact to rounding (taken about the first point, so a polygon
/// far from the origin loses nothing).
struct PolygonMoments {
  double area;           ///< m2, with the sign of the orientation
  Vec2 centroid;         ///< m; the first point where the area is zero
  double second_moment;  ///< polar, integral of r^2 dA about the centroid, m4, with the sign of the orientation
};

/// Moments of an outline of at least 1 point. Mass per area times `second_moment` is the moment of inertia of a plate.
PolygonMoments polygon_moments(std::span<const Vec2> outline);

/// Length of the closed outline, m.
double perimeter(std::span<const Vec2> outline);

/// Axis-parallel box, m.
struct Box2 {
  Vec2 low, high;
};

/// Smallest box around at least 1 point.
Box2 bounding_box(std::span<const Vec2> points);

/// Outline of an axis-parallel rectangle between two opposite corners (low below and left of high), low first.
Polygon rectangle(const Vec2& low, const Vec2& high);

/// Diagonal of the bounding box, m: the size that tolerances refer to.
double polygon_size(std::span<const Vec2> points);

/// Least distance between two parallel lines that a convex outline of at least 3 points fits between, m.
double least_width(std::span<const Vec2> outline);

/// +1 where the points run counter-clockwise, -1 clockwise, 0 where the area is zero.
int orientation(std::span<const Vec2> outline);

/// Sine of the turn at `corner` on the way from `before` to `after`: positive to the left, 0 where two points coincide.
double turn_sine(const Vec2& before, const Vec2& corner, const Vec2& after);

/// True if a counter-clockwise outline goes round once and no corner turns right by more than kStraightAngle.
bool is_convex(std::span<const Vec2> outline);

/// A point that the segments ab and cd share, or at which they come nearer to each other than `tolerance` (m), if any.
std::optional<Vec2> meeting_point(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d, double tolerance);

/// Two edges that are no neighbours and meet: their indices (first < second) and a point they share, m.
struct Crossing {
  int first, second;
  Vec2 point;
};

/// The first pair of edges, in order of indices, that cross or come nearer to each other than `tolerance` (m), if any.
/// Neighbouring edges are not compared (a spike is found by its angle). Quadratic in the number of points, boxes first.
std::optional<Crossing> find_self_crossing(std::span<const Vec2> outline, double tolerance);

/// A polygon fit for use, and what was repaired, one line each.
struct CheckedPolygon {
  Polygon outline;
  std::vector<std::string> notes;
};

/// Makes a simple counter-clockwise polygon of a user's points. Repaired, with a note: neighbouring points nearer than
/// kSamePoint times the size (a repeated closing point among them), clockwise order (point 1 stays first). Collinear
/// points are kept. Refused with InputError that names point and coordinates: fewer than 3 points, a point that is not
/// finite or beyond 1e12 m, no area, a spike (two edges at less than kStraightAngle), edges that cross or touch.
/// `owner` begins every message, e.g. "body 'pier 3'". Points are counted from 1 in messages, as in a script.
CheckedPolygon check_polygon(Polygon points, std::string_view owner);

}  // namespace trilith
