#include "geometry/space/separation_3d.hpp"

#include <cmath>

namespace trilith {
namespace {

constexpr double none_yet = -std::numeric_limits<double>::infinity();

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

/// Best face of `a` as seen from `b`, with the corner of `b` in Separation3::b.
Separation3 best_solid_face(const PlacedSolid& a, const PlacedSolid& b, double enough) {
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

Separation3 best_edges(const PlacedSolid& a, const PlacedSolid& b, Separation3 best, double enough) {
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

Separation3 separation_from(const Separation3& last, const PlacedSolid& a, const PlacedSolid& b, double enough) {
  const Vec3 axis = axis_of(last, a, b);
  const double top = -LowestCorner(a.corners, -axis).height;
  const double distance = LowestCorner(b.corners, axis).height - top;
  if (distance > enough) return {distance, axis, last.feature, last.a, last.b};
  return separation(a, b, enough);
}

}  // namespace trilith
