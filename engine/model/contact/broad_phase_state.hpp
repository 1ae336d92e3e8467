// What finding pairs keeps from one search to the next: where each piece was looked up, and how far it may go from
// there.
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

/// A number for each axis: in the plane in one register. In space plain ones, which four lanes are not everywhere.
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

/// How far all corners of a body may still go along each axis before they are looked at [m], and what the one that went
/// farthest went by at the last pose [m]: both beside BroadPhaseState::drift.
template <int D>
struct WayLeft {
  AxisNumbers<D> left, step;

  WayLeft() { set_all(left, 0), set_all(step, 0); }
  TRILITH_INLINE void go(const AxisNumbers<D>& way) { step = way, left -= way; }
  /// False where some corner may have gone farther after so many more steps as the last.
  [[nodiscard]] TRILITH_INLINE bool lasts(double steps, const AxisNumbers<D>& shifted) const {
    return none_below(left - steps * step, shifted);
  }
};

/// Places are beside `together`, which may be anything as long as it is the same for all pieces at an instant: what
/// most move by then moves none of them, as of a building on its ground.
template <int D>
struct BroadPhaseState {
  HierarchicalHashGrid<D> boxes;  ///< [piece] where it may go before it is looked up again
  std::vector<Vec<D>> corner;     ///< [corner] where it was looked up m
  std::vector<Vec<D>> low;        ///< [piece] the least that a corner may go from there ... m
  std::vector<Vec<D>> high;       ///< [piece] ... and the most m

  Vec<D> together = Vec<D>::Zero();  ///< m
  Vec<D> drift = Vec<D>::Zero();     ///< at which it goes on from pose to pose until the next look m/s
  AxisNumbers<D> shifted;            ///< how far it was moved beside that, which nobody has left any more m
  std::vector<int> sample;           ///< some skin points all over the model
  std::vector<Vec<D>> sample_at;     ///< [sample] where they were when `together` was found last m

  double beside = 0;  ///< faces whose corners are to move by no more than this to touch lie beside each other m
  std::vector<double> margin;                     ///< [piece] how far it may go however slow it is m
  std::vector<WayLeft<D>> left;                   ///< [body], in space [piece]
  bool may_have_left = false;                     ///< some piece its box. Writer: place, detect
  std::vector<double> arm;                        ///< [piece] half its longest diagonal; 0 of a body that deforms m
  std::vector<std::uint8_t> may_move;             ///< [piece] 1: its body does
  std::vector<std::uint8_t> is_due;               ///< [piece] 1: to be looked up now
  std::vector<int> due;                           ///< those pieces
  std::vector<ContactKey> found;                  ///< pairs of which one piece is due, sorted
  std::vector<std::vector<ContactKey>> found_by;  ///< [thread] room: the same as they come
  std::vector<int> due_rows;                      ///< room: rows of the list that there is with one of those pieces
  std::vector<int> to_face;                       ///< room: rows whose faces are to be looked at

  /// Bearings that alter the contact of the two pieces they sit between, by these, then by bearing.
  std::vector<std::pair<ContactKey, int>> bearing;

  BroadPhaseState() { set_all(shifted, 0); }
};

}  // namespace trilith
