#include "model/builder/crack_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/schema.hpp"
#include "geometry/plane/half_plane.hpp"

namespace trilith {
namespace {

/// Corners nearer than this share of the size of the body are one corner.
constexpr double same_corner = 1e-9;
/// A part of less than this share of the area is not a part: the plane touches the body in a corner.
constexpr double least_part_area = 1e-6;
/// Principal second moments closer than this share make a body as long as wide.
constexpr double same_length = 1e-6;

/// Second moments of area about the centroid.
struct SecondMoments {
  double xx = 0, yy = 0, xy = 0;
};

/// Sums over the triangles of the centroid with each edge.
SecondMoments second_moments(const Polygon& outline, const Vec2& centroid) {
  SecondMoments sum;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 p = outline[i] - centroid, q = outline[(i + 1) % outline.size()] - centroid;
    const double twice = cross(p, q);
    sum.xx += twice * (p.x() * p.x() + p.x() * q.x() + q.x() * q.x()) / 12;
    sum.yy += twice * (p.y() * p.y() + p.y() * q.y() + q.y() * q.y()) / 12;
    sum.xy += twice * (2 * p.x() * p.y() + p.x() * q.y() + q.x() * p.y() + 2 * q.x() * q.y()) / 24;
  }
  return sum;
}

/// Unit vector along the longer principal axis, towards positive x; along x for a body that is as long as wide.
Vec2 long_axis(const Polygon& outline) {
  const SecondMoments m = second_moments(outline, polygon_moments(outline).centroid);
  const double mean = 0.5 * (m.xx + m.yy), half = 0.5 * (m.xx - m.yy);
  const double radius = std::sqrt(half * half + m.xy * m.xy);
  if (radius < same_length * mean) return Vec2::UnitX();
  // Eigenvector of the larger eigenvalue, from the row that is farther from 0.
  const Vec2 first(m.xy, mean + radius - m.xx), second(mean + radius - m.yy, m.xy);
  Vec2 axis = (first.squaredNorm() > second.squaredNorm() ? first : second).normalized();
  if (std::abs(axis.x()) < 1e-12) axis = Vec2::UnitY();
  if (std::abs(axis.y()) < 1e-12) axis = Vec2::UnitX();
  return axis.x() < 0 || (axis.x() == 0 && axis.y() < 0) ? Vec2(-axis) : axis;
}

/// Smallest and largest coordinate of an outline along a unit vector.
std::array<double, 2> extent(const Polygon& outline, const Vec2& along) {
  std::array<double, 2> range{unbounded, -unbounded};
  for (const Vec2& p : outline)
    range[0] = std::min(range[0], along.dot(p)), range[1] = std::max(range[1], along.dot(p));
  return range;
}

}  // namespace

std::vector<CrackPlane<2>> crack_planes(const CrackSpec<2>& spec, const Polygon& outline) {
  if (spec.pattern == CrackPattern::planes) return spec.planes;
  const Vec2 along = long_axis(outline), across = left_of(along);
  const auto [low, high] = extent(outline, along);
  const auto [below, above] = extent(outline, across);
  std::vector<CrackPlane<2>> planes;
  if (spec.pattern == CrackPattern::diagonals) {
    const Vec2 middle = 0.5 * (low + high) * along + 0.5 * (below + above) * across;
    for (const double sign : {1.0, -1.0})
      planes.push_back({middle, (above - below) * along - sign * (high - low) * across});
    return planes;
  }
  for (int i = 1; i <= spec.count; ++i)
    planes.push_back({(low + (high - low) * i / (spec.count + 1)) * along + 0.5 * (below + above) * across, along});
  return planes;
}

std::optional<std::array<Polygon, 2>> parts_of(const Polygon& outline, const CrackPlane<2>& plane) {
  const double size = polygon_size(outline), offset = plane.normal.dot(plane.point);
  const std::vector<Polygon> behind = cut_by(outline, {plane.normal, offset}, same_corner * size);
  const std::vector<Polygon> ahead = cut_by(outline, {-plane.normal, -offset}, same_corner * size);
  if (behind.size() != 1 || ahead.size() != 1) return std::nullopt;
  const double least = least_part_area * signed_area(outline);
  if (!(signed_area(behind[0]) > least) || !(signed_area(ahead[0]) > least)) return std::nullopt;
  return std::array{behind[0], ahead[0]};
}

std::optional<std::array<Polygon, 2>> parted_outlines(const Polygon& outline, const Vec2& centroid,
                                                      const CrackSection<2>& section, const CrackOpening& opening) {
  std::array<Polygon, 2> parts;
  for (const int side : {0, 1}) {
    const double sign = side == 0 ? -0.5 : 0.5;
    const Vec2 from = centroid + section.from + sign * opening.from * section.normal;
    const Vec2 to = centroid + section.to + sign * opening.to * section.normal;
    const Vec2 normal = -2 * sign * -left_of(Vec2(to - from)).normalized();
    const std::vector<Polygon> part =
        cut_by(outline, {normal, normal.dot(0.5 * (from + to))}, same_corner * polygon_size(outline));
    if (part.size() != 1) return std::nullopt;
    parts[static_cast<std::size_t>(side)] = part[0];
  }
  return parts;
}

/// The section lies between the outermost corners of the part behind that are on the plane.
std::optional<CrackSection<2>> crack_section(const Polygon& outline, double mass, const CrackPlane<2>& plane,
                                             int number) {
  const auto parts = parts_of(outline, plane);
  if (!parts) return std::nullopt;
  CrackSection<2> section;
  section.number = number;
  section.normal = plane.normal.normalized();
  const Vec2 across = left_of(section.normal);
  const PolygonMoments whole = polygon_moments(outline), behind = polygon_moments((*parts)[0]);
  double low = unbounded, high = -unbounded;
  for (const Vec2& p : (*parts)[0]) {
    if (std::abs(section.normal.dot(p - plane.point)) > 1e-7 * polygon_size(outline)) continue;
    const double at = across.dot(p - plane.point);
    if (at < low) low = at, section.from = p - whole.centroid;
    if (at > high) high = at, section.to = p - whole.centroid;
  }
  section.mass = mass * behind.area / whole.area;
  section.inertia = section.mass * behind.second_moment / behind.area;
  section.centroid = behind.centroid - whole.centroid;
  return section;
}

std::string missed_plane_text(const Polygon& outline, const CrackPlane<2>& plane, int number) {
  const Box2 box = bounding_box(outline);
  return fmt::format(
      "cracks: plane {} through ({:g}, {:g}) with the normal ({:g}, {:g}) does not divide the body in two; the body is "
      "between ({:g}, {:g}) and ({:g}, {:g}). Give a point inside it, in the coordinates of the model",
      number, plane.point.x(), plane.point.y(), plane.normal.x(), plane.normal.y(), box.low.x(), box.low.y(),
      box.high.x(), box.high.y());
}

}  // namespace trilith
