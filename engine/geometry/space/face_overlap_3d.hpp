// Two facing plane faces: the shared polygon and exact integrals of their overlap over it.
//
// n points from a to b: the mean of a's outward normal and the reversed normal of b. The mean plane is normal to n and
// midway between both faces everywhere. Over it the overlap c is linear, negative where the faces are apart:
//
//        b ______________________                    c(p) = overlap + slope . p,  p = (x, y) in the mean plane
//                 ` - . _         ` - .
//     ^ n   - - - - - - -`- . - - - - - -            mean plane
//     |                 _ . - `              c > 0 to the right of the crossing
//        a _____________________________
//
// The shared polygon is the intersection of both faces' projections along n. Nothing here allocates.
//
// A law with stress Kn c over the part where c > 0 gives the force Kn `first` along n, acting at `first_moment` /
// `first`, and the energy Kn `energy`. Times Kn, `area`, `area_moment` and `area_second` are its stiffness against
// translation along n and rotation about axes in the plane.
#pragma once

#include <array>
#include <span>

#include "base/space.hpp"

namespace trilith {

/// Largest number of corners of one face.
inline constexpr int max_face_corners = 32;

/// A convex plane face in the world.
struct PlacedFace {
  /// Counter-clockwise seen from outside, 3 to max_face_corners, all distinct [m].
  std::span<const Vec3> corners;
  Vec3 normal;  ///< outward unit normal
};

/// The mean plane and the overlap over it.
struct MeanPlane {
  Vec3 origin;        ///< [m]
  Vec3 x, y, normal;  ///< orthonormal, right-handed; `x` follows the first edge of a
  double overlap;     ///< at the origin [m]
  Vec2 slope;         ///< [m/m]

  [[nodiscard]] double overlap_at(const Vec2& p) const { return overlap + slope.dot(p); }
  [[nodiscard]] Vec3 at(const Vec2& p) const { return origin + p.x() * x + p.y() * y; }
  [[nodiscard]] Vec2 project(const Vec3& p) const {
    const Vec3 arm = p - origin;
    return {x.dot(arm), y.dot(arm)};
  }
};

/// The intersection of two convex faces in the mean plane, counter-clockwise.
struct SharedPolygon {
  int count = 0;                                  ///< number of corners; 0: empty
  std::array<Vec2, 2 * max_face_corners> corner;  ///< [count] [m]
  /// [count] Owner of the edge from corner i to the next: k is edge k of a (from its corner k on), -1 - k is edge k of
  /// b.
  std::array<int, 2 * max_face_corners> edge;
};

/// Overlap of two faces that may be in contact.
struct FaceOverlap3 {
  MeanPlane plane;
  SharedPolygon shared;
  int face_a = -1, face_b = -1;  ///< indices of the faces in their solids, if known
};

/// Fills `out`. Returns false, with an empty polygon, where the outward normals do not oppose each other or the
/// projections share no area. Clips a's projection by the edges of b's (Sutherland and Hodgman 1974); a corner on an
/// edge counts as inside. Exchanging the faces reverses the normal and changes nothing else but the axes of the plane.
bool face_overlap(const PlacedFace& a, const PlacedFace& b, FaceOverlap3& out);

/// Integrals over a part of the shared polygon; moments about the origin of the mean plane.
struct FaceIntegrals {
  double area = 0;                   ///< of 1 [m2]
  Vec2 area_moment = Vec2::Zero();   ///< of p [m3]
  double xx = 0, xy = 0, yy = 0;     ///< of x x, x y and y y [m4]
  double first = 0;                  ///< of c [m3]
  Vec2 first_moment = Vec2::Zero();  ///< of c p [m4]
  double energy = 0;                 ///< of c^2 / 2 [m4]
};

/// The same integrals, and the integrals of c x x, c x y and c y y [m5].
struct FaceMoments : FaceIntegrals {
  double first_xx = 0, first_xy = 0, first_yy = 0;
};

/// Integrals over the part where c > 0: the polygon cut along the line c = 0. Exact. `first`, `first_moment` and
/// `energy` and their first derivatives are continuous as corners enter and leave; `area` is discontinuous where
/// parallel faces meet.
FaceIntegrals integrals_in_contact(const FaceOverlap3& faces);
/// For any convex counter-clockwise polygon, with c = overlap + slope . p over it.
FaceIntegrals integrals_in_contact(std::span<const Vec2> corners, double overlap, const Vec2& slope);
FaceMoments moments_in_contact(const FaceOverlap3& faces);

/// Integrals over the whole shared polygon, c of either sign: for laws that also carry tension.
FaceIntegrals integrals_over_all(const FaceOverlap3& faces);
FaceIntegrals integrals_over_all(std::span<const Vec2> corners, double overlap, const Vec2& slope);

/// Derivative of the energy (integral of c^2 / 2 where c > 0) with respect to a translation of b along the mean plane,
/// at constant normal [m3]. It has two terms: -slope/2 times `first`, because b's face moves along a's, and c^2 / 2
/// along the shared polygon's edges that belong to b, because they move with b. The resulting force is below `first`
/// times the tilt, or c^2 over a length; with it the forces are the exact gradient of the energy.
Vec2 energy_by_sliding(const FaceOverlap3& faces);

}  // namespace trilith
