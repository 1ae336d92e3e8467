// What one contact remembers from step to step, whatever its law.
#pragma once

#include <cstdint>

namespace trilith {

/// History of the contact of two convex pieces. A face contact keeps its two halves apart; a contact of general
/// shape spreads its one shear force over both. All zero means: nothing to remember. What a law remembers beside it is
/// its own, see Coulomb::Memory.
struct alignas(32) ContactMemory {
  double shear_elastic[2] = {};  ///< elastic shear force of each half [N], + drives the second piece along +t
  double shear_total[2] = {};    ///< shear force with damping [N]
  double damping_force[2] = {};  ///< damping part of the last normal force: (force, moment) or (x, y) [N, N m]
  double active[2] = {};         ///< length of each half that carries shear [m]
  double slip = 0;               ///< accumulated sliding distance [m]
  std::uint32_t bonds = 0;       ///< bit h: half h still holds its bond
  std::uint32_t state = 0;       ///< bits of ContactState
  double damping_moment = 0;     ///< of general shape: of the damping force about the first piece's origin [N m]

  [[nodiscard]] bool bonded(int half) const { return (bonds >> half & 1U) != 0; }
  [[nodiscard]] bool empty() const { return bonds == 0 && state == 0; }
  /// What stays of a contact whose faces part.
  [[nodiscard]] ContactMemory parted() const;

  /// Calls f with every number in turn, then g with bonds and state: for the hash and checkpoints. `Self`: of either
  /// constness.
  template <class Self, class F, class G>
  static void fields(Self& m, F&& f, G&& g) {
    for (auto* two : {&m.shear_elastic, &m.shear_total, &m.damping_force, &m.active}) f((*two)[0]), f((*two)[1]);
    f(m.slip), f(m.damping_moment);
    g(m.bonds, m.state);
  }
};

enum ContactState : std::uint32_t {
  contact_touching = 1,  ///< some stress was carried at the last step
  contact_general = 2,   ///< ... and found by overlap, not as a pair of faces
  contact_kept = 4,      ///< its law remembers something even while the two are apart
  contact_states = 7     ///< all of them
};

inline ContactMemory ContactMemory::parted() const {
  ContactMemory left;
  left.state = state & contact_kept;
  return left;
}

}  // namespace trilith
