#include "geometry/space/convex_solid.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace trilith {

namespace {

/// Whether two normals agree within a hundred times the tolerance of has_first_like.
bool some_alike(const std::vector<Vec3>& normals) {
  for (std::size_t f = 0; f < normals.size(); ++f)
    for (std::size_t g = 0; g < f; ++g)
      if ((normals[f] - normals[g]).squaredNorm() < 1e-20) return true;
  return false;
}

/// See ConvexSolid::inner_radius.
double inner_radius_of(const Polyhedron& shape, const std::vector<Vec3>& normals) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& x : shape.corners) sum += x;
  const Vec3 middle = sum / static_cast<double>(shape.corners.size());
  double least = std::numeric_limits<double>::infinity();
  for (int f = 0; f < shape.faces.count(); ++f) {
    const Vec3& on_face = shape.corners[static_cast<std::size_t>(shape.faces[f][0])];
    least = std::min(least, normals[static_cast<std::size_t>(f)].dot(on_face - middle));
  }
  return std::max(least, 0.0);
}

}  // namespace

/// Data of a shape that contact needs repeatedly: normals, edges, size, and whether any two faces are coplanar.
ConvexSolid convex_solid(const Polyhedron& shape, std::string_view owner, double flat) {
  check_convex(shape, owner, flat);
  std::vector<Vec3> normals = face_normals(shape);
  const bool may_repeat = some_alike(normals);
  const double inner = inner_radius_of(shape, normals);
  return {shape, std::move(normals), solid_edges(shape.faces), {}, {}, solid_size(shape.corners), may_repeat, inner};
}

ConvexSolid convex_sphere(const Sphere& sphere) {
  ConvexSolid solid;
  solid.shape.corners = {sphere.centre};
  solid.size = 2 * sphere.radius, solid.radius = sphere.radius;
  return solid;
}

void place(const ConvexSolid& solid, const Turn3& turn, const Vec3& at, PlacedSolid& out) {
  out.corners.clear();
  for (const Vec3& p : solid.shape.corners) out.corners.push_back(turn.apply(p) + at);
  place_faces(solid, turn, out);
}

void place_faces(const ConvexSolid& solid, const Turn3& turn, PlacedSolid& out) {
  out.solid = &solid;
  out.normals.resize(solid.normals.size());
  for (std::size_t f = 0; f < solid.normals.size(); ++f) out.normals[f] = turn.apply(solid.normals[f]);
}

/// Two faces of a convex solid with the same normal are coplanar.
bool has_first_like(const PlacedSolid& solid, int face) {
  if (!solid.solid->may_repeat) return false;
  const Vec3& n = solid.normals[static_cast<std::size_t>(face)];
  for (int f = 0; f < face; ++f)
    if (solid.solid->is_surface(f) && (solid.normals[static_cast<std::size_t>(f)] - n).squaredNorm() < 1e-24)
      return true;
  return false;
}

}  // namespace trilith
