#include "contact/plane/edge_pressure.hpp"

#include "contact/plane/nearest_parts.hpp"
#include "contact/space/pressed_triangles.hpp"
#include "contact/space/tetrahedron_parts.hpp"
#include "geometry/plane/edge_overlap.hpp"

namespace trilith {
namespace {

/// Lists the triangles of all faces of the shared solid.
[[gnu::target_clones("avx2", "default")]] bool list_triangles(const MovingSolid& a, const MovingSolid& b,
                                                              const EdgeOverlap& shared, TriangleLanes& triangles) {
  const TetrahedronParts tetrahedron(shared);
  const bool is_tetrahedron = tetrahedron.is_one();
  NearestParts parts;
  for (std::size_t l = 0; l < shared.loop.size(); ++l) {
    if (shared.loop[l].count == 0) continue;
    const bool of_b = l >= few_faces;
    const Vec3& n = (of_b ? b : a).placed.normals[l % few_faces];
    // The force on b is along -n on its own face, because n points from b into a, and along +n on a face of a.
    const Lanes face{n.x(), n.y(), n.z(), of_b ? -1.0 : 1.0};
    if (is_tetrahedron && tetrahedron.add_to(triangles, face, l)) continue;
    if (!parts.find(shared, l, shared.depth[of_b ? 0 : 1])) return false;
    parts.add_to(triangles, face);
  }
  return true;
}

}  // namespace

bool have_few_faces(const PlacedSolid& a, const PlacedSolid& b) {
  return has_few_faces(*a.solid) && has_few_faces(*b.solid) && a.solid->surface.empty() && b.solid->surface.empty();
}

bool edge_pressure(const MovingSolid& a, const MovingSolid& b, double kn, double beta, std::vector<FourTriangles>& room,
                   SolidPressure& out) {
  EdgeOverlap shared;
  TriangleLanes triangles(room);
  if (!edge_overlap(a.placed, b.placed, shared) || !list_triangles(a, b, shared, triangles)) return false;
  const ClosingMotion motion{b.velocity_at(shared.origin) - a.velocity_at(shared.origin), b.spin - a.spin};
  out = pressure_of_sums(shared.origin, 0.5 * kn, pressed_triangles(triangles.all(), beta, motion));
  return true;
}

}  // namespace trilith
