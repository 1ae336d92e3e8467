// A rigid body: its one node carries all motion. Skin points turn with the node.
#pragma once

#include <algorithm>
#include <span>

#include "base/lanes.hpp"
#include "base/portable.hpp"
#include "base/rotation_3d.hpp"
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
  explicit SkinReach(const Vec2& drift) : drift_{drift.x(), drift.y()} {}

  TRILITH_INLINE void add(const LanePair& rate, const LanePair& moved) {
    const LanePair sizes = squared_sizes(rate, moved), beside = moved - drift_, steps = beside * beside;
    most2_ = sizes > most2_ ? sizes : most2_;
    step2_ = steps > step2_ ? steps : step2_;
  }
  [[nodiscard]] double speed2() const { return most2_[0]; }  ///< the largest square [m2/s2]
  [[nodiscard]] double path2() const { return most2_[1]; }   ///< likewise [m2]
  /// The most along x and along y [m].
  [[nodiscard]] TRILITH_INLINE LanePair step() const { return root(step2_); }

 private:
  LanePair drift_, most2_{}, step2_{};
};

/// place: skin points fixed in the body's axes to where they are and how fast they move.
/// `turn`: of the node's rotation. `Point` has x, y [m], u, v [m/s], side by side at a multiple of 16; of before, and
/// overwritten. `reach`: taken up.
template <class Point>
void place_rigid(const NodeMotion<2>& node, const portable::SineCosine& turn, std::span<const Vec2> skin,
                 std::span<Point> out, SkinReach& reach) {
  const auto [s, c] = turn;
  const LanePair to_x{c, s}, to_y{-s, c}, spin{-node.spin, node.spin};  // columns of the turn; spin x (y, x)
  const LanePair origin{node.position.x(), node.position.y()}, velocity{node.velocity.x(), node.velocity.y()};
  for (std::size_t i = 0; i < skin.size(); ++i) {
    const double x = skin[i].x(), y = skin[i].y();
    const LanePair arm = to_x * x + to_y * y;
    const LanePair rate = velocity + spin * __builtin_shufflevector(arm, arm, 1, 0), place = origin + arm;
    reach.add(rate, place - load_pair(&out[i].x));
    store_pair(&out[i].x, place);
    store_pair(&out[i].u, rate);
  }
}

/// What forces at skin points come to at the node.
struct NodeLoad {
  double x = 0, y = 0;  ///< [N]
  double moment = 0;    ///< [N m]
};

/// spread: forces at skin points to the force and moment at the node; the transpose of `place`.
template <class Point>
NodeLoad spread_rigid(const Vec2& node, std::span<const Point> skin, std::span<const Vec2> skin_force) {
  const LanePair origin{node.x(), node.y()};
  LanePair sum{};
  double moment = 0;
  for (std::size_t i = 0; i < skin.size(); ++i) {
    const LanePair force = load_pair(skin_force[i].data()), arm = load_pair(&skin[i].x) - origin;
    const LanePair turning = arm * __builtin_shufflevector(force, force, 1, 0);
    sum += force;
    moment += turning[0] - turning[1];
  }
  return {sum[0], sum[1], moment};
}

}  // namespace trilith
