// A rigid body: its one node carries all motion. Skin points turn with the node.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "base/space.hpp"

namespace trilith {

/// Motion of a node.
struct NodeMotion {
  Vec2 position;    ///< [m]
  double rotation;  ///< [rad]
  Vec2 velocity;    ///< [m/s]
  double spin;      ///< [rad/s]
};

/// place: skin points fixed in the body's axes to where they are and how fast they move.
/// `Point` has x, y [m], u, v [m/s]. Returns the largest speed squared.
template <class Point>
double place_rigid(const NodeMotion& node, std::span<const Vec2> skin, std::span<Point> out) {
  // Plain doubles: vectors of two make the compiler go through memory here, at three times the cost.
  const double c = std::cos(node.rotation), s = std::sin(node.rotation), spin = node.spin;
  const double x = node.position.x(), y = node.position.y(), u = node.velocity.x(), v = node.velocity.y();
  double fastest = 0;
  for (std::size_t i = 0; i < skin.size(); ++i) {
    const double px = skin[i].x(), py = skin[i].y();
    const double ax = c * px - s * py, ay = s * px + c * py;
    const double pu = u - spin * ay, pv = v + spin * ax;
    Point& p = out[i];
    p.x = x + ax;
    p.y = y + ay;
    p.u = pu;
    p.v = pv;
    fastest = std::max(fastest, pu * pu + pv * pv);
  }
  return fastest;
}

/// What forces at skin points come to at the node.
struct NodeLoad {
  double x = 0, y = 0;  ///< [N]
  double moment = 0;    ///< [N m]
};

/// spread: forces at skin points to the force and moment at the node; the transpose of `place`. Plain doubles here too.
template <class Point>
NodeLoad spread_rigid(const Vec2& node, std::span<const Point> skin, std::span<const Vec2> skin_force) {
  const double x = node.x(), y = node.y();
  NodeLoad sum;
  for (std::size_t i = 0; i < skin.size(); ++i) {
    const double fx = skin_force[i].x(), fy = skin_force[i].y();
    sum.x += fx;
    sum.y += fy;
    sum.moment += (skin[i].x - x) * fy - (skin[i].y - y) * fx;
  }
  return sum;
}

}  // namespace trilith
