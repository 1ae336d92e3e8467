// A bearing: a multi-axial link between a point of one body and a point of another.
//
// The axes rotate with body a. The displacement is the position of b's point relative to a's, in these axes, minus the
// offset at placement; so a link may have zero or finite length. The forces on both bodies act along one line through
// b's point: momentum and angular momentum are conserved. Barbosa, "Discontinuous structural analysis", interaction
// model.
//
// In space the rotation of b relative to a is the rotation vector t with exp(t) = A' B, where A and B are the bearing's
// axes as they rotate with a and with b. With the relative spin w of b in the axes A,
//
//   t' = w - t x w / 2 + c t x (t x w),     c = (1 - |t|/2 cot(|t|/2)) / |t|^2.
//
// A moment m conjugate to t acts on b as m + t x m / 2 + c t x (t x m), so that its power is m . t'. Among the rotation
// vectors that differ by whole turns the one nearest to the last is used: t continues beyond half a turn.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <type_traits>
#include <variant>

#include "base/attachment.hpp"
#include "base/space.hpp"
#include "law/bearing/list.hpp"

namespace trilith {

/// Directions of a plane bearing, in its own axes.
enum BearingDirection : int { along = 0, axial = 1, turning = 2 };

/// Directions of a bearing in D dimensions, in its own axes: translations first, of which the axial one is last, then
/// rotations. In space along is longitudinal, across transverse and axial vertical by default.
template <int D>
struct Directions;
template <>
struct Directions<2> {
  static constexpr std::array<const char*, 3> names{"along", "axial", "turning"};
  static constexpr int axial = 1, first_turning = 2;
};
template <>
struct Directions<3> {
  static constexpr std::array<const char*, 6> names{"along",         "across",         "axial",
                                                    "turning_along", "turning_across", "turning_axial"};
  static constexpr int axial = 2, first_turning = 3;
  static constexpr int horizontal = 6;  ///< the resultant of along and across, for limits
};
/// "m" or "rad".
template <int D>
constexpr const char* unit_of_direction(int k) {
  return k < Directions<D>::first_turning ? "m" : "rad";
}

/// `removed`: the bearing was removed, or a body that it links.
enum class BearingStatus : std::uint32_t { waiting, intact, yielded, failed, changed, removed };

/// "intact", ...
constexpr const char* name_of(BearingStatus s) {
  constexpr std::array names{"waiting", "intact", "yielded", "failed", "changed", "removed"};
  return names[static_cast<std::size_t>(s)];
}
/// True where the bearing carries load.
constexpr bool is_live(BearingStatus s) {
  return s == BearingStatus::intact || s == BearingStatus::yielded;
}

/// Data of a bearing in space alone: a law of both horizontal directions, which then have no single laws.
struct HorizontalPart {
  DirectionLaw horizontal;
  double horizontal_limit = unbounded;  ///< resultant displacement at which it fails [m]

  /// Whether along and across have a common law, such as a circular yield or friction surface.
  [[nodiscard]] bool has_horizontal() const { return !std::holds_alternative<std::monostate>(horizontal); }
};
struct NoHorizontalPart {
  [[nodiscard]] static constexpr bool has_horizontal() { return false; }
};

template <std::size_t count>
constexpr std::array<double, count> no_limits() {
  std::array<double, count> out{};
  out.fill(unbounded);
  return out;
}

template <int D>
struct Bearing : std::conditional_t<D == 3, HorizontalPart, NoHorizontalPart> {
  static constexpr std::size_t directions = Space<D>::dofs;

  std::string name;
  int body_a = -1, body_b = -1;
  Attachment<D> end_a, end_b;                ///< the linked points
  Rotation<D> angle{};                       ///< rotation of its axes relative to the axes of body a [rad]
  std::array<DirectionLaw, directions> law;  ///< see Directions
  std::array<double, directions> limit = no_limits<directions>();  ///< displacement at which it fails [m], [rad]
  Vec<D> rest = Vec<D>::Zero();  ///< b's point relative to a's at placement, in the bearing's axes [m]
  Rotation<D> rest_angle{};  ///< at placement: plane, rotation of b relative to a [rad]; space, the bearing's axes in
                             ///< the axes of body b
  bool replaces_contact = false;   ///< while live, it replaces the flat contact of the pieces that it connects; if
                                   ///< tilted, deeper overlap is in contact
  int piece_a = -1, piece_b = -1;  ///< these pieces: their faces are nearest to its points
  int contact_after = -1;  ///< index into Model::laws of the contact law of the two pieces after failure, or -1 for the
                           ///< law of their surfaces
  int becomes_bearing = -1;                       ///< the bearing that becomes live after failure, or -1
  std::array<bool, directions> next_from_here{};  ///< directions in which the successor counts displacement from its
                                                  ///< activation, not from its placement
  bool starts_waiting = false;                    ///< becomes live only as another bearing's successor

  [[nodiscard]] bool sits_between(int p, int q) const {
    return (piece_a == p && piece_b == q) || (piece_a == q && piece_b == p);
  }
  [[nodiscard]] bool next_counts_from_here() const {
    return std::find(next_from_here.begin(), next_from_here.end(), true) != next_from_here.end();
  }
  /// True where it replaces the contact of the two pieces that it connects, or sets its law after failure.
  [[nodiscard]] bool alters_contact() const { return replaces_contact || contact_after >= 0; }
};

/// Memory of a bearing in space alone.
struct HorizontalMemory {
  std::array<double, 3> turned{};  ///< last rotation of b relative to a, a rotation vector with whole turns [rad]
  std::array<double, most_horizontal_numbers> horizontal{};  ///< of its law of both directions, see horizontal_memory
};
struct NoHorizontalMemory {};

/// Memory of a bearing.
template <int D>
struct BearingMemory : std::conditional_t<D == 3, HorizontalMemory, NoHorizontalMemory> {
  BearingStatus status = BearingStatus::intact;
  std::uint32_t failed_direction = 0;
  std::array<DirectionMemory, Space<D>::dofs> direction;
  std::array<double, Space<D>::dofs> begun_at{};  ///< displacement from which its laws and limits count [m], [rad]
  double stood_for = 0;  ///< depth of the replaced contact when it last lay flat, 0 once the two separate [m]
};

}  // namespace trilith
