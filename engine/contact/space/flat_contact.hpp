// Contact of solids that lie flat on each other, four pairs at once: pressure over the polygon that a face of each
// shares, and friction on its resultant.
//
//     b ________________        In:  where the two faces stand, how both bodies move, what the contact remembers, law.
//        |  c > 0      /        Out: force and moment on both bodies, what is remembered then, energies given off; and
//     a ________________             whether the faces do lie flat (contact/space/solid_faces.hpp), else nothing is to
//     be used.
//
// Where the overlap c and c + beta dc/dt are both above 0 the stress along the normal is kn (c + beta dc/dt): with both
// linear over the polygon, its integrals are those of the polygon up to third order (geometry/space/face_lanes.hpp).
// Friction is that of contact/joint/shear_3d.hpp, its spring in the middle of the area, whatever the pressure does.
#pragma once

#include "contact/joint/shear_3d.hpp"
#include "geometry/space/face_lanes.hpp"

namespace trilith {

/// A body as its contacts see it move.
struct MovingInLanes {
  Triple<Lanes> origin, velocity, spin;

  [[nodiscard]] TRILITH_INLINE Triple<Lanes> velocity_at(const Triple<Lanes>& x) const {
    return velocity + cross(spin, x - origin);
  }
};

/// What a contact remembers, see SolidMemory.
struct FlatMemory {
  ShearForce<Lanes> shear;
  Triple<Lanes> normal, damping, damping_moment;
  Lanes slip;
};

struct alignas(32) FlatContacts {
  FacesInLanes faces;
  LaneMask b_is_larger;  ///< see near_faces of contact/space/solid_faces.hpp
  Lanes near;            ///< likewise [m]
  MovingInLanes a, b;
  FlatMemory before;
  Lanes kn, ks, mu, beta;
  double dt = 0;
};

/// Kinds are below this.
inline constexpr std::int64_t flat_kinds = std::int64_t{2} << told_lines;

struct alignas(32) FlatResponses {
  LaneMask flat;     ///< one pair of faces that touch, within the limits of faces that lie flat
  LaneMask rough;    ///< rounding keeps the kernel from an answer: the one by one form has it
  LaneMask presses;  ///< there is an area in contact
  /// Of what kind a contact is, for which pairs go together: which edges its polygon has, and whether it slides.
  LaneMask kind;
  FlatMemory memory;                        ///< of those that press
  Triple<Lanes> force, moment_a, moment_b;  ///< force on b; moments on both about their origins
  Triple<Lanes> normal_force, centre, middle, normal;
  std::array<Triple<Lanes>, 2> arm;
  Lanes area, depth, radius, friction_arm, lost_damping, lost_friction;
};

/// Answers four contacts.
void respond_flat(const FlatContacts& in, FlatResponses& out);

}  // namespace trilith
