// Contact of two convex solids of any shape and pose: pressure from the shared volume, friction on its resultant.
//
// For near solids without contact the last separating axis is tested first (geometry/space/separation_3d.hpp).
#pragma once

#include "contact/joint/shear_3d.hpp"
#include "contact/space/solid_pressure.hpp"
#include "geometry/space/separation_3d.hpp"
#include "law/contact/memory.hpp"

namespace trilith {

/// History of the contact of two convex solids. All zeros: no history.
struct SolidMemory {
  SlidingForce shear;                  ///< force of b on a, in world axes
  Vec3 normal = Vec3::Zero();          ///< unit normal of the plane of contact, from a to b
  Vec3 damping = Vec3::Zero();         ///< damping part of the last normal force on b [N]
  Vec3 damping_moment = Vec3::Zero();  ///< its moment about a's origin [N m]
  double slip = 0;                     ///< accumulated sliding distance [m]
  double crushed = 0;                  ///< crushed depth of the mortar between the two, kept when apart [m]
  double crushing_force = 0;  ///< force that crushed it in the last step, for any contact but a joint; or 0 [N]
  std::uint32_t state = 0;    ///< bits of ContactState; contact_kept: it is crushed

  [[nodiscard]] bool empty() const { return state == 0; }
  /// Memory that remains as the two separate, and for new contacts of the same solids.
  void keep_crushed(double depth, double force) {
    crushed = depth, crushing_force = force;
    if (depth > 0) state |= contact_kept;
  }

  /// Calls f with each number in turn, then g with the state: for the hash and checkpoints.
  template <class Self, class F, class G>
  static void fields(Self& m, F&& f, G&& g) {
    for (auto* v : {&m.shear.elastic, &m.shear.total, &m.normal, &m.damping, &m.damping_moment})
      for (const int k : {0, 1, 2}) f((*v)[k]);
    f(m.shear.area), f(m.slip), g(m.state);
    if ((m.state & contact_kept) != 0) f(m.crushed), f(m.crushing_force);
  }
};

/// Result of the contact. Forces on a are opposite, along the same lines.
struct SolidResponse {
  SolidMemory memory;
  bool touching = false;
  Vec3 force = Vec3::Zero();   ///< on b [N]
  Vec3 moment = Vec3::Zero();  ///< on b about `centre` [N m]
  Vec3 normal_force = Vec3::Zero();
  Vec3 centre = Vec3::Zero();                                     ///< of pressure [m]
  double area = 0, depth = 0;                                     ///< [m2], [m]
  int face_a = -1, face_b = -1;                                   ///< see SolidPressure
  Vec3 middle = Vec3::Zero(), normal = Vec3::Zero();              ///< of the area, for the step estimate [m]
  double radius = 0, friction_arm = 0;                            ///< see SolidPressure [m]
  std::array<Vec3, 2> arm{Vec3::Zero(), Vec3::Zero()};            ///< see SolidPressure [m]
  double lost_damping = 0, lost_friction = 0, lost_fracture = 0;  ///< [J]
};

/// Scratch buffers of one thread: for the shared solid, and for a part of it.
struct SolidRoom {
  SolidOverlapBuffer shared, part;
};

/// Normal pressure of two placed solids: of faces where they lie flat on each other, otherwise of the shared volume;
/// zero where they are apart. `apart`: the last separating axis, updated. `may_be_flat` false: no faces lie flat.
/// `crushed`: previous crushed depth of their mortar [m]. `along`: see solid_pressure; flat faces use their own normal.
SolidPressure pressure_between(const MovingSolid& a, const MovingSolid& b, const LawInUse& law, Separation3& apart,
                               SolidOverlapBuffer& shared, bool may_be_flat = true, double crushed = 0,
                               const Vec3* along = nullptr);

/// Contact forces of two solids with the pressure `pressed`, assuming the present motion over the step.
SolidResponse polyhedron_contact_forces(const MovingSolid& a, const MovingSolid& b, const SolidMemory& before,
                                        const LawInUse& law, const SolidPressure& pressed, SolidRoom& room);

/// Elastic energy of a contact, of its pressure and of its shear [J].
double solid_contact_energy(const PlacedSolid& a, const PlacedSolid& b, const SolidMemory& memory, const LawInUse& law,
                            SolidOverlapBuffer& shared, SolidOverlapBuffer& scratch);

}  // namespace trilith
