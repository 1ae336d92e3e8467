// Two plane faces that look at each other: the polygon they share and exact integrals of their overlap over it.
//
// n points from a to b: the mean of a's outward normal and the reverse of b's. The mean plane stands at right angles to
// it, midway between both faces everywhere. Over it the overlap c is linear, negative where the faces stand apart:
//
//        b ______________________                    c(p) = overlap + slope . p,  p = (x, y) in the mean plane
//                 ` - . _         ` - .
//     ^ n   - - - - - - -`- . - - - - - -            mean plane
//     |                 _ . - `              c > 0 to the right of the crossing
//        a _____________________________
//
// The shared polygon is that of both faces' projections along n. Nothing here allocates.
// For a law with stress Kn c over the part where c > 0: force Kn `first` along n, at `first_moment` / `first`;
// energy Kn `energy`; `area`, `area_moment` and `area_second` times Kn are its stiffness against moving along n and
// turning about axes in the plane.
#pragma once

#include <array>
#include <span>

#include "base/space.hpp"

namespace trilith {

/// Corners that one face may have here.
inline constexpr int max_face_corners = 32;

/// A convex plane face where it stands.
struct PlacedFace {
  /// Counter-clockwise as seen from outside, 3 to max_face_corners, no two in one place [m].
  std::span<const Vec3> corners;
  Vec3 normal;  ///< outward, of length 1
};

/// The mean plane and the overlap over it.
struct MeanPlane {
  Vec3 origin;        ///< [m]
  Vec3 x, y, normal;  ///< of length 1, at right angles, right-handed; `x` follows the first edge of a
  double overlap;     ///< at the origin [m]
  Vec2 slope;         ///< [m per m]

  [[nodiscard]] double overlap_at(const Vec2& p) const { return overlap + slope.dot(p); }
  [[nodiscard]] Vec3 at(const Vec2& p) const { return origin + p.x() * x + p.y() * y; }
  [[nodiscard]] Vec2 project(const Vec3& p) const {
    const Vec3 arm = p - origin;
    return {x.dot(arm), y.dot(arm)};
  }
};

/// What two convex faces share, in the mean plane, counter-clockwise.
struct SharedPolygon {
  int count = 0;                                  ///< corners; 0: nothing
  std::array<Vec2, 2 * max_face_corners> corner;  ///< [count] [m]
  /// [count] Whose edge runs from corner i to the next: k is edge k of a (from its corner k on), -1 - k is edge k of b.
  std::array<int, 2 * max_face_corners> edge;
};

/// Where two faces may touch.
struct FaceOverlap3 {
  MeanPlane plane;
  SharedPolygon shared;
  int face_a = -1, face_b = -1;  ///< which of their solids they are, where those were asked
};

/// Fills `out`; false, with nothing shared, where the outward normals do not point against each other or the
/// projections share no area. Clips a's projection by the edges of b's (Sutherland and Hodgman 1974); a corner on an
/// edge counts as inside. Exchanging the faces turns the normal round and leaves the rest, but for the axes of the
/// plane.
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

/// ... with those of c x x, c x y and c y y [m5].
struct FaceMoments : FaceIntegrals {
  double first_xx = 0, first_xy = 0, first_yy = 0;
};

/// Over the part where c > 0: the polygon cut along the line c = 0. Exact, and continuous with their first derivatives
/// in `first`, `first_moment` and `energy` as corners come in and go out; `area` begins at once where parallel faces
/// meet.
FaceIntegrals integrals_in_contact(const FaceOverlap3& faces);
/// The same of any convex polygon, counter-clockwise, and c = overlap + slope . p over it.
FaceIntegrals integrals_in_contact(std::span<const Vec2> corners, double overlap, const Vec2& slope);
FaceMoments moments_in_contact(const FaceOverlap3& faces);

/// Over all of the shared polygon, c of either sign: for what also carries tension.
FaceIntegrals integrals_over_all(const FaceOverlap3& faces);
FaceIntegrals integrals_over_all(std::span<const Vec2> corners, double overlap, const Vec2& slope);

/// Change of the energy (integral of c^2 / 2 where c > 0) as b slides by t along the mean plane, per t, while its
/// normal stays [m3]: -slope/2 times `first`, for its face moves under a's, and c^2 / 2 along the edges of the shared
/// polygon that are b's, for they move with it. A force of less than `first` times the tilt, or of c^2 over a length;
/// with it the forces are the energy's gradient to the last term.
Vec2 energy_by_sliding(const FaceOverlap3& faces);

}  // namespace trilith
