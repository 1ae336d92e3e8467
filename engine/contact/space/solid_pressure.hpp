// Normal pressure between two convex solids of any shape and pose, from the shared volume.
//
// As in the plane (contact/plane/overlap_pair.hpp), the elastic energy is W = kn/2 ( integral of e(phi_A) + integral of
// e(phi_B) ) over the shared volume, where phi is the distance to the nearest surface face of a solid. Its derivative
// is a pressure kn/2 e(phi_A) on the faces of B inside A, along their own normals, and likewise for A's faces inside B.
// So energy is conserved by construction, and two parallel faces press each other by kn times their overlap.
//
//            _______________
//           |  A            |
//           |   \__f__/ - - | - B
//           |_______________|
//
// On the face f of B inside A, phi_A is the least of the depths below A's faces. It is linear in cells, each a convex
// polygon, so all integrals are exact for a linear law.
//
// Damping acts on the motion along the resultant of the springs (contact/space/triangle_sums.hpp); the pressure
// including damping is never negative.
#pragma once

#include <array>

#include "base/simd/lanes.hpp"
#include "geometry/space/overlap_3d.hpp"
#include "law/contact/list.hpp"
#include "law/contact/step_increment.hpp"

namespace trilith {

/// A moving and rotating frame.
struct MovingPlace {
  Vec3 origin, velocity, spin;         ///< [m], [m/s], [rad/s]
  const StepBehind* behind = nullptr;  ///< see MovingSolid
};

/// A placed convex solid and the motion of its body.
struct MovingSolid {
  const PlacedSolid& placed;
  Vec3 origin, velocity, spin;         ///< a point of its body, its velocity and spin [m], [m/s], [rad/s]
  const StepBehind* behind = nullptr;  ///< after an implicit step, whose velocities are at its end; else nullptr
  const MovingPlace* faces = nullptr;  ///< [face] of a deforming solid, whose faces move separately

  /// The motion of face `face`; for -1, or a solid that does not deform, the solid's motion.
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
  Vec3 moment = Vec3::Zero();          ///< on b about the centre [N m]
  Vec3 damping = Vec3::Zero();         ///< the part of `force` due to damping [N]
  Vec3 damping_moment = Vec3::Zero();  ///< its moment about the centre [N m]
  double damped = 0;                   ///< power dissipated by damping [W]
  Vec3 centre = Vec3::Zero();          ///< of pressure, or of the area where there is no pressure [m]
  double pressure = 0;                 ///< integral of the pressure's magnitude [N]
  double area = 0;                     ///< in contact: half of the pressed faces of both [m2]
  Vec3 middle = Vec3::Zero();          ///< centroid of the area in contact [m]
  double radius = 0;                   ///< radius of gyration of the area about its centroid [m]
  double friction_arm = 0;             ///< mean distance of the pressure from its centre, see mean_distance [m]
  /// In-plane arms whose products sum to the second moments per area, see spread_arms [m]
  std::array<Vec3, 2> arm{Vec3::Zero(), Vec3::Zero()};
  double depth = 0;              ///< largest depth of a pressed face in the other solid [m]
  int face_a = -1, face_b = -1;  ///< indices of flat faces; -1 for any other contact
  double crushed = 0;            ///< present crushed depth of their mortar [m]
  Vec3 along = Vec3::Zero();     ///< the given `along`, else zero: friction then uses the force's own direction
};

/// Pressure of the shared solid that solid_overlap has left in `shared`, whose buffers are used; zero if it is empty.
/// Mortar crushed by `crushed` [m] carries pressure beyond this depth only. `along`: unit vector, the common direction
/// of all springs if other pieces of the two bodies press at the same position; damping uses it instead of the pair's
/// direction.
SolidPressure solid_pressure(const MovingSolid& a, const MovingSolid& b, const LawInUse& law,
                             SolidOverlapBuffer& shared, double crushed = 0, const Vec3* along = nullptr);

/// Mean distance of a plane area from its centroid [m], from its second moments per area about it (trace of the tensor
/// and the product of its two principal values). A line of length l has l/4 and a radius of gyration of l/sqrt(12), a
/// square 0.9375 of its radius of gyration, a disc 0.9428; in between this is accurate to 1 %, triangles to 2 %. For an
/// area under pressure the same holds: 2 % if the pressure of a rectangle grows from zero at one side, 6 % at one
/// corner.
template <class T>
TRILITH_INLINE T mean_distance(T trace, T product) {
  const T zero{}, one = zero + 1.0;
  const T roundness = larger(zero, smaller(one, 4.0 * product / (trace * trace)));
  return select(trace > zero, root(trace) * (0.8660 + 0.0725 * root(roundness)), zero);
}

/// A unit vector normal to n.
Vec3 line_across(const Vec3& n);

/// Two arms a, b such that a a' + b b' are the second moments per area, in a plane with the axes x and y [m].
std::array<Vec3, 2> spread_arms(double xx, double xy, double yy, const Vec3& x, const Vec3& y);

}  // namespace trilith
