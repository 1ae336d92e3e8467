// A rigid body: its one node carries all motion. Skin points turn with the node.
#pragma once

#include <algorithm>
#include <span>

#include "base/portable.hpp"
#include "base/rotation_3d.hpp"
#include "base/simd/lane_rows.hpp"
#include "base/simd/lanes.hpp"
#include "base/space.hpp"

namespace trilith {

/// Motion of a node.
template <int D>
struct NodeMotion {
  Vec<D> position;       ///< [m]
  Rotation<D> rotation;  ///< [rad] in the plane
  Vec<D> velocity;       ///< [m/s]
  Spin<D> spin;          ///< [rad/s]
};

/// Of two vectors.
TRILITH_INLINE LanePair squared_sizes(const LanePair& a, const LanePair& b) {
  const LanePair of_a = a * a, of_b = b * b;
  return LanePair(__builtin_shufflevector(of_a, of_b, 0, 2)) + LanePair(__builtin_shufflevector(of_a, of_b, 1, 3));
}

/// How fast skin points are and how far they have come since they were placed last.
class SkinReach {
 public:
  /// `drift`: beside which `step` is counted [m].
  TRILITH_INLINE explicit SkinReach(const LanePair& drift) : drift_(drift) {}

  /// Where a point is and how fast it moves, (x, y, u, v), and the same of before.
  TRILITH_INLINE void add(const Lanes& now, const Lanes& before) {
    const Lanes moved = now - before, of = __builtin_shufflevector(moved, now, 0, 1, 6, 7), squares = of * of;
    const Lanes sizes = squares + __builtin_shufflevector(squares, squares, 1, 0, 3, 2);
    const LanePair way = LanePair{moved[0], moved[1]} - drift_, beside = way < LanePair{} ? -way : way;
    most2_ = sizes > most2_ ? sizes : most2_;
    step_ = beside > step_ ? beside : step_;
  }
  [[nodiscard]] TRILITH_INLINE double speed2() const { return most2_[2]; }  ///< the largest square [m2/s2]
  [[nodiscard]] TRILITH_INLINE double path2() const { return most2_[0]; }   ///< likewise [m2]
  /// The most along x and along y [m].
  [[nodiscard]] TRILITH_INLINE LanePair step() const { return step_; }

 private:
  LanePair drift_, step_{};
  Lanes most2_{};
};

/// place: skin points fixed in the body's axes to where they are and how fast they move.
/// `turn`: of the node's rotation. `Point` has x, y [m], u, v [m/s], side by side at a multiple of 32; of
/// before, and overwritten. `reach`: taken up.
template <class Point>
TRILITH_INLINE void place_rigid(const NodeMotion<2>& node, const portable::SineCosine& turn, std::span<const Vec2> skin,
                                std::span<Point> out, SkinReach& reach) {
  const auto [s, c] = turn;
  // Columns of the turn, to (x, y, y, x); then (x, y) as they are and (y, x) times the spin.
  const Lanes to_x{c, s, s, c}, to_y{-s, c, c, -s}, spin{1, 1, -node.spin, node.spin};
  const Lanes origin{node.position.x(), node.position.y(), node.velocity.x(), node.velocity.y()};
  for (std::size_t i = 0; i < skin.size(); ++i) {
    const double x = skin[i].x(), y = skin[i].y();
    const Lanes now = origin + spin * (to_x * x + to_y * y);
    reach.add(now, load_lanes(&out[i].x));
    store_lanes(&out[i].x, now);
  }
}

/// What forces at skin points come to at the node.
struct NodeLoad {
  LanePair force{};   ///< [N]
  double moment = 0;  ///< [N m]
};

/// spread: forces at skin points to the force and moment at the node; the transpose of `place`.
template <class Point>
TRILITH_INLINE NodeLoad spread_rigid(const Vec2& node, std::span<const Point> skin, std::span<const Vec2> skin_force) {
  const LanePair origin{node.x(), node.y()};
  LanePair sum{};
  double moment = 0;
  for (std::size_t i = 0; i < skin.size(); ++i) {
    const LanePair force = load_pair(skin_force[i].data()), arm = load_pair(&skin[i].x) - origin;
    const LanePair turning = arm * __builtin_shufflevector(force, force, 1, 0);
    sum += force;
    moment += turning[0] - turning[1];
  }
  return {sum, moment};
}

}  // namespace trilith
