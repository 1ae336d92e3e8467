// What placing does alike in the plane and in space: the rows of bodies, and of all that is placed how fast it is, how
// far it has come and what that leaves it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/team.hpp"
#include "model/work.hpp"

namespace trilith {

/// The largest squares of all that is placed, of its speeds and of those of bodies that are free to move, and the least
/// that is left along each axis. One to each thread: none has part of another's in a line of its cache.
template <int D>
struct alignas(64) DisplacementBound {
  double speed2 = 0, moving = 0;  ///< [m2/s2]
  double path2 = 0;               ///< [m2]
  AxisNumbers<D> left;            ///< see WayLeft [m]

  DisplacementBound() { set_all(left, unbounded); }

  /// `moves`(): asked where it says something.
  template <class Reach, class Moves>
  TRILITH_INLINE void add(const Reach& of, Moves&& moves) {
    speed2 = std::max(speed2, of.speed2()), path2 = std::max(path2, of.path2());
    if (of.speed2() > moving && moves()) moving = of.speed2();
  }
  /// Takes what a body or piece went by from what is left to it.
  TRILITH_INLINE void follow(const AxisNumbers<D>& step, WayLeft<D>& way) {
    way.go(step);
    left = least_of(way.left, left);
  }
  void add(const DisplacementBound& other) {
    speed2 = std::max(speed2, other.speed2), path2 = std::max(path2, other.path2);
    moving = std::max(moving, other.moving), left = least_of(other.left, left);
  }
};

/// Each thread keeps the largest of what it places: the largest of these is the same in any order.
/// place(first, last, reach).
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

/// All bodies' rows, anew where the pairs must be found anew.
template <int D>
void list_bodies(const Model<D>& model, Work<D>& work) {
  work.body.clear();
  for (const Body& b : model.bodies)
    work.body.push_back({b.first_node, b.nodes, b.first_skin, b.skins, info_of(b.kind).skin, b.first_fit, b.fits});
}

/// What later stages ask of all together.
template <int D>
void keep_displacement_bound(const DisplacementBound<D>& reach, Work<D>& work) {
  work.fastest = std::sqrt(reach.speed2);
  work.fastest_moving = std::sqrt(reach.moving);
  // Both of no meaning, and not asked for, before the pairs are found.
  work.travel += std::sqrt(reach.path2);
  work.search.may_have_left = !none_below(reach.left, work.search.shifted);
}

}  // namespace trilith
