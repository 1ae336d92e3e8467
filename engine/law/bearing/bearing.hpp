// A bearing: a multi-axial link between a point of one body and a point of another.
//
// The axes turn with body a. The displacement is that of b's point against a's, in those axes, less the offset at
// which the bearing was placed; so a link may be of zero or of finite length. The forces on both bodies act along one
// line, through b's point: momentum and angular momentum are kept. Barbosa, "Discontinuous structural analysis",
// interaction model.
//
// In space b's turn against a is the rotation vector t of exp(t) = A' B, A and B being the axes of the bearing as they
// go with a and with b. With w the spin of b against a in the axes A,
//
//   t' = w - t x w / 2 + c t x (t x w),     c = (1 - |t|/2 cot(|t|/2)) / |t|^2,
//
// and couples m that go with t are the moment m + t x m / 2 + c t x (t x m) on b, so that its power is m . t'. Of the
// rotation vectors that differ by whole turns the one nearest to the last counts: t goes on past half a turn.
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

/// Directions of a bearing in D dimensions, in its own axes: translations first, the axial one last of them, then
/// turns. In space along is longitudinal, across transverse and axial vertical, where nothing else is said.
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

/// `removed`: it was taken away, or a body that it links was.
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

/// What a bearing has in space alone: a law of both horizontal directions, which then have none of their own.
struct HorizontalPart {
  DirectionLaw horizontal;
  double horizontal_limit = unbounded;  ///< resultant displacement that ends it [m]

  /// Whether along and across answer together, as in a circular yield or friction surface.
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
  Attachment<D> end_a, end_b;                                      ///< its points on them
  Rotation<D> angle{};                                             ///< of its axes, in those of body a [rad]
  std::array<DirectionLaw, directions> law;                        ///< see Directions
  std::array<double, directions> limit = no_limits<directions>();  ///< displacement that ends it [m], [rad]
  Vec<D> rest = Vec<D>::Zero();    ///< b's point from a's when placed, in the bearing's axes [m]
  Rotation<D> rest_angle{};        ///< when placed, of b against a [rad]; in space of its axes, in those of body b
  bool replaces_contact = false;   ///< while live, it stands for the contact of the pieces it sits between, as long as
                                   ///< that lies flat; tilted, what goes deeper touches
  int piece_a = -1, piece_b = -1;  ///< those pieces: the ones whose faces are nearest to its points
  int contact_after = -1;          ///< index into Model::laws of the contact of the two pieces after
                                   ///< failure, or -1 for the one their surfaces have
  int becomes_bearing = -1;        ///< the bearing that goes live after failure, or -1
  std::array<bool, directions> next_from_here{};  ///< directions in which that one counts displacement from where it
                                                  ///< takes over, and not from where it was placed
  bool starts_waiting = false;                    ///< goes live only as another bearing's successor

  [[nodiscard]] bool sits_between(int p, int q) const {
    return (piece_a == p && piece_b == q) || (piece_a == q && piece_b == p);
  }
  [[nodiscard]] bool next_counts_from_here() const {
    return std::find(next_from_here.begin(), next_from_here.end(), true) != next_from_here.end();
  }
  /// True where its failure changes the rule for the contact of the two pieces it sits between.
  [[nodiscard]] bool alters_contact() const { return replaces_contact || contact_after >= 0; }
};

/// What a bearing in space remembers besides.
struct HorizontalMemory {
  std::array<double, 3> turned{};  ///< last turn of b against a, a rotation vector: whole turns count too [rad]
  std::array<double, most_horizontal_numbers> horizontal{};  ///< of its law of both directions, see horizontal_memory
};
struct NoHorizontalMemory {};

/// What a bearing remembers.
template <int D>
struct BearingMemory : std::conditional_t<D == 3, HorizontalMemory, NoHorizontalMemory> {
  BearingStatus status = BearingStatus::intact;
  std::uint32_t failed_direction = 0;
  std::array<DirectionMemory, Space<D>::dofs> direction;
  std::array<double, Space<D>::dofs> begun_at{};  ///< displacement that its laws and limits count from [m], [rad]
  double stood_for = 0;  ///< depth of the contact it stands for when that last lay flat, 0 once the two part [m]
};

}  // namespace trilith
