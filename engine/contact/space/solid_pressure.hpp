// Normal pressure between two convex solids of any shape and pose, from the volume they share.
//
// As contact/plane/overlap_pair.hpp in the plane: the elastic energy is W = kn/2 ( integral of e(phi_A) + integral of
// e(phi_B) ) over the shared volume, phi being the distance to the nearest surface face of a solid. Its derivative is a
// pressure kn/2 e(phi_A) on the faces of B inside A, along their own normals, and the same for A's faces inside B. So
// energy is kept by construction, and two parallel faces press each other by kn times their overlap.
//
//            _______________
//           |  A            |        On the face f of B that is inside of A, phi_A is the least of the depths below A's
//           |   \__f__/ - - | - B    faces: linear in cells, each a convex polygon, over which all integrals are exact
//           |_______________|        where the law is linear.
//
// Damping acts on the motion along the resultant of the springs (contact/space/triangle_sums.hpp); the pressure is
// never below 0 with it.
#pragma once

#include <array>

#include "base/simd/lanes.hpp"
#include "geometry/space/overlap_3d.hpp"
#include "law/contact/list.hpp"
#include "law/contact/step_increment.hpp"

namespace trilith {

/// A place that moves and turns.
struct MovingPlace {
  Vec3 origin, velocity, spin;         ///< [m], [m/s], [rad/s]
  const StepBehind* behind = nullptr;  ///< see MovingSolid
};

/// A convex solid where it stands and how its body moves.
struct MovingSolid {
  const PlacedSolid& placed;
  Vec3 origin, velocity, spin;         ///< of its body: a point of it and its velocity [m], [m/s], [rad/s]
  const StepBehind* behind = nullptr;  ///< after an implicit step, of which velocities are those of the end
  const MovingPlace* faces = nullptr;  ///< [face] of a solid that deforms, whose faces move each for itself

  /// As face `face` moves; of -1, and of a solid that does not deform, itself.
  [[nodiscard]] MovingSolid by_face(int face) const {
    if (faces == nullptr || face < 0) return *this;
    const MovingPlace& f = faces[face];
    return {placed, f.origin, f.velocity, f.spin, f.behind, faces};
  }

  [[nodiscard]] Vec3 velocity_at(const Vec3& x) const { return velocity + cross(spin, Vec3(x - origin)); }
};

/// Sums over the pressed faces of two solids.
struct SolidPressure {
  Vec3 force = Vec3::Zero();           ///< on b [N]
  Vec3 moment = Vec3::Zero();          ///< ... about the centre [N m]
  Vec3 damping = Vec3::Zero();         ///< the part of `force` that damping adds [N]
  Vec3 damping_moment = Vec3::Zero();  ///< ... about the centre [N m]
  double damped = 0;                   ///< power that damping takes [W]
  Vec3 centre = Vec3::Zero();          ///< of pressure, or of the area where there is none [m]
  double pressure = 0;                 ///< integral of the pressure, whatever way it acts [N]
  double area = 0;                     ///< in contact: half of the pressed faces of both [m2]
  Vec3 middle = Vec3::Zero();          ///< of the area in contact [m]
  double radius = 0;                   ///< of gyration of the area about its middle [m]
  double friction_arm = 0;             ///< mean distance of the pressure from its centre, see mean_distance [m]
  /// Arms in its plane, of which the products sum to its second moments over the area, see spread_arms [m]
  std::array<Vec3, 2> arm{Vec3::Zero(), Vec3::Zero()};
  double depth = 0;              ///< greatest depth of a pressed face in the other solid [m]
  int face_a = -1, face_b = -1;  ///< of faces that lie flat on each other; -1 of any other shape
  double crushed = 0;            ///< depth by which their mortar is crushed now [m]
  Vec3 along = Vec3::Zero();     ///< that which was asked for, else zero: friction then goes by the force itself
};

/// Of the solid they share, which solid_overlap has left in `shared`, whose room is used; all zero where it is empty.
/// Mortar crushed by the depth `crushed` [m] presses by what lies deeper. `along`: of length 1, where other pieces of
/// the two bodies press at the same place the direction of all their springs: damping knows that one, in place of the
/// pair's own.
SolidPressure solid_pressure(const MovingSolid& a, const MovingSolid& b, const LawInUse& law,
                             SolidOverlapBuffer& shared, double crushed = 0, const Vec3* along = nullptr);

/// Mean distance of a plane area from its centroid [m], from its second moments about it (of unit area, trace of the
/// tensor and the product of its two principal values). A line of length l has l/4 and a gyration of l/sqrt(12), a
/// square .9375 of its gyration, a disc .9428; between them this is right to 1 %, triangles to 2 %. Of an area under
/// pressure likewise: 2 % where the pressure of a rectangle grows from nothing at one side, 6 % at one corner.
template <class T>
TRILITH_INLINE T mean_distance(T trace, T product) {
  const T zero{}, one = zero + 1.0;
  const T roundness = larger(zero, smaller(one, 4.0 * product / (trace * trace)));
  return select(trace > zero, root(trace) * (0.8660 + 0.0725 * root(roundness)), zero);
}

/// Some direction across n, of length 1.
Vec3 line_across(const Vec3& n);

/// Two arms a, b with a a' + b b' the second moments of an area over it, in a plane of axes x and y [m].
std::array<Vec3, 2> spread_arms(double xx, double xy, double yy, const Vec3& x, const Vec3& y);

}  // namespace trilith
