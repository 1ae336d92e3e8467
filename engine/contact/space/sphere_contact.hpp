// Contact of spheres with spheres and with convex polyhedra: pressure over the area that they share, friction on it.
//
//        .-""-.            Two spheres press each other over the plane disc in which they cut: kn e(s) at each place, s
//       /  A   \           the overlap there along the line of centres. Where the law is linear the sum is
//       \.-""-./  s
//       /'-..-'\               F = kn V,   V the volume of the lens;   W = integral of F,   dF/d(overlap) = kn pi a^2
//       \  B   /
//        '-..-'            A polyhedron is pressed on the parts of its faces inside of the sphere by kn e(phi), phi the
//                          depth below the sphere's surface, R - |x - centre|. That is the derivative of
//
//                              W = kn * integral of (energy of phi) over the volume they share,   phi where linear
//
//                          so energy is kept over faces, edges and corners alike, the force goes through the sphere's
//                          centre, and two polyhedra that lie flush press as one: nothing is felt at the joint.
//
// Both come to kn pi R d^2 for a shallow overlap d of a sphere and a plane. Damping is kn beta times the speed at which
// the two close at the middle of the area, cut off where the sum would pull: as they part at the speed v, a place is
// pressed by as much as its e is above beta v.
#pragma once

#include "contact/space/solid_contact.hpp"

namespace trilith {

/// One of the two, and how its body moves.
struct SphereSide {
  const Sphere& sphere;       ///< radius 0: it is the polyhedron
  const PlacedSolid& placed;  ///< read of a polyhedron alone
  Vec3 origin, velocity, spin;
  const StepBehind* behind = nullptr;  ///< see MovingSolid

  [[nodiscard]] Vec3 velocity_at(const Vec3& x) const { return velocity + cross(spin, Vec3(x - origin)); }
};

/// At least one of the two is a sphere. Friction is a spring and slider of any direction at the middle of the area,
/// which turns with the pair; turning about the normal counts as a path at 8/15 of the radius of the area, so that the
/// most it carries is that of a disc under the pressure of a sphere. Slip and turn share one limit, a circle.
/// `apart`: at least how far they are from each other where they do not touch [m].
SolidResponse respond_spheres(const SphereSide& a, const SphereSide& b, const SolidMemory& before, const LawInUse& law,
                              double& apart);

/// Elastic energy of the pressure between the two, without shear [J].
double sphere_energy(const PlacedSolid& a, const PlacedSolid& b, const LawInUse& law);

}  // namespace trilith
