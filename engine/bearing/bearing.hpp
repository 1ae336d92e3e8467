// A bearing: a multi-axial link between a point of one body and a point of another.
//
// The axes turn with body a. The displacement is that of b's point against a's, in those axes, less the offset at
// which the bearing was placed; so a link may be of zero or of finite length. The forces on both bodies act along one
// line, through b's point: momentum and angular momentum are kept. Barbosa, "Discontinuous structural analysis",
// interaction model.
#pragma once

#include <array>
#include <string>

#include "base/space.hpp"
#include "base/tie.hpp"
#include "bearing/list.hpp"

namespace trilith {

/// Directions of a plane bearing, in its own axes.
enum BearingDirection : int { along = 0, axial = 1, turning = 2 };

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

template <int D>
struct Bearing;

/// In space they come with laws of coupled directions; until then there are none.
template <>
struct Bearing<3> {
  std::string name;
  bool starts_waiting = false;
};

template <>
struct Bearing<2> {
  std::string name;
  int body_a = -1, body_b = -1;
  Tie<2> end_a, end_b;              ///< its points on them
  double angle = 0;                 ///< of direction `along`, in the axes of body a [rad]
  std::array<DirectionLaw, 3> law;  ///< along, axial (vertical), turning
  std::array<double, 3> limit = {unbounded, unbounded, unbounded};  ///< displacement that ends it [m], [m], [rad]
  Vec2 rest = Vec2::Zero();        ///< b's point from a's when placed, in the bearing's axes [m]
  double rest_angle = 0;           ///< of b against a when placed [rad]
  bool replaces_contact = false;   ///< while live, it stands for the flat contact of the pieces it sits between
  int piece_a = -1, piece_b = -1;  ///< those pieces: the ones whose faces are nearest to its points
  int contact_after = -1;          ///< index into Model::laws of the contact of the two pieces after
                                   ///< failure, or -1 for the one their surfaces have
  int becomes_bearing = -1;        ///< the bearing that goes live after failure, or -1
  bool starts_waiting = false;     ///< goes live only as another bearing's successor

  [[nodiscard]] bool sits_between(int p, int q) const {
    return (piece_a == p && piece_b == q) || (piece_a == q && piece_b == p);
  }
};

/// What a bearing remembers.
struct BearingMemory {
  BearingStatus status = BearingStatus::intact;
  std::uint32_t failed_direction = 0;
  std::array<DirectionMemory, 3> direction;
};

}  // namespace trilith
