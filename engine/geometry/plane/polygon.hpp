// Simple plane polygons: measures, and the check of a user's list of points.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/space.hpp"

namespace trilith {

/// Outline of a simple polygon: corners in counter-clockwise order [m], not closed (the first point is not repeated).
/// Edge i runs from point i to point i + 1, the last one to point 0. Corners between collinear edges are allowed: they
/// split one straight side into several faces.
using Polygon = std::vector<Vec2>;

/// A corner is reflex only if it turns right by more than this [rad]. Smaller turns count as straight.
inline constexpr double kStraightAngle = 1e-9;

/// Points nearer to each other than this times the size of the polygon are one point.
inline constexpr double kSamePoint = 1e-12;

/// Signed area [m2]: positive for counter-clockwise points. Shoelace formula about the first point.
double signed_area(std::span<const Vec2> outline);

/// Area, centroid and second moment of one outline, each exact to rounding. Computed about the first point, so a
/// polygon far from the origin loses no digits.
struct PolygonMoments {
  double area;           ///< [m2], signed by the orientation
  Vec2 centroid;         ///< [m]; the first point where the area is zero
  double second_moment;  ///< polar: integral of r^2 dA about the centroid [m4], signed by the orientation
};

/// Moments of an outline of at least 1 point. Mass per area times `second_moment` is the moment of inertia of a plate.
PolygonMoments polygon_moments(std::span<const Vec2> outline);

/// Length of the closed outline [m].
double perimeter(std::span<const Vec2> outline);

/// Axis-aligned box [m].
struct Box2 {
  Vec2 low, high;
};

/// Smallest box around at least 1 point.
Box2 bounding_box(std::span<const Vec2> points);

/// Outline of an axis-aligned rectangle between two opposite corners (low is below and left of high), low first.
Polygon rectangle(const Vec2& low, const Vec2& high);

/// Diagonal of the bounding box [m]: the reference size of tolerances.
double polygon_size(std::span<const Vec2> points);

/// Least distance of two parallel lines that enclose a convex outline of at least 3 points [m].
double least_width(std::span<const Vec2> outline);

/// +1 for counter-clockwise points, -1 for clockwise ones, 0 where the area is zero.
int orientation(std::span<const Vec2> outline);

/// Sine of the turn at `corner` between `before` and `after`: positive to the left, 0 where two points coincide.
double turn_sine(const Vec2& before, const Vec2& corner, const Vec2& after);

/// True if a counter-clockwise outline winds once and no corner turns right by more than kStraightAngle.
bool is_convex(std::span<const Vec2> outline);

/// A common point of the segments ab and cd, or a point where their distance is below `tolerance` [m], if any.
std::optional<Vec2> meeting_point(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d, double tolerance);

/// Two edges that are not neighbours and meet: their indices (first < second) and a common point [m].
struct Crossing {
  int first, second;
  Vec2 point;
};

/// The first pair of edges, in order of indices, that cross or are nearer to each other than `tolerance` [m], if any.
/// Neighbouring edges are not compared (a spike is found by its angle). Quadratic in the number of points, with a
/// bounding box test first.
std::optional<Crossing> find_self_crossing(std::span<const Vec2> outline, double tolerance);

/// A checked polygon, and one line for each repair.
struct CheckedPolygon {
  Polygon outline;
  std::vector<std::string> notes;
};

/// Makes a simple counter-clockwise polygon from a user's points. Repaired, with a note: neighbouring points nearer
/// than kSamePoint times the size (including a repeated closing point), and clockwise order (point 1 stays first).
/// Collinear points are kept.
///
/// Throws InputError, which names point and coordinates, for: fewer than 3 points, a point that is not finite or beyond
/// 1e12 m, no area. Further for a spike (two edges at less than kStraightAngle) and for edges that cross or touch.
/// `owner` begins every message, e.g. "body 'pier 3'". Messages count points from 1, as in a script.
CheckedPolygon check_polygon(Polygon points, std::string_view owner);

}  // namespace trilith
