#include "element/section/section.hpp"

#include <algorithm>

#include "geometry/plane/polygon.hpp"

namespace trilith {

Section polygon_section(std::span<const Vec2> outline) {
  const PolygonMoments moments = polygon_moments(outline);
  const double sign = moments.area < 0 ? -1 : 1;
  Section s;
  s.area = sign * moments.area;
  // Triangles from the centroid: the second moment about it, and the distance of the outline on either side.
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 p = outline[i] - moments.centroid, q = outline[(i + 1) % outline.size()] - moments.centroid;
    s.second_moment += sign * cross(p, q) * (p.y() * p.y() + p.y() * q.y() + q.y() * q.y()) / 12;
    s.above = std::max(s.above, p.y()), s.below = std::max(s.below, -p.y());
  }
  // As for a rectangle.
  s.shear_area = s.area * 5 / 6;
  return s;
}

}  // namespace trilith
