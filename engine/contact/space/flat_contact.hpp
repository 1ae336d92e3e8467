// Contact of solids that lie flat on each other, four pairs at once: pressure over the polygon shared by one face of
// each, and friction on its resultant.
//
//     b ________________
//        |  c > 0      /
//     a ________________
//
// Input: positions of the two faces, motion of both bodies, the contact's memory, the law. Output: force and moment on
// both bodies, the new memory, dissipated energies, and whether the faces do lie flat (contact/space/solid_faces.hpp).
// If not, the other results must not be used.
//
// Where the overlap c and c + beta dc/dt are both positive, the normal stress is kn (c + beta dc/dt). Both are linear
// over the polygon, so its integrals follow from the polygon's integrals up to third order
// (geometry/space/face_lanes.hpp). Friction follows contact/joint/shear_3d.hpp, with its spring at the centroid of the
// area, whatever the pressure.
#pragma once

#include "contact/joint/shear_3d.hpp"
#include "geometry/space/face_lanes.hpp"

namespace trilith {

/// Motion of a body as its contacts use it.
struct MovingInLanes {
  Triple<Lanes> origin, velocity, spin;

  [[nodiscard]] TRILITH_INLINE Triple<Lanes> velocity_at(const Triple<Lanes>& x) const {
    return velocity + cross(spin, x - origin);
  }
};

/// Memory of a contact, see SolidMemory.
struct FlatMemory {
  ShearForce<Lanes> shear;
  Triple<Lanes> normal, damping, damping_moment;
  Lanes slip;
};

/// Motion, memory and law of four contacts.
struct alignas(32) ContactsInLanes {
  MovingInLanes a, b;
  FlatMemory before;
  Lanes kn, ks, mu, beta;
  double dt = 0;
};

struct alignas(32) FlatContacts : ContactsInLanes {
  FacesInLanes faces;
  LaneMask b_is_larger;  ///< see near_faces of contact/space/solid_faces.hpp
  Lanes near;            ///< see near_faces [m]
};

/// Upper bound of kinds.
inline constexpr std::int64_t flat_kinds = std::int64_t{2} << told_lines;

struct alignas(32) FlatResponses {
  LaneMask flat;     ///< one pair of faces that touch, within the limits of flat faces
  LaneMask rough;    ///< rounding prevents a result: the scalar method is used
  LaneMask presses;  ///< there is an area in contact
  /// Kind of a contact, used to group pairs: which edges its polygon has, and whether it slides.
  LaneMask kind;
  FlatMemory memory;                        ///< valid in the lanes of `presses`
  Triple<Lanes> force, moment_a, moment_b;  ///< force on b; moments on both about their origins
  Triple<Lanes> normal_force, centre, middle, normal;
  std::array<Triple<Lanes>, 2> arm;
  Lanes area, depth, radius, friction_arm, lost_damping, lost_friction;
};

/// Computes four contacts.
void respond_flat(const FlatContacts& in, FlatResponses& out);

}  // namespace trilith
