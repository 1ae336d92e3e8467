// Memory of one contact between steps, common to all laws.
#pragma once

#include <cstdint>

namespace trilith {

/// History of the contact of two convex pieces. A face contact keeps its two halves separate; a general contact
/// distributes its one shear force over both. All zeros: no history. Additional memory of a law is separate, see
/// Coulomb::Memory.
struct alignas(32) ContactMemory {
  double shear_elastic[2] = {};  ///< elastic shear force of each half [N]; + pushes the second piece along +t
  double shear_total[2] = {};    ///< shear force with damping [N]
  double damping_force[2] = {};  ///< damping part of the last normal force: (force, moment) or (x, y) [N, N m]
  double active[2] = {};         ///< length of each half that carries shear [m]
  double slip = 0;               ///< accumulated sliding distance [m]
  std::uint32_t bonds = 0;       ///< bit h: half h is still bonded
  std::uint32_t state = 0;       ///< bits of ContactState
  double damping_moment = 0;     ///< general contact: moment of the damping force about the first piece's origin [N m]

  [[nodiscard]] bool bonded(int half) const { return (bonds >> half & 1U) != 0; }
  [[nodiscard]] bool empty() const { return bonds == 0 && state == 0; }
  /// Memory that remains when the faces separate.
  [[nodiscard]] ContactMemory parted() const;

  /// Calls f with each number in turn, then g with bonds and state: for the hash and checkpoints. `Self`: const or not.
  template <class Self, class F, class G>
  static void fields(Self& m, F&& f, G&& g) {
    for (auto* two : {&m.shear_elastic, &m.shear_total, &m.damping_force, &m.active}) f((*two)[0]), f((*two)[1]);
    f(m.slip), f(m.damping_moment);
    g(m.bonds, m.state);
  }
};

enum ContactState : std::uint32_t {
  contact_touching = 1,  ///< some stress was carried at the last step
  contact_general = 2,   ///< found by overlap, not as a face pair
  contact_kept = 4,      ///< its law keeps a memory even while the two are apart
  contact_states = 7     ///< all of them
};

inline ContactMemory ContactMemory::parted() const {
  ContactMemory left;
  left.state = state & contact_kept;
  return left;
}

}  // namespace trilith
