#include "contact/plane/edge_pressure.hpp"

#include <bit>
#include <cmath>

#include "contact/plane/edge_energy.hpp"
#include "contact/plane/nearest_parts.hpp"
#include "contact/space/pressed_triangles.hpp"
#include "contact/space/tetrahedron_parts.hpp"
#include "geometry/plane/edge_overlap.hpp"

namespace trilith {
namespace {

/// Lists the triangles of all faces of the shared solid.
[[gnu::target_clones("avx2", "default")]] bool list_triangles(const PlacedSolid& a, const PlacedSolid& b,
                                                              const EdgeOverlap& shared, TriangleLanes& triangles) {
  const TetrahedronParts tetrahedron(shared);
  const bool is_tetrahedron = tetrahedron.is_one();
  NearestParts parts;
  for (unsigned left = shared.faces; left != 0; left &= left - 1) {
    const auto l = static_cast<std::size_t>(std::countr_zero(left));
    const bool of_b = l >= few_faces;
    const Vec3& n = (of_b ? b : a).normals[l % few_faces];
    // The force on b is along -n on its own face, because n points from b into a, and along +n on a face of a.
    const Lanes face{n.x(), n.y(), n.z(), of_b ? -1.0 : 1.0};
    if (is_tetrahedron && tetrahedron.add_to(triangles, face, l)) continue;
    if (!parts.add_to(triangles, face, shared, l, shared.depth[of_b ? 0 : 1])) return false;
  }
  triangles.all();  // completes the last four in wide registers
  return true;
}

/// The faces of one solid that bound the depth somewhere in the shared solid, at most three: over all of it the depth
/// is the least of theirs. A face is not among them if another face is nearer to all corners.
struct BoundingFaces {
  int count = 0;  ///< 0: there are more than three
  std::array<std::size_t, 3> face;

  BoundingFaces(const EdgeOverlap& shared, std::size_t of, std::size_t faces) {
    std::array<bool, few_faces> left{};
    const auto nearer = [&](std::size_t g, std::size_t f) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(shared.points); ++i)
        if (shared.depth[of][i].below[g] > shared.depth[of][i].below[f]) return false;
      return true;
    };
    for (std::size_t f = 0; f < faces; ++f) {
      for (std::size_t g = 0; g < faces && !left[f]; ++g) left[f] = g != f && !left[g] && nearer(g, f);
      if (left[f]) continue;
      if (count == 3) {
        count = 0;
        return;
      }
      face[static_cast<std::size_t>(count++)] = f;
    }
  }
};

/// A point on the planes of all bounding faces, as an arm; false where there is none near the shared solid. Of several
/// such points it is the nearest to the mean of the corners.
bool point_on_faces(const PlacedSolid& solid, const EdgeOverlap& shared, std::size_t of, Vec3& arm) {
  constexpr double least_angle = 0.05;  // sine; beyond it the point may be far away and cost digits
  const BoundingFaces bounds(shared, of, solid.normals.size());
  if (bounds.count == 0) return false;
  std::array<Vec3, 3> n;
  Vec3 depth = Vec3::Zero();
  arm = Vec3::Zero();
  const double share = 1.0 / shared.points;
  for (std::size_t i = 0; i < static_cast<std::size_t>(shared.points); ++i) {
    arm += share * Vec3(shared.arm[i][0], shared.arm[i][1], shared.arm[i][2]);
    for (int k = 0; k < bounds.count; ++k)
      depth[k] += share * shared.depth[of][i].below[bounds.face[static_cast<std::size_t>(k)]];
  }
  for (std::size_t k = 0; k < static_cast<std::size_t>(bounds.count); ++k) n[k] = solid.normals[bounds.face[k]];
  // With fewer than three planes, the others pass through the mean.
  if (bounds.count == 1) {
    arm += depth[0] * n[0];
    return true;
  }
  if (bounds.count == 2) n[2] = cross(n[0], n[1]);
  const Vec3 yz = cross(n[1], n[2]), zx = cross(n[2], n[0]), xy = cross(n[0], n[1]);
  const double volume = n[0].dot(yz);
  if (!(std::abs(volume) > least_angle * least_angle)) return false;
  arm += (depth[0] * yz + depth[1] * zx + depth[2] * xy) / volume;
  return true;
}

/// Sum over the triangles of their distance from the point of their owner times the integral of the depth.
[[gnu::target_clones("avx2", "default")]] double sum_of_depths(std::span<const FourTriangles> triangles,
                                                               const Vec3& point_a, const Vec3& point_b) {
  const Triple<Lanes> of_a = four_of(point_a, point_a, point_a, point_a),
                      of_b = four_of(point_b, point_b, point_b, point_b);
  Lanes sum{};
  for (const FourTriangles& in : triangles) {
    const Lanes from = select(in.sign < 0.0, in.normal.dot(of_a), in.normal.dot(of_b));
    sum += (in.normal.dot(in.arm[0]) - from) * area_of(in) * (in.depth[0] + in.depth[1] + in.depth[2]);
  }
  return ((sum[0] + sum[1]) + (sum[2] + sum[3])) / 12;
}

}  // namespace

bool have_few_faces(const PlacedSolid& a, const PlacedSolid& b) {
  return has_few_faces(*a.solid) && has_few_faces(*b.solid) && a.solid->surface.empty() && b.solid->surface.empty();
}

bool edge_sums(const MovingSolid& a, const MovingSolid& b, double beta, std::vector<FourTriangles>& room, PairSums& out,
               OverlapTopology* known) {
  EdgeOverlap shared;
  TriangleLanes triangles(room);
  if (!edge_overlap(a.placed, b.placed, shared, known) || !list_triangles(a.placed, b.placed, shared, triangles))
    return false;
  const ClosingMotion motion{b.velocity_at(shared.origin) - a.velocity_at(shared.origin), b.spin - a.spin};
  out.origin = shared.origin, out.sums = pressed_triangles(triangles.all(), beta, motion);
  return true;
}

bool edge_pressure(const MovingSolid& a, const MovingSolid& b, double kn, double beta, std::vector<FourTriangles>& room,
                   SolidPressure& out) {
  PairSums of;
  if (!edge_sums(a, b, beta, room, of)) return false;
  out = pressure_of_sums(of.origin, 0.5 * kn, of.sums);
  return true;
}

bool edge_depths(const PlacedSolid& a, const PlacedSolid& b, std::vector<FourTriangles>& room, double& depths) {
  EdgeOverlap shared;
  TriangleLanes triangles(room);
  if (!edge_overlap(a, b, shared)) return false;
  Vec3 point_a, point_b;
  if (!point_on_faces(a, shared, 0, point_a) || !point_on_faces(b, shared, 1, point_b)) return false;
  if (!list_triangles(a, b, shared, triangles)) return false;
  depths = sum_of_depths(triangles.all(), point_a, point_b);
  return true;
}

}  // namespace trilith
