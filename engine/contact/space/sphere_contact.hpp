// Contact of spheres with spheres and with convex polyhedra: pressure over the shared area, and friction.
//
//        .-""-.
//       /  A   \ .
//       \.-""-./  s
//       /'-..-'\ .
//       \  B   /
//        '-..-'
//
// Two spheres press each other over the plane disc of their intersection: kn e(s) at each point, where s is the overlap
// there along the line of centres. For a linear law the sum is F = kn V with the volume V of the lens. The energy W is
// the integral of F, and dF/d(overlap) = kn pi a^2.
//
// A polyhedron is pressed on the parts of its faces inside the sphere by kn e(phi), where phi = R - |x - centre| is the
// depth below the sphere's surface. This is the derivative of W = kn times the integral over the shared volume of the
// energy of phi, which is phi for a linear law. So energy is conserved over faces, edges and corners, and the force
// passes through the sphere's centre. Two polyhedra with flush faces act as one: the joint between them has no effect.
//
// Both cases tend to kn pi R d^2 for a shallow overlap d of a sphere and a plane. Damping is kn beta times the closing
// speed at the centre of the area, cut off where the sum would be tension. As they separate at the speed v, a point has
// the pressure by which its e exceeds beta v.
#pragma once

#include "contact/space/solid_contact.hpp"

namespace trilith {

/// One of the two, and the motion of its body.
struct SphereSide {
  const Sphere& sphere;       ///< radius 0: it is the polyhedron
  const PlacedSolid& placed;  ///< used for a polyhedron only
  Vec3 origin, velocity, spin;
  const StepBehind* behind = nullptr;  ///< see MovingSolid

  [[nodiscard]] Vec3 velocity_at(const Vec3& x) const { return velocity + cross(spin, Vec3(x - origin)); }
};

/// At least one of the two is a sphere. Friction is a spring and slider of any direction at the centre of the area,
/// which rotates with the pair. Rotation about the normal counts as a path at 8/15 of the area's radius, so its limit
/// equals a disc's under the pressure of a sphere. Slip and rotation share one limit, a circle. `apart`: lower bound of
/// their distance where they do not touch [m].
SolidResponse respond_spheres(const SphereSide& a, const SphereSide& b, const SolidMemory& before, const LawInUse& law,
                              double& apart);

/// Elastic energy of the pressure between the two, without shear [J].
double sphere_energy(const PlacedSolid& a, const PlacedSolid& b, const LawInUse& law);

}  // namespace trilith
