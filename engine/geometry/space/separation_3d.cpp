#include "geometry/space/separation_3d.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "base/simd/lane_bits.hpp"
#include "base/simd/lane_vectors.hpp"
#include "geometry/space/separation_parts.hpp"

namespace trilith {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity(), none_yet = -unlimited;

/// The lowest corner along a direction, the first of equal ones.
struct LowestCorner {
  double height = std::numeric_limits<double>::infinity();
  int corner = 0;
  LowestCorner(const std::vector<Vec3>& corners, const Vec3& up) {
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (const double h = up.dot(corners[i]); h < height) height = h, corner = static_cast<int>(i);
  }
};

const Vec3& corner_of_face(const PlacedSolid& solid, int face) {
  return solid.corners[static_cast<std::size_t>(solid.solid->shape.faces[face][0])];
}

/// Largest number of corners, faces and edges of a solid whose products are computed in lanes, in tables of fixed size.
constexpr std::size_t few_in_lanes = 8, few_lane_edges = 14;

bool are_few(const PlacedSolid& solid) {
  return solid.corners.size() <= few_in_lanes && solid.normals.size() <= few_in_lanes &&
         solid.solid->edges.size() <= few_lane_edges;
}

/// At most eight vectors in lanes; unused lanes repeat the last one. Products with them have the bits of Vec3::dot.
struct FewVectors {
  std::array<Triple<Lanes>, 2> four;

  TRILITH_INLINE explicit FewVectors(const std::vector<Vec3>& of) {
    const auto at = [&](std::size_t i) -> const Vec3& { return of[std::min(i, of.size() - 1)]; };
    for (std::size_t k = 0; k < 2; ++k) four[k] = four_of(at(4 * k), at(4 * k + 1), at(4 * k + 2), at(4 * k + 3));
  }
  TRILITH_INLINE void products(const Vec3& with, std::array<Lanes, 2>& out) const {
    const Triple<Lanes> v = four_of(with, with, with, with);
    out[0] = v.dot(four[0]), out[1] = v.dot(four[1]);
  }
};

/// best_solid_face() of solids with few corners and faces, with the same bits.
[[gnu::target_clones("avx2", "default")]] Separation3 best_face_of_few(const PlacedSolid& a, const PlacedSolid& b,
                                                                       double enough) {
  Separation3 best{none_yet, Vec3::Zero(), SeparatingFeature::face_of_a, 0, 0};
  const FewVectors corners(b.corners);
  std::array<Lanes, 2> height;
  for (std::size_t f = 0; f < a.normals.size(); ++f) {
    const Vec3& normal = a.normals[f];
    corners.products(normal, height);
    const Lanes both = smaller<Lanes>(height[0], height[1]);
    const double lowest = std::min(std::min(both[0], both[1]), std::min(both[2], both[3]));
    const double distance = lowest - normal.dot(corner_of_face(a, static_cast<int>(f)));
    if (distance > best.distance)
      best = {distance, normal, SeparatingFeature::face_of_a, static_cast<int>(f),
              std::countr_zero(lane_bits(height[0] == lowest, height[1] == lowest))};
    if (best.distance > enough) break;
  }
  return best;
}

/// Best face of `a` as seen from `b`, with the corner of `b` in Separation3::b.
Separation3 best_solid_face(const PlacedSolid& a, const PlacedSolid& b, double enough) {
  if (are_few(a) && are_few(b)) return best_face_of_few(a, b, enough);
  Separation3 best{none_yet, Vec3::Zero(), SeparatingFeature::face_of_a, 0, 0};
  for (std::size_t f = 0; f < a.normals.size(); ++f) {
    const Vec3& normal = a.normals[f];
    const LowestCorner lowest(b.corners, normal);
    const double distance = lowest.height - normal.dot(corner_of_face(a, static_cast<int>(f)));
    if (distance > best.distance)
      best = {distance, normal, SeparatingFeature::face_of_a, static_cast<int>(f), lowest.corner};
    if (best.distance > enough) break;
  }
  return best;
}

Separation3 seen_from_b(const Separation3& of_b) {
  return {of_b.distance, -of_b.axis, SeparatingFeature::face_of_b, of_b.b, of_b.a};
}

/// An edge in the world, with the normals of its faces.
struct PlacedEdge {
  const Vec3& from;
  Vec3 along;
  const Vec3 &left, &right;
  PlacedEdge(const PlacedSolid& solid, std::size_t i) : PlacedEdge(solid, solid.solid->edges[i]) {}

 private:
  PlacedEdge(const PlacedSolid& solid, const SolidEdge& e)
      : from(solid.corners[static_cast<std::size_t>(e.from)]),
        along(solid.corners[static_cast<std::size_t>(e.to)] - from),
        left(solid.normals[static_cast<std::size_t>(e.left)]),
        right(solid.normals[static_cast<std::size_t>(e.right)]) {}
};

/// Whether the arc between the faces of a's edge crosses the reversed arc of b's edge. The arc of an edge lies in the
/// plane normal to it, so the signs of products with the edge's direction give the sides.
bool arcs_cross(const PlacedEdge& a, const PlacedEdge& b) {
  const double left_b = a.along.dot(b.left), right_b = a.along.dot(b.right);
  if (left_b * right_b >= 0) return false;
  const double left_a = b.along.dot(a.left), right_a = b.along.dot(a.right);
  return left_a * right_a < 0 && left_b * right_a < 0;
}

/// Unit normal of both edges, pointing out of `a`; zero where they are parallel.
Vec3 between_edges(const PlacedEdge& a, const PlacedEdge& b) {
  const Vec3 normal = cross(a.along, b.along);
  const double square = normal.squaredNorm();
  if (square <= 1e-12 * a.along.squaredNorm() * b.along.squaredNorm()) return Vec3::Zero();
  const Vec3 outward = a.left + a.right;
  return normal * ((normal.dot(outward) < 0 ? -1 : 1) / std::sqrt(square));
}

/// Products of the directions of a solid's edges with the normals of another solid, for few of both. Each product
/// occurs in several pairs of edges.
struct EdgeProducts {
  std::array<std::array<Lanes, 2>, few_lane_edges> with;  ///< [edge][face]
  std::array<unsigned, few_lane_edges> below, above;      ///< bit f: the product with normal f is negative, positive

  TRILITH_INLINE EdgeProducts(const PlacedSolid& of, const PlacedSolid& other) {
    const FewVectors normals(other.normals);
    const Lanes none{};
    for (std::size_t i = 0; i < of.solid->edges.size(); ++i) {
      const SolidEdge& e = of.solid->edges[i];
      const Vec3& from = of.corners[static_cast<std::size_t>(e.from)];
      std::array<Lanes, 2>& p = with[i];
      normals.products(of.corners[static_cast<std::size_t>(e.to)] - from, p);
      below[i] = lane_bits(p[0] < none, p[1] < none), above[i] = lane_bits(p[0] > none, p[1] > none);
    }
  }
  [[nodiscard]] TRILITH_INLINE double at(std::size_t edge, int face) const {
    return with[edge][static_cast<std::size_t>(face) / lane_count][face % lane_count];
  }
};

/// best_edges() of solids with few faces and edges, with the same bits: the conditions of arcs_cross() from tables.
[[gnu::target_clones("avx2", "default")]] Separation3 best_of_few_edges(const PlacedSolid& a, const PlacedSolid& b,
                                                                        Separation3 best, double enough) {
  const EdgeProducts of_a(a, b), of_b(b, a);
  const std::vector<SolidEdge>&edges_a = a.solid->edges, &edges_b = b.solid->edges;
  std::array<unsigned, few_lane_edges> faces;  // of b's edges, as bits
  for (std::size_t k = 0; k < edges_b.size(); ++k) faces[k] = (1U << edges_b[k].left) | (1U << edges_b[k].right);
  for (std::size_t i = 0; i < edges_a.size(); ++i) {
    const unsigned below = of_a.below[i], above = of_a.above[i];
    for (std::size_t k = 0; k < edges_b.size(); ++k) {
      if ((below & faces[k]) == 0 || (above & faces[k]) == 0) continue;
      const double right_a = of_b.at(k, edges_a[i].right);
      if (!(of_b.at(k, edges_a[i].left) * right_a < 0 && of_a.at(i, edges_b[k].left) * right_a < 0)) continue;
      const PlacedEdge edge_a(a, i), edge_b(b, k);
      const Vec3 axis = between_edges(edge_a, edge_b);
      const double distance = axis.dot(edge_b.from - edge_a.from);
      if (distance <= best.distance || axis.isZero(0)) continue;
      best = {distance, axis, SeparatingFeature::edges, static_cast<int>(i), static_cast<int>(k)};
      if (distance > enough) return best;
    }
  }
  return best;
}

Separation3 best_edges(const PlacedSolid& a, const PlacedSolid& b, Separation3 best, double enough) {
  if (are_few(a) && are_few(b)) return best_of_few_edges(a, b, best, enough);
  for (std::size_t i = 0; i < a.solid->edges.size(); ++i) {
    const PlacedEdge of_a(a, i);
    for (std::size_t k = 0; k < b.solid->edges.size(); ++k) {
      const PlacedEdge of_b(b, k);
      if (!arcs_cross(of_a, of_b)) continue;
      const Vec3 axis = between_edges(of_a, of_b);
      const double distance = axis.dot(of_b.from - of_a.from);
      if (distance <= best.distance || axis.isZero(0)) continue;
      best = {distance, axis, SeparatingFeature::edges, static_cast<int>(i), static_cast<int>(k)};
      if (distance > enough) return best;
    }
  }
  return best;
}

/// The axis of these features in the current placement; zero where there is none.
Vec3 axis_of(const Separation3& last, const PlacedSolid& a, const PlacedSolid& b) {
  switch (last.feature) {
    case SeparatingFeature::face_of_a:
      return a.normals[static_cast<std::size_t>(last.a)];
    case SeparatingFeature::face_of_b:
      return -b.normals[static_cast<std::size_t>(last.b)];
    case SeparatingFeature::edges:
      break;
  }
  return between_edges(PlacedEdge(a, static_cast<std::size_t>(last.a)),
                       PlacedEdge(b, static_cast<std::size_t>(last.b)));
}

}  // namespace

// Separating axis theorem: the axis of largest distance, or least penetration, is a face normal of either solid or
// normal to an edge of each. Only pairs of edges that make a face of the Minkowski difference count; their arcs of
// normals cross (Gregorius, "The separating axis test between convex polyhedra", GDC 2013). `enough` ends the search
// early for callers that only ask whether the solids are apart.
Separation3 separation(const PlacedSolid& a, const PlacedSolid& b, double enough) {
  const Separation3 from_a = best_solid_face(a, b, enough);
  if (from_a.distance > enough) return from_a;
  const Separation3 from_b = seen_from_b(best_solid_face(b, a, enough));
  if (from_b.distance > enough) return from_b;
  return best_edges(a, b, from_a.distance >= from_b.distance ? from_a : from_b, enough);
}

Separation3 face_separation(const PlacedSolid& a, const PlacedSolid& b) {
  const Separation3 from_a = best_solid_face(a, b, unlimited), from_b = seen_from_b(best_solid_face(b, a, unlimited));
  return from_a.distance >= from_b.distance ? from_a : from_b;
}

Separation3 separation_beyond(const PlacedSolid& a, const PlacedSolid& b, const Separation3& faces) {
  return best_edges(a, b, faces, unlimited);
}

Separation3 separation_from(const Separation3& last, const PlacedSolid& a, const PlacedSolid& b, double enough) {
  const Vec3 axis = axis_of(last, a, b);
  const double top = -LowestCorner(a.corners, -axis).height;
  const double distance = LowestCorner(b.corners, axis).height - top;
  if (distance > enough) return {distance, axis, last.feature, last.a, last.b};
  return separation(a, b, enough);
}

}  // namespace trilith
