#include "model/space_builder/crack_sections_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/rotation_3d.hpp"
#include "geometry/plane/outline_moments.hpp"
#include "geometry/space/cut_solid.hpp"
#include "model/space_builder/space_solid.hpp"

namespace trilith {
namespace {

/// Corners nearer to a plane than this share of the size of the body are on it.
constexpr double on_plane = 1e-9;
/// A part of less than this share of the volume is not a part: the plane touches the body.
constexpr double least_part_volume = 1e-6;
/// Principal moments of inertia closer than this share make two axes equally long.
constexpr double same_moment = 1e-6;

/// Unit vector along the longest principal axis; the first of equally long ones. Its largest component is positive.
Vec3 longest_axis(const Eigen::Matrix3d& about_centroid) {
  const PrincipalInertia inertia = principal_inertia(about_centroid);
  int longest = 0;
  for (const int k : {1, 2})
    if (inertia.moments[k] < inertia.moments[longest] * (1 - same_moment)) longest = k;
  const Turn3 axes(inertia.axes);
  const Vec3 axis = longest == 0 ? axes.x() : longest == 1 ? axes.y() : axes.z();
  Eigen::Index most = 0;
  axis.cwiseAbs().maxCoeff(&most);
  return axis[most] < 0 ? Vec3(-axis) : axis;
}

/// A unit vector across another one.
Vec3 some_across(const Vec3& n) {
  Eigen::Index least = 0;
  n.cwiseAbs().minCoeff(&least);
  return cross(n, Vec3(Vec3::Unit(least))).normalized();
}

/// Direction of the longest side of a polygon; the first of equally long ones.
Vec2 along_longest_side(const std::vector<Vec2>& corners) {
  Vec2 best = Vec2::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 side = corners[i + 1 < corners.size() ? i + 1 : 0] - corners[i];
    if (side.norm() > best.norm() * (1 + same_moment)) best = side;
  }
  return best.normalized();
}

}  // namespace

void set_section_polygon(const std::vector<Vec3>& corners, CrackSection<3>& section) {
  const Vec3 x = some_across(section.normal), y = cross(section.normal, x);
  std::vector<Vec2> flat;
  for (const Vec3& p : corners) flat.emplace_back(x.dot(p - corners[0]), y.dot(p - corners[0]));
  const OutlineMoments first(flat);
  const Vec2 along = first.has_axis() ? first.axis() : along_longest_side(flat), across = left_of(along);
  section.centre = corners[0] + first.middle.x() * x + first.middle.y() * y;
  section.x = along.x() * x + along.y() * y, section.y = across.x() * x + across.y() * y;
  for (const Vec2& p : flat) section.corners.emplace_back(along.dot(p - first.middle), across.dot(p - first.middle));
  const OutlineMoments own(section.corners);
  section.area = own.area, section.xx = own.xx, section.xy = own.xy, section.yy = own.yy;
}

namespace {

/// Planes across the longest axis of a body with these points, that divide its extent into equal parts.
std::vector<CrackPlane<3>> equal_planes(int count, const Eigen::Matrix3d& inertia, const Vec3& centre,
                                        std::span<const Vec3> points) {
  const Vec3 along = longest_axis(inertia);
  double low = std::numeric_limits<double>::max(), high = -low;
  for (const Vec3& p : points) low = std::min(low, along.dot(p - centre)), high = std::max(high, along.dot(p - centre));
  std::vector<CrackPlane<3>> planes;
  for (int i = 1; i <= count; ++i) planes.push_back({centre + (low + (high - low) * i / (count + 1)) * along, along});
  return planes;
}

}  // namespace

std::vector<CrackPlane<3>> crack_planes(const CrackSpec<3>& spec, const Polyhedron& solid) {
  if (spec.pattern == CrackPattern::planes) return spec.planes;
  const SolidMoments moments = solid_moments(solid);
  return equal_planes(spec.count, moments.inertia, moments.centroid, solid.corners);
}

std::vector<CrackPlane<3>> crack_planes(const CrackSpec<3>& spec, const SpaceMesh& mesh) {
  if (spec.pattern == CrackPattern::planes) return spec.planes;
  const Vec3 centre = centre_of(mesh);
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (std::size_t e = 0; e < mesh.cell.size(); ++e) {
    const std::vector<Vec3> nodes = nodes_of(mesh, e);
    const ElementVolume shares = node_shares(mesh.cell[e].shape, nodes);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Vec3 arm = nodes[i] - centre;
      inertia +=
          shares.share[i] * shares.volume * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
    }
  }
  return equal_planes(spec.count, inertia, centre, mesh.node);
}

std::optional<std::array<Polyhedron, 2>> parts_of(const Polyhedron& solid, const CrackPlane<3>& plane) {
  const Vec3 normal = plane.normal.normalized();
  const double offset = normal.dot(plane.point), same = on_plane * solid_size(solid.corners);
  auto behind = cut_solid(solid, {normal, offset}, same), ahead = cut_solid(solid, {-normal, -offset}, same);
  if (!behind || !ahead) return std::nullopt;
  const double least = least_part_volume * solid_moments(solid).volume;
  if (!(solid_moments(*behind).volume > least) || !(solid_moments(*ahead).volume > least)) return std::nullopt;
  return std::array{std::move(*behind), std::move(*ahead)};
}

std::optional<CrackSection<3>> crack_section(const Polyhedron& solid, double mass, const UnitQuaternion& axes,
                                             const CrackPlane<3>& plane, int number) {
  const auto parts = parts_of(solid, plane);
  if (!parts) return std::nullopt;
  const Polyhedron& part = (*parts)[0];
  const SolidMoments whole = solid_moments(solid), behind = solid_moments(part);
  const Turn3 turn(axes);
  CrackSection<3> section;
  section.number = number;
  section.normal = turn.undo(plane.normal.normalized());
  std::vector<Vec3> corners;
  for (const int c : part.faces[part.faces.count() - 1])
    corners.push_back(turn.undo(Vec3(part.corners[static_cast<std::size_t>(c)] - whole.centroid)));
  set_section_polygon(corners, section);
  section.mass = mass * behind.volume / whole.volume;
  Eigen::Matrix3d to_world;
  to_world.col(0) = turn.x(), to_world.col(1) = turn.y(), to_world.col(2) = turn.z();
  section.inertia = mass / whole.volume * (to_world.transpose() * behind.inertia * to_world);
  section.centroid = turn.undo(Vec3(behind.centroid - whole.centroid));
  return section;
}

std::string missed_plane_text(const Polyhedron& solid, const CrackPlane<3>& plane, int number) {
  Vec3 low = solid.corners[0], high = low;
  for (const Vec3& p : solid.corners) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const auto text = [](const Vec3& v) { return fmt::format("({:g}, {:g}, {:g})", v.x(), v.y(), v.z()); };
  return fmt::format(
      "cracks: plane {} through {} with the normal {} does not divide the body in two; the body is between {} and {}. "
      "Give a point inside it, in the coordinates of the model",
      number, text(plane.point), text(plane.normal), text(low), text(high));
}

}  // namespace trilith
