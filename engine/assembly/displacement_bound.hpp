// Kinematics common to the plane and space: rows of bodies, and bounds of speed, travel and remaining motion budget.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/team.hpp"
#include "model/work.hpp"

namespace trilith {

/// Bounds over all placed points: largest squared speeds, also of bodies that are free to move, and least remaining
/// motion budget along each axis. Each thread has its own, in separate cache lines.
template <int D>
struct alignas(64) DisplacementBound {
  double speed2 = 0, moving = 0;  ///< [m2/s2]
  double path2 = 0;               ///< [m2]
  AxisNumbers<D> left;            ///< see WayLeft [m]

  DisplacementBound() { set_all(left, unbounded); }

  /// `moves`(): called only if it can change the result.
  template <class Reach, class Moves>
  TRILITH_INLINE void add(const Reach& of, Moves&& moves) {
    speed2 = std::max(speed2, of.speed2()), path2 = std::max(path2, of.path2());
    if (of.speed2() > moving && moves()) moving = of.speed2();
  }
  /// Subtracts the step of a body or piece from its motion budget.
  TRILITH_INLINE void follow(const AxisNumbers<D>& step, WayLeft<D>& way) {
    way.go(step);
    left = least_of(way.left, left);
  }
  void add(const DisplacementBound& other) {
    speed2 = std::max(speed2, other.speed2), path2 = std::max(path2, other.path2);
    moving = std::max(moving, other.moving), left = least_of(other.left, left);
  }
};

/// Each thread keeps the bounds of its share; their maximum does not depend on the order. place(first, last, reach).
template <int D, class Place>
DisplacementBound<D> place_shared(const Work<D>& work, int count, int stretch, Place&& place) {
  std::array<DisplacementBound<D>, most_threads> by{};
  share(work.threads, count, stretch, [&](int first, int last, int thread) {
    DisplacementBound<D> reach;
    place(first, last, reach);
    by[static_cast<std::size_t>(thread)].add(reach);
  });
  DisplacementBound<D> reach;
  for (const DisplacementBound<D>& one : by) reach.add(one);
  return reach;
}

/// Lists the rows of all bodies when the pairs must be rebuilt.
template <int D>
void list_bodies(const Model<D>& model, Work<D>& work) {
  work.body.clear();
  for (const Body& b : model.bodies)
    work.body.push_back({b.first_node, b.nodes, b.first_skin, b.skins, info_of(b.kind).skin, b.first_fit, b.fits});
}

/// Stores the bounds for later stages.
template <int D>
void keep_displacement_bound(const DisplacementBound<D>& reach, Work<D>& work) {
  work.fastest = std::sqrt(reach.speed2);
  work.fastest_moving = std::sqrt(reach.moving);
  // Undefined and unused before the pairs are found.
  work.travel += std::sqrt(reach.path2);
  work.search.may_have_left = !none_below(reach.left, work.search.shifted);
}

}  // namespace trilith
