// A rigid body: its one node carries all motion. Skin points rotate with the node.
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
  Rotation<D> rotation;  ///< in the plane [rad]
  Vec<D> velocity;       ///< [m/s]
  Spin<D> spin;          ///< [rad/s]
};

/// Squared lengths of two vectors.
TRILITH_INLINE LanePair squared_sizes(const LanePair& a, const LanePair& b) {
  const LanePair of_a = a * a, of_b = b * b;
  return LanePair(__builtin_shufflevector(of_a, of_b, 0, 2)) + LanePair(__builtin_shufflevector(of_a, of_b, 1, 3));
}

/// Largest speed of skin points and largest displacement from their last placement.
class SkinReach {
 public:
  /// `drift`: displacement relative to which `step` is measured [m].
  TRILITH_INLINE explicit SkinReach(const LanePair& drift) : drift_(drift) {}

  /// Adds a point: its position and velocity (x, y, u, v) now and before.
  TRILITH_INLINE void add(const Lanes& now, const Lanes& before) {
    const Lanes moved = now - before, of = __builtin_shufflevector(moved, now, 0, 1, 6, 7), squares = of * of;
    const Lanes sizes = squares + __builtin_shufflevector(squares, squares, 1, 0, 3, 2);
    const LanePair way = LanePair{moved[0], moved[1]} - drift_, beside = way < LanePair{} ? -way : way;
    most2_ = sizes > most2_ ? sizes : most2_;
    step_ = beside > step_ ? beside : step_;
  }
  [[nodiscard]] TRILITH_INLINE double speed2() const { return most2_[2]; }  ///< largest squared speed [m2/s2]
  [[nodiscard]] TRILITH_INLINE double path2() const { return most2_[0]; }   ///< largest squared displacement [m2]
  /// Largest displacement along x and along y [m].
  [[nodiscard]] TRILITH_INLINE LanePair step() const { return step_; }

 private:
  LanePair drift_, step_{};
  Lanes most2_{};
};

/// place: computes positions and velocities of skin points fixed in the body's axes. `turn`: sine and cosine of the
/// node's rotation. `Point` has x, y [m], u, v [m/s], contiguous and aligned to 32 bytes; the previous values are
/// overwritten. `reach`: is updated.
template <class Point>
TRILITH_INLINE void place_rigid(const NodeMotion<2>& node, const portable::SineCosine& turn, std::span<const Vec2> skin,
                                std::span<Point> out, SkinReach& reach) {
  const auto [s, c] = turn;
  // Columns of the rotation, to (x, y, y, x); then (x, y) unchanged and (y, x) times the spin.
  const Lanes to_x{c, s, s, c}, to_y{-s, c, c, -s}, spin{1, 1, -node.spin, node.spin};
  const Lanes origin{node.position.x(), node.position.y(), node.velocity.x(), node.velocity.y()};
  for (std::size_t i = 0; i < skin.size(); ++i) {
    const double x = skin[i].x(), y = skin[i].y();
    const Lanes now = origin + spin * (to_x * x + to_y * y);
    reach.add(now, load_lanes(&out[i].x));
    store_lanes(&out[i].x, now);
  }
}

/// Resultant at the node of forces at skin points.
struct NodeLoad {
  LanePair force{};   ///< [N]
  double moment = 0;  ///< [N m]
};

/// spread: transforms forces at skin points to the force and moment at the node; the transpose of `place`.
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
