// The pressures of two convex pieces that overlap: each presses its edges against the nearest faces of the other.
//
//       v     from           crossing      to      w       phi along the edge (v, w) of the walker is the least of
//       |------|===== f1 =======|=== f2 ===|-------|       its depths below the owner's faces: straight in pieces,
//      outside     phi = depth       phi = depth           slopes falling, so integrals are exact piece by piece
//                  below f1          below f2
//
// Comes in: both pieces with their edges placed, the depths of the walker's corners in the owner (overlap_depths.hpp),
// a law. Goes out: forces at the corners of both, and sums of what they come to.
#pragma once

#include "contact/overlap_depths.hpp"

namespace trilith {

/// The part of `span` where a depth that is linear from d0 to d1 over all of the edge is above `crushed`.
TRILITH_INLINE EdgeSpan above(double crushed, double d0, double d1, const EdgeSpan& span) {
  const auto depth = [&](double share) { return d0 + (d1 - d0) * share - crushed; };
  const double width = span.to - span.from;
  const PositivePart<double> part(depth(span.from), depth(span.to));
  return {span.from + width * part.from, span.from + width * part.to};
}

/// Adds `force` at point `x` to the two corners of edge e of one piece, and what is opposite to those of edge f of the
/// other: same resultants, and same moments through a couple. A lane each.
TRILITH_INLINE void add_opposite(std::span<Vec2> on_p, const PlacedPiece& p, int e, std::span<Vec2> on_q,
                                 const PlacedPiece& q, int f, const Vec2& x, const Vec2& force) {
  const int e1 = e + 1 < static_cast<int>(p.corner.size()) ? e + 1 : 0;
  const int f1 = f + 1 < static_cast<int>(q.corner.size()) ? f + 1 : 0;
  const LanePair one{1, 1}, at_x{x.x(), x.x()}, at_y{x.y(), x.y()};
  const LanePair from_x{p.corner[e].x(), q.corner[f].x()}, from_y{p.corner[e].y(), q.corner[f].y()};
  const LanePair along_x = LanePair{p.corner[e1].x(), q.corner[f1].x()} - from_x;
  const LanePair along_y = LanePair{p.corner[e1].y(), q.corner[f1].y()} - from_y;
  const LanePair length2 = along_x * along_x + along_y * along_y;
  const LanePair share = (along_x * (at_x - from_x) + along_y * (at_y - from_y)) / length2;
  const LanePair off_x = at_x - (from_x + share * along_x), off_y = at_y - (from_y + share * along_y);
  const LanePair force_x{force.x(), -force.x()}, force_y{force.y(), -force.y()};
  const LanePair turn = (off_x * force_y - off_y * force_x) / length2;
  const LanePair couple_x = -along_y * turn, couple_y = along_x * turn, rest = one - share;
  const LanePair first_x = rest * force_x - couple_x, first_y = rest * force_y - couple_y;
  const LanePair second_x = share * force_x + couple_x, second_y = share * force_y + couple_y;
  on_p[e] += Vec2(first_x[0], first_y[0]);
  on_p[e1] += Vec2(second_x[0], second_y[0]);
  on_q[f] += Vec2(first_x[1], first_y[1]);
  on_q[f1] += Vec2(second_x[1], second_y[1]);
}

/// Sums over the pressed faces of both sides.
struct OverlapSums {
  Vec2 force = Vec2::Zero(), moment_arm = Vec2::Zero();
  Vec2 damping = Vec2::Zero();  ///< damping part of the force on b ...
  double damping_moment = 0;    ///< ... and its moment about a's origin ...
  double damped = 0;            ///< ... and the power it takes [W]
  double pressure = 0, length = 0, deepest = 0;
  double most_a = 0, most_b = 0;  ///< largest share of the pressure on one edge, and which edge
  int edge_a = 0, edge_b = 0;
};

/// One side's faces inside the other piece: the walker presses its edges against the owner's nearest faces.
template <class K, int most, bool walker_is_b>
struct OverlapWalk {
  const PlacedPiece& owner;
  const PieceSides& owner_sides;
  const PlacedPiece& walker;
  const PieceSides& walker_sides;
  const OverlapDepths<most>& depths;  ///< of the walker's corners in the owner
  const K& law;
  double crushed;  ///< [m]
  std::span<Vec2> on_owner, on_walker;

  /// Speeds at which they close at both ends of a stretch [m/s]; above 0 where they do.
  [[nodiscard]] TRILITH_INLINE LanePair closing(const PlacedPiece& moving, const PlacedPiece& met, int edge, int face,
                                                const Vec2& n, const LanePair& x, const LanePair& y) const {
    if (moving.corner_velocity.empty() && met.corner_velocity.empty()) {
      const LanePair u = moving.velocity.x() - moving.spin * (y - moving.origin.y()),
                     v = moving.velocity.y() + moving.spin * (x - moving.origin.x());
      const LanePair met_u = met.velocity.x() - met.spin * (y - met.origin.y()),
                     met_v = met.velocity.y() + met.spin * (x - met.origin.x());
      return n.x() * (u - met_u) + n.y() * (v - met_v);
    }
    const auto speed = [&](const Vec2& at) { return n.dot(moving.velocity_at(edge, at) - met.velocity_at(face, at)); };
    return LanePair{speed({x[0], y[0]}), speed({x[1], y[1]})};
  }
  TRILITH_INLINE void press(int edge, int face, const EdgeSpan& span, double phi0, double phi1,
                            OverlapSums& sums) const;
  TRILITH_INLINE void press_edge(int e, OverlapSums& sums) const;
  TRILITH_INLINE void run(OverlapSums& sums) const;
};

/// Presses the part of `edge` in `span`, whose depths below `face` are phi0 and phi1 at its ends.
template <class K, int most, bool walker_is_b>
TRILITH_INLINE void OverlapWalk<K, most, walker_is_b>::press(int edge, int face, const EdgeSpan& span, double phi0,
                                                             double phi1, OverlapSums& sums) const {
  const EdgeLanes& four = walker_sides.four[edge / lane_count];
  const Vec2 n(four.nx[edge % lane_count], four.ny[edge % lane_count]);  // out of the walker, into the owner
  const Vec2& start = walker.corner[edge];
  const Vec2 along = walker.corner[edge + 1 < depths.corners ? edge + 1 : 0] - start;
  const LanePair share{span.from, span.to}, xs = start.x() + share * along.x(), ys = start.y() + share * along.y();
  const Vec2 x0(xs[0], ys[0]), way(xs[1] - xs[0], ys[1] - ys[0]);
  // c > 0: they close. k is half of kn, and half the length counts, as the other piece's walk brings the other halves.
  const LanePair c = closing(walker, owner, edge, face, n, xs, ys);
  const double length = way.norm(), k = 0.5 * law.kn;
  const auto [stress, spring] = law.stretch(phi0, phi1, c[0], c[1]);
  sums.length += 0.5 * length;
  sums.deepest = larger(larger(sums.deepest, phi0), phi1);
  const double total = k * length * stress.sum;
  constexpr double sign = walker_is_b ? 1.0 : -1.0;
  // On b acts -n where b walks, as n then points from b into a, and +n where a does: hence `sign`.
  const double damping = k * length * (stress.sum - spring.sum),
               first_moment = k * length * (stress.moment - spring.moment);
  sums.damping += -sign * damping * n;
  const Vec2& about = walker_is_b ? owner.origin : walker.origin;
  sums.damping_moment += -sign * (damping * cross(Vec2(x0 - about), n) + first_moment * cross(way, n));
  LanePair mean = c;
  if (walker.over_step != nullptr || owner.over_step != nullptr)
    mean = closing(walker.mean(), owner.mean(), edge, face, n, xs, ys);
  sums.damped += damping * mean[0] + first_moment * (mean[1] - mean[0]);
  // No pressure where the two part fast; what the damping took of the spring then is booked above.
  if (total <= 0) return;
  const Vec2 x = x0 + (stress.moment / stress.sum) * way;
  add_opposite(on_walker, walker, edge, on_owner, owner, face, x, -total * n);
  sums.force += -sign * total * n;
  sums.pressure += total;
  sums.moment_arm += total * x;
  // The edges that carry most stand for their pieces where friction is added, which acts at one point.
  double& most_walker = walker_is_b ? sums.most_b : sums.most_a;
  double& most_owner = walker_is_b ? sums.most_a : sums.most_b;
  if (total > most_walker) most_walker = total, (walker_is_b ? sums.edge_b : sums.edge_a) = edge;
  if (total > most_owner) most_owner = total, (walker_is_b ? sums.edge_a : sums.edge_b) = face;
}

/// Presses edge e where it is inside. Each turn presses it against one face, up to where the next one is nearer.
template <class K, int most, bool walker_is_b>
TRILITH_INLINE void OverlapWalk<K, most, walker_is_b>::press_edge(int e, OverlapSums& sums) const {
  const int w = e + 1 < depths.corners ? e + 1 : 0;
  const EdgeSpan span = depths.inside(e, w);
  double at = span.from, slope = std::numeric_limits<double>::infinity();
  while (at < span.to) {
    const NearestFace nearest = depths.nearest(owner_sides.surface, e, w, at, span.to, slope);
    if (nearest.face < 0) break;  // the last face of the envelope has been passed, up to rounding
    const int block = nearest.face / lane_count, lane = nearest.face % lane_count;
    const double d0 = depths.at(e, block, lane), d1 = depths.at(w, block, lane);
    const EdgeSpan pressed =
        crushed > 0 ? above(crushed, d0, d1, {at, nearest.until}) : EdgeSpan{at, nearest.until};
    const auto phi = [&](double share) { return larger(d0 + (d1 - d0) * share - crushed, 0.0); };
    if (crushed <= 0 || pressed.from < pressed.to)
      press(e, nearest.face, pressed, phi(pressed.from), phi(pressed.to), sums);
    at = nearest.until;
    slope = nearest.slope;
  }
}

/// All surface edges of the walker that no face of the owner has both ends outside of.
template <class K, int most, bool walker_is_b>
TRILITH_INLINE void OverlapWalk<K, most, walker_is_b>::run(OverlapSums& sums) const {
  std::uint64_t edges = 0;
  for (int e = 0; e < depths.corners; ++e) {
    const int w = e + 1 < depths.corners ? e + 1 : 0;
    const bool out = (depths.outside[static_cast<std::size_t>(e)] & depths.outside[static_cast<std::size_t>(w)]) != 0;
    edges |= std::uint64_t{out ? 0U : 1U} << e;
  }
  for (edges &= walker_sides.surface; edges != 0; edges &= edges - 1) press_edge(std::countr_zero(edges), sums);
}

}  // namespace trilith
