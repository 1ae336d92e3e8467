#include "readings/spread_force.hpp"

#include "geometry/plane/outline_moments.hpp"
#include "geometry/space/face_overlap_3d.hpp"

namespace trilith {

std::vector<Vec2> part_below(std::span<const Vec2> corners, double at, const Vec2& slope) {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 &p = corners[i], &q = corners[i + 1 < corners.size() ? i + 1 : 0];
    const double f = at + slope.dot(p), g = at + slope.dot(q);
    if (f <= 0) out.push_back(p);
    if ((f < 0 && g > 0) || (f > 0 && g < 0)) out.push_back(p + f / (f - g) * (q - p));
  }
  return out;
}

LinearOver linear_over(double area, double xx, double xy, double yy, double sum, const Vec2& moment) {
  const double determinant = xx * yy - xy * xy;
  return {sum / area, Vec2(yy * moment.x() - xy * moment.y(), xx * moment.y() - xy * moment.x()) / determinant};
}

/// The normal stress turns about x with its moment along y, and about y against its moment along x.
SpreadForce::SpreadForce(const Vec3& origin, const Vec3& x_axis, const Vec3& y_axis, std::span<const Vec2> polygon,
                         const Vec3& force, const Vec3& moment)
    : x(x_axis), y(y_axis), normal(cross(x_axis, y_axis)) {
  const OutlineMoments area(polygon);
  centre = origin + area.middle.x() * x + area.middle.y() * y;
  for (const Vec2& p : polygon) corners.emplace_back(p - area.middle);
  whole = {force, moment - cross(Vec3(centre - origin), force)};
  const LinearOver stress = linear_over(area.area, area.xx, area.xy, area.yy, normal.dot(force),
                                        Vec2(-y.dot(whole.moment), x.dot(whole.moment)));
  normal_stress = stress.at, slope = stress.slope;
  shear_stress = Vec2(x.dot(force), y.dot(force)) / area.area;
  twist = normal.dot(whole.moment) / (area.xx + area.yy);
}

SpreadPart SpreadForce::behind(const Vec3& on_plane, const Vec3& plane_normal) const {
  const std::vector<Vec2> part =
      part_below(corners, plane_normal.dot(centre - on_plane), Vec2(plane_normal.dot(x), plane_normal.dot(y)));
  if (part.size() < 3) return {};
  const FaceIntegrals of = integrals_over_all(part, 0, Vec2::Zero());
  const Vec2& first = of.area_moment;
  const double along = normal_stress * of.area + slope.dot(first);
  const Vec2 shear = shear_stress * of.area + twist * left_of(first);
  const Vec2 bent =
      normal_stress * first + Vec2(slope.x() * of.xx + slope.y() * of.xy, slope.x() * of.xy + slope.y() * of.yy);
  const double turning = cross(first, shear_stress) + twist * (of.xx + of.yy);
  return {along * normal + shear.x() * x + shear.y() * y, bent.y() * x - bent.x() * y + turning * normal};
}

SpreadForce SpreadForce::reversed() const {
  SpreadForce out = *this;
  out.normal_stress = -normal_stress, out.twist = -twist, out.slope = -slope, out.shear_stress = -shear_stress;
  out.whole = {-whole.force, -whole.moment};
  return out;
}

}  // namespace trilith
