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

/// How fast skin points are and how far they have come since they were placed last: the largest squares.
struct SkinReach {
  double speed2 = 0;  ///< [m2/s2]
  double path2 = 0;   ///< [m2]

  void add(double speed, double path) { speed2 = std::max(speed2, speed), path2 = std::max(path2, path); }
};

/// place: skin points fixed in the body's axes to where they are and how fast they move.
/// `turn`: of the node's rotation. `Point` has x, y [m], u, v [m/s], side by side at a multiple of 16; of before, and
/// overwritten.
template <class Point>
SkinReach place_rigid(const NodeMotion<2>& node, const portable::SineCosine& turn, std::span<const Vec2> skin,
                      std::span<Point> out) {
  const auto [s, c] = turn;
  const LanePair to_x{c, s}, to_y{-s, c}, spin{-node.spin, node.spin};  // columns of the turn; spin x (y, x)
  const LanePair origin{node.position.x(), node.position.y()}, velocity{node.velocity.x(), node.velocity.y()};
  SkinReach reach;
  for (std::size_t i = 0; i < skin.size(); ++i) {
    const double x = skin[i].x(), y = skin[i].y();
    const LanePair arm = to_x * x + to_y * y;
    const LanePair rate = velocity + spin * __builtin_shufflevector(arm, arm, 1, 0), squares = rate * rate;
    const LanePair place = origin + arm, moved = place - load_pair(&out[i].x), paths = moved * moved;
    store_pair(&out[i].x, place);
    store_pair(&out[i].u, rate);
    reach.add(squares[0] + squares[1], paths[0] + paths[1]);
  }
  return reach;
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
