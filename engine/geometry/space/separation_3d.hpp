// How far two convex solids are apart, or within each other: separating axes in space.
//
// Two convex solids are apart if a plane parts them, and one that does is parallel to a face of either or to an edge of
// each. Of all pairs of edges only those count that can touch: seen on the sphere of directions, where a face is the
// point of its normal and an edge the arc between its two faces, the arc of a's edge must cross that of b's turned
// round (Gregorius, "The separating axis test between convex polyhedra", Game Developers Conference 2013).
#pragma once

#include <cstdint>
#include <limits>

#include "geometry/space/convex_solid.hpp"

namespace trilith {

/// What lies on the best axis.
enum class SeparatingFeature : std::uint8_t { face_of_a, face_of_b, edges };

/// Distance of two convex solids along the best axis.
struct Separation3 {
  double distance;  ///< m. Negative: exact least distance of a translation that parts them. Positive: they are apart by
                    ///< at least this much (exact where a face or two edges are nearest, not two corners)
  Vec3 axis;        ///< of length 1, from `a` towards `b`
  SeparatingFeature feature;
  int a, b;  ///< face_of_a: face of `a` and corner of `b`; face_of_b: corner of `a` and face of `b`; edges: an edge of
             ///< each
};

/// Largest distance over the normals of a's faces, of b's faces and over pairs of edges, in this order; of equal ones
/// the first. As soon as an axis gives more than `enough` [m] it is returned and the rest not looked at. Edges within a
/// millionth of parallel count as parallel and are left out.
Separation3 separation(const PlacedSolid& a, const PlacedSolid& b,
                       double enough = std::numeric_limits<double>::infinity());

/// The same, but asks first along the axis of the features that were best last time: where that still gives more than
/// `enough` (at least 0) it is the answer, a lower bound of the distance.
Separation3 separation_from(const Separation3& last, const PlacedSolid& a, const PlacedSolid& b, double enough = 0);

}  // namespace trilith
