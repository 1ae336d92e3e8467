// State of the broad phase between updates: the position of each piece at its last update, and its motion budget.
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/simd/lanes.hpp"
#include "base/space.hpp"
#include "geometry/hierarchical_hash_grid.hpp"
#include "model/contact/contact_history.hpp"

namespace trilith {

/// A number for each axis: in the plane in one register; in space plain doubles, because four lanes are not available
/// everywhere.
template <int D>
using AxisNumbers = std::conditional_t<D == 2, LanePair, Vec3>;

inline void set_all(LanePair& of, double number) {
  of = LanePair{number, number};
}
inline void set_all(Vec3& of, double number) {
  of.setConstant(number);
}
TRILITH_INLINE bool none_below(const LanePair& a, const LanePair& b) {
  const auto holds = a >= b;
  return (holds[0] & holds[1]) != 0;
}
TRILITH_INLINE bool none_below(const Vec3& a, const Vec3& b) {
  return a.x() >= b.x() && a.y() >= b.y() && a.z() >= b.z();
}
TRILITH_INLINE LanePair least_of(const LanePair& a, const LanePair& b) {
  return a < b ? a : b;
}
TRILITH_INLINE Vec3 least_of(const Vec3& a, const Vec3& b) {
  return {std::min(b.x(), a.x()), std::min(b.y(), a.y()), std::min(b.z(), a.z())};
}

/// Remaining motion budget of all corners of a body along each axis until their next check [m], and the largest
/// displacement in the last step [m]. Both are relative to BroadPhaseState::drift.
template <int D>
struct WayLeft {
  AxisNumbers<D> left, step;

  WayLeft() { set_all(left, 0), set_all(step, 0); }
  TRILITH_INLINE void go(const AxisNumbers<D>& way) { step = way, left -= way; }
  /// False if some corner may exceed its budget after `steps` more steps like the last one.
  [[nodiscard]] TRILITH_INLINE bool lasts(double steps, const AxisNumbers<D>& shifted) const {
    return none_below(left - steps * step, shifted);
  }
};

/// Positions are relative to the translation `together`, which may be arbitrary but is common to all pieces at an
/// instant. Common motion of most pieces, such as a building on its moving ground, then uses no budget.
template <int D>
struct BroadPhaseState {
  HierarchicalHashGrid<D> boxes;  ///< [piece] fat box, valid until its next update
  std::vector<Vec<D>> corner;     ///< [corner] position at the last update [m]
  std::vector<Vec<D>> low;        ///< [piece] least displacement allowed from there [m]
  std::vector<Vec<D>> high;       ///< [piece] largest displacement allowed from there [m]

  Vec<D> together = Vec<D>::Zero();  ///< [m]
  Vec<D> drift = Vec<D>::Zero();     ///< its rate from pose to pose until the next check [m/s]
  AxisNumbers<D> shifted;            ///< deviation of `together` from the drift, which reduces every budget [m]
  std::vector<int> sample;           ///< sample of skin points, distributed over the model
  std::vector<Vec<D>> sample_at;     ///< [sample] positions when `together` was last computed [m]

  double beside = 0;  ///< faces whose corners reach contact within this displacement count as touching pairs, see
                      ///< choose_face_pair [m]
  std::vector<double> margin;    ///< [piece] motion budget at rest [m]
  std::vector<WayLeft<D>> left;  ///< [body], in space [piece]
  bool may_have_left = false;    ///< some piece may have left its box. Writers: update_kinematics, update_contact_pairs
  std::vector<double> arm;       ///< [piece] half its longest diagonal [m]; 0 for a deformable body
  std::vector<std::uint8_t> may_move;             ///< [piece] 1: its body can move
  std::vector<std::uint8_t> is_due;               ///< [piece] 1: to be updated now
  std::vector<int> due;                           ///< these pieces
  std::vector<ContactKey> found;                  ///< pairs with a due piece, sorted
  std::vector<std::vector<ContactKey>> found_by;  ///< [thread] scratch: the same, unsorted
  std::vector<int> due_rows;                      ///< scratch: rows of the present list with a due piece
  std::vector<int> to_face;                       ///< scratch: rows whose faces are to be updated

  /// Bearings that modify the contact of the two pieces that they connect, sorted by pieces, then by bearing.
  std::vector<std::pair<ContactKey, int>> bearing;

  BroadPhaseState() { set_all(shifted, 0); }
};

}  // namespace trilith
