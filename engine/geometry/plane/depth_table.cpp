#include "geometry/plane/depth_table.hpp"

namespace trilith {
namespace {

/// Normals and one point of all planes that bound the body, component by component.
void list_planes(const PlacedSolid& solid, const Vec3& origin, DepthRoom& room) {
  const FaceLoops& faces = solid.solid->shape.faces;
  room.face.clear();
  for (int f = 0; f < faces.count(); ++f)
    if (solid.solid->is_surface(f)) room.face.push_back(f);
  const std::size_t n = room.face.size() + solid.beside.size();
  room.plane.resize(6 * n);
  double* to = room.plane.data();
  const auto add = [&](const Vec3& normal, const Vec3& point) {
    to[0] = normal.x(), to[n] = normal.y(), to[2 * n] = normal.z();
    to[3 * n] = point.x(), to[4 * n] = point.y(), to[5 * n] = point.z();
    ++to;
  };
  for (const int f : room.face)
    add(solid.normals[static_cast<std::size_t>(f)], solid.corners[static_cast<std::size_t>(faces[f][0])] - origin);
  for (const BoundingPlane& plane : solid.beside) add(plane.normal, plane.point - origin);
}

// Depths n . (p - x) of many points x below all planes of a solid, one row for each point. Planes are stored component
// by component (all n_x, then all n_y, ...), so that the first loop vectorises. The minimum, the first of equal ones,
// is found afterwards without branches.
/// Fills one row; returns the column of the least depth.
int fill_row(const Vec3& at, std::size_t n, const double* __restrict plane, double* __restrict depth) {
  const double x = at.x(), y = at.y(), z = at.z();
  const double *nx = plane, *ny = nx + n, *nz = ny + n, *px = nz + n, *py = px + n, *pz = py + n;
  for (std::size_t k = 0; k < n; ++k) depth[k] = nx[k] * (px[k] - x) + ny[k] * (py[k] - y) + nz[k] * (pz[k] - z);
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < n; ++k) {
    const bool nearer = depth[k] < least;
    least = nearer ? depth[k] : least, nearest = nearer ? static_cast<int>(k) : nearest;
  }
  return nearest;
}

}  // namespace

DepthTable::DepthTable(const PlacedSolid& solid, const Vec3& origin, std::span<const Vec3> arms, DepthRoom& room)
    : solid_(solid) {
  list_planes(solid, origin, room);
  const std::size_t n = room.plane.size() / 6;
  room.depth.resize(n * arms.size()), room.nearest.resize(arms.size());
  for (std::size_t i = 0; i < arms.size(); ++i)
    room.nearest[i] = fill_row(arms[i], n, room.plane.data(), room.depth.data() + i * n);
  columns_ = static_cast<int>(n);
  plane_ = room.plane.data(), depth_ = room.depth.data(), nearest_ = room.nearest.data(), face_ = room.face.data();
}

}  // namespace trilith
