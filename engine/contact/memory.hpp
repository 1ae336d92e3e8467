// What one contact remembers from step to step.
#pragma once

#include <cstdint>

namespace trilith {

/// History of the contact of two convex pieces. A face contact keeps its two halves apart; a contact of general
/// shape spreads its one shear force over both. All zero means: nothing to remember.
struct alignas(32) ContactMemory {
  double shear_elastic[2] = {};  ///< elastic shear force of each half [N], + drives the second piece along +t
  double shear_total[2] = {};    ///< shear force with damping [N]
  double damping_force[2] = {};  ///< damping part of the last normal force: (force, moment) or (x, y) [N, N m]
  double active[2] = {};         ///< length of each half that carries shear [m]
  double slip = 0;               ///< accumulated sliding distance [m]
  std::uint32_t bonds = 0;       ///< bit h: half h still holds its bond
  std::uint32_t state = 0;       ///< bits of ContactState
  /// Softening bond: share of the strength of each half that is lost. Contact of general shape, which has no bond: the
  /// first is the moment of the damping force about the first piece's origin [N m], the second the force that crushes
  /// its mortar, 0 where that is sound [N].
  double own[2] = {};
  /// Gaps at both ends of the shared length as the joint's mortar set; where they are open it fills them [m].
  double set[2] = {};
  double crushed[2] = {};  ///< depth by which the mortar of each half is crushed, see contact/face_crush.hpp [m]

  [[nodiscard]] double damage(int half) const { return bonds != 0 ? own[half] : 0; }
  [[nodiscard]] bool empty() const { return bonds == 0 && state == 0; }
  /// What stays of a contact whose faces part: how far its mortar is crushed.
  [[nodiscard]] ContactMemory parted() const;
};

enum ContactState : std::uint32_t {
  contact_touching = 1,  ///< some stress was carried at the last step
  contact_general = 2,   ///< ... and found by overlap, not as a pair of faces
  contact_worn = 4,      ///< has been so since it began to touch: it dilates no more
  contact_crushed = 8,   ///< its mortar is crushed by some depth
};

inline ContactMemory ContactMemory::parted() const {
  ContactMemory left;
  left.state = state & contact_crushed;
  for (const int h : {0, 1}) left.crushed[h] = crushed[h];
  return left;
}

}  // namespace trilith
