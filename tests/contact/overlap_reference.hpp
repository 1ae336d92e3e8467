// Pressures of two convex pieces, evaluated edge by edge and face by face: the reference for the engine's version,
// which evaluates four at once and must give the same bits. Linear springs with damping along their resultant, without
// friction.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "contact/joint/chord.hpp"
#include "contact/plane/overlap_pair.hpp"

namespace trilith::testing {

struct ReferenceOverlap {
  bool apart = false;
  Vec2 push = Vec2::Zero(), normal = Vec2::Zero();  ///< force of the springs, over kn / 2; its direction
  Vec2 moment_arm = Vec2::Zero(), damping = Vec2::Zero();
  double force = 0, damping_moment = 0, pressure = 0, length = 0, depth = 0;
  std::vector<Vec2> on_a, on_b;
};

/// One side: edges of the walker inside the owner.
class ReferenceWalk {
 public:
  ReferenceWalk(const PlacedPiece& owner, const PlacedPiece& walker, bool walker_is_b, const Coulomb& law)
      : owner_(owner), walker_(walker), walker_is_b_(walker_is_b), law_(law) {}

  /// Depth of corner v of the walker below face f of the owner.
  [[nodiscard]] double depth(int f, int v) const { return normal(owner_, f).dot(owner_.corner[f] - walker_.corner[v]); }
  /// True if some face of the owner has all corners of the walker outside.
  [[nodiscard]] bool apart() const {
    for (int f = 0; f < corners(owner_); ++f) {
      bool all = true;
      for (int v = 0; v < corners(walker_); ++v) all = all && depth(f, v) <= 0;
      if (all) return true;
    }
    return false;
  }
  /// Calls f(edge, face, from, to) for every segment.
  template <class F>
  void each(F&& f) const {
    for (int e = 0; e < corners(walker_); ++e)
      if (is_surface(walker_, e)) along(e, f);
  }
  void add_push(ReferenceOverlap& sums) const {
    each([&](int e, int f, double from, double to) {
      const double mean = law_.stretch(phi(e, f, from), phi(e, f, to), 0.0, 0.0).spring.sum,
                   pressed = (to - from) * mean;
      const Vec2 side = way(walker_, e), turned(pressed * side.y(), pressed * -side.x());
      sums.push += walker_is_b_ ? Vec2(-turned) : turned;
    });
  }
  void run(ReferenceOverlap& sums) const {
    each([&](int e, int f, double from, double to) { press(e, f, from, to, sums); });
  }

 private:
  static int corners(const PlacedPiece& p) { return static_cast<int>(p.corner.size()); }
  static bool is_surface(const PlacedPiece& p, int e) {
    return p.is_face[e] != 0 || std::none_of(p.is_face.begin(), p.is_face.end(), [](auto f) { return f != 0; });
  }
  static Vec2 way(const PlacedPiece& p, int e) { return p.corner[(e + 1) % corners(p)] - p.corner[e]; }
  static Vec2 normal(const PlacedPiece& p, int e) { return Vec2(way(p, e).y(), -way(p, e).x()) / way(p, e).norm(); }

  template <class F>
  void along(int e, F&& add) const {
    const int w = (e + 1) % corners(walker_);
    double from = 0, to = 1;
    for (int f = 0; f < corners(owner_); ++f) {
      const double d0 = depth(f, e), d1 = depth(f, w);
      if (d0 <= 0 && d1 <= 0) return;
      if (d0 < 0) from = std::max(from, d0 / (d0 - d1));
      if (d1 < 0) to = std::min(to, d0 / (d0 - d1));
    }
    double last = std::numeric_limits<double>::infinity();
    while (from < to) {
      const auto slope = [&](int f) { return depth(f, w) - depth(f, e); };
      const auto here = [&](int f) { return depth(f, e) + slope(f) * from; };
      const auto counts = [&](int f, double below) { return is_surface(owner_, f) && slope(f) < below; };
      int face = -1;
      for (int f = 0; f < corners(owner_); ++f)
        if (counts(f, last) && (face < 0 || here(f) < here(face) || (here(f) == here(face) && slope(f) < slope(face))))
          face = f;
      if (face < 0) return;
      double until = to;
      for (int f = 0; f < corners(owner_); ++f)
        if (counts(f, slope(face)))
          until = std::min(until, std::max(from, from + (here(f) - here(face)) / (slope(face) - slope(f))));
      add(e, face, from, until);
      from = until, last = slope(face);
    }
  }
  [[nodiscard]] double phi(int e, int f, double at) const {
    const int w = (e + 1) % corners(walker_);
    return std::max(0.0, depth(f, e) + (depth(f, w) - depth(f, e)) * at);
  }
  void press(int e, int f, double from, double to, ReferenceOverlap& sums) const {
    const Vec2 n = normal(walker_, e), start = walker_.corner[e], &along = sums.normal;
    const Vec2 x0 = start + from * way(walker_, e), x1 = start + to * way(walker_, e), over = x1 - x0;
    const double sign = walker_is_b_ ? 1 : -1;
    const double share = -sign * along.dot(n), facing = std::max(0.0, share);
    const auto closing = [&](const Vec2& x) {
      const Vec2 apart = walker_.velocity_at(e, x) - owner_.velocity_at(f, x) + (chord(walker_, x) - chord(owner_, x));
      return -facing * along.dot(walker_is_b_ ? apart : Vec2(-apart));
    };
    const auto [stress, spring] = law_.stretch(phi(e, f, from), phi(e, f, to), closing(x0), closing(x1));
    const double stiff = 0.5 * law_.kn * over.norm(), total = stiff * stress.sum, elastic = stiff * spring.sum;
    const double damping = facing * (stiff * (stress.sum - spring.sum)),
                 moment = facing * (stiff * (stress.moment - spring.moment));
    const Vec2& about = walker_is_b_ ? owner_.origin : walker_.origin;
    sums.length += 0.5 * over.norm();
    sums.depth = std::max({sums.depth, phi(e, f, from), phi(e, f, to)});
    sums.damping += damping * along;
    sums.damping_moment += damping * cross(Vec2(x0 - about), along) + moment * cross(over, along);
    if (elastic <= 0) return;
    const double at = spring.moment / spring.sum;
    const Vec2 x = x0 + at * over, on_b = damping * along - sign * elastic * n;
    const double turning = sign * ((moment - at * damping) * cross(over, along));
    add(walker_, e, x, sign * on_b, turning, walker_is_b_ ? sums.on_b : sums.on_a);
    add(owner_, f, x, -(sign * on_b), -turning, walker_is_b_ ? sums.on_a : sums.on_b);
    sums.force += share * total;
    sums.pressure += total;
    sums.moment_arm += total * x0 + stiff * stress.moment * over;
  }
  static bool is_straight(const PlacedPiece& p) { return p.over_step != nullptr || !p.corner_velocity.empty(); }
  /// Change of the velocity of point x of one of two rigid pieces by its motion along a chord, see
  /// contact/joint/chord.hpp.
  [[nodiscard]] Vec2 chord(const PlacedPiece& p, const Vec2& x) const {
    if (is_straight(owner_) || is_straight(walker_)) return Vec2::Zero();
    return chord_rate(p.spin, law_.dt) * (x - p.origin);
  }
  static void add(const PlacedPiece& p, int e, const Vec2& x, const Vec2& force, double moment, std::vector<Vec2>& on) {
    const Vec2 along = way(p, e);
    const double share = along.dot(x - p.corner[e]) / along.squaredNorm();
    const Vec2 foot = p.corner[e] + share * along;
    const Vec2 couple = left_of(along) * ((cross(Vec2(x - foot), force) + moment) / along.squaredNorm());
    on[e] += (1 - share) * force - couple;
    on[(e + 1) % corners(p)] += share * force + couple;
  }

  const PlacedPiece &owner_, &walker_;
  bool walker_is_b_;
  Coulomb law_;
};

inline ReferenceOverlap reference_overlap(const PlacedPiece& a, const PlacedPiece& b, const Coulomb& law) {
  ReferenceOverlap sums;
  sums.on_a.assign(a.corner.size(), Vec2::Zero());
  sums.on_b.assign(b.corner.size(), Vec2::Zero());
  const ReferenceWalk b_walks(a, b, true, law), a_walks(b, a, false, law);
  sums.apart = b_walks.apart() || a_walks.apart();
  if (sums.apart) return sums;
  b_walks.add_push(sums), a_walks.add_push(sums);
  if (const double size = sums.push.norm(); size > 0) sums.normal = sums.push / size;
  b_walks.run(sums);
  a_walks.run(sums);
  return sums;
}

}  // namespace trilith::testing
