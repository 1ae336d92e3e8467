// Distance or penetration depth of two convex solids by the separating axis test.
//
// Two convex solids are apart if a plane separates them. Such a plane is parallel to a face of one of them, or to an
// edge of each. Only pairs of edges that can touch are tested. On the sphere of directions a face is the point of its
// normal and an edge is the arc between its two faces. The arc of a's edge must cross the reversed arc of b's edge
// (Gregorius, "The separating axis test between convex polyhedra", Game Developers Conference 2013).
#pragma once

#include <cstdint>
#include <limits>

#include "geometry/space/convex_solid.hpp"

namespace trilith {

/// The features that define the best axis.
enum class SeparatingFeature : std::uint8_t { face_of_a, face_of_b, edges };

/// Distance of two convex solids along the best axis.
struct Separation3 {
  /// [m]. Negative: exact least translation that separates them. Positive: lower bound of the distance (exact where a
  /// face or two edges are nearest, not two corners).
  double distance = 0;
  Vec3 axis = Vec3::UnitX();  ///< unit vector from `a` towards `b`
  SeparatingFeature feature = SeparatingFeature::face_of_a;
  /// face_of_a: face of `a` and corner of `b`; face_of_b: corner of `a` and face of `b`; edges: an edge of each.
  int a = 0, b = 0;
};

/// Largest distance over the normals of a's faces, of b's faces and over pairs of edges, in this order; of equal ones
/// the first. The first axis with more than `enough` [m] is returned without testing the others. Edges within a
/// millionth of parallel count as parallel and are skipped.
Separation3 separation(const PlacedSolid& a, const PlacedSolid& b,
                       double enough = std::numeric_limits<double>::infinity());

/// Like separation(), but first tests the axis of the previous best features. If its distance still exceeds `enough`
/// (at least 0), this lower bound is returned.
Separation3 separation_from(const Separation3& last, const PlacedSolid& a, const PlacedSolid& b, double enough = 0);

}  // namespace trilith
