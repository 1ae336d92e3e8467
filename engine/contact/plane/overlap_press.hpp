// Pressures on sections of edges inside another piece, four at once.
//
// Input: sections, the motion of both pieces, and a law. A section is a part of an edge of one piece (the walker) over
// which one face of the other (the owner) is nearest, so that its depth is linear. Output: forces at the corners of
// both, and sums. A lane is a section. Values of single sections are computed four at once. The sums are then taken
// section by section in the order of the list, so the bits do not depend on the lanes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/simd/four_by_four.hpp"
#include "contact/joint/chord.hpp"
#include "contact/plane/overlap_pair.hpp"

namespace trilith {

TRILITH_INLINE Lanes all_lanes(double v) {
  return Lanes{v, v, v, v};
}

/// A part of an edge, as relative positions.
struct EdgeSpan {
  double from, to;
};

/// Part of an edge of the walker over which its depth below one face of the owner counts.
struct alignas(32) OverlapStretch {
  EdgeSpan span;
  double d0, d1;  ///< depths of the whole edge's ends below that face [m]; read with the span as one row
  int edge, face;
  bool walker_is_b;
};

/// Sums over the pressed faces of both sides, and the forces at the corners [N].
struct OverlapSums {
  Vec2 push = Vec2::Zero();    ///< of the springs on b, over kn / 2 [m2]
  Vec2 normal = Vec2::Zero();  ///< see OverlapPress
  double force = 0;            ///< on b along `normal` [N]
  Vec2 moment_arm = Vec2::Zero();
  Vec2 damping = Vec2::Zero();  ///< damping part of the force on b
  double damping_moment = 0;    ///< its moment about a's origin
  double damped = 0;            ///< its power [W]
  double pressure = 0, length = 0, deepest = 0;
  double most_a = 0, most_b = 0;  ///< largest share of the pressure on one edge, and this edge
  int edge_a = 0, edge_b = 0;
};

/// Edges in lanes, with the vector to the start of the next one [m] and its square [m2].
struct alignas(32) EdgeColumns {
  Lanes x, y, along_x, along_y, nx, ny, length2;
  TRILITH_INLINE EdgeColumns(const EdgeLanes& e, const EdgeLanes& next)
      : x(e.x), y(e.y), along_x(next.x - e.x), along_y(next.y - e.y), nx(e.nx), ny(e.ny) {
    length2 = along_x * along_x + along_y * along_y;
  }
};

/// A force at a point and a moment about it, as forces on the two corners of an edge: same resultant, and same moment
/// through a couple. row(i): for lane i, first x and y, second x and y.
struct alignas(32) CornerForces {
  FourByFour row;
  TRILITH_INLINE CornerForces(const EdgeColumns& e, const Lanes& x, const Lanes& y, const Lanes& fx, const Lanes& fy,
                              const Lanes& moment)
      : row(of(e, x, y, fx, fy, moment)) {}

 private:
  TRILITH_INLINE static FourByFour of(const EdgeColumns& e, const Lanes& x, const Lanes& y, const Lanes& fx,
                                      const Lanes& fy, const Lanes& moment) {
    const Lanes share = (e.along_x * (x - e.x) + e.along_y * (y - e.y)) / e.length2, rest = 1.0 - share;
    const Lanes off_x = x - (e.x + share * e.along_x), off_y = y - (e.y + share * e.along_y);
    const Lanes turn = (off_x * fy - off_y * fx + moment) / e.length2;
    const Lanes couple_x = -e.along_y * turn, couple_y = e.along_x * turn;
    return {rest * fx - couple_x, rest * fy - couple_y, share * fx + couple_x, share * fy + couple_y};
  }
};

/// Four sections with their edges, a lane each. Unused lanes repeat the first section; nothing of them is added.
struct alignas(32) SectionLanes {
  const OverlapStretch* s[lane_count];
  Lanes sign;                 ///< 1 if b is the walker, -1 if a is
  EdgeColumns walker, owner;  ///< the edge of each section, and the face above it
  Lanes from, to, d0, d1;     ///< see OverlapStretch
};

/// Forces on four sections. dampings, row i: damping part of the force on b, its moment, its power; forces, row i:
/// force along n, pressure, half the length.
struct alignas(32) SectionForces {
  LaneMask presses;  ///< sections under pressure
  CornerForces on_walker, on_owner;
  FourByFour dampings, forces;
  Lanes total, arm_x, arm_y, deepest;  ///< force [N], its moment arms times it [N m], largest depth [m]
};

/// The edge after this one, or the corner at its end.
TRILITH_INLINE int edge_after(const PlacedPiece& piece, int e) {
  return e + 1 < static_cast<int>(piece.corner.size()) ? e + 1 : 0;
}

/// Adds to the corners of edge e of a piece.
TRILITH_INLINE void add_row(std::span<Vec2> on, const PlacedPiece& piece, int e, const Lanes& row) {
  const int e1 = edge_after(piece, e);
  double *first = on[e].data(), *second = on[e1].data();
  store_pair(first, load_pair(first) + LanePair{row[0], row[1]});
  store_pair(second, load_pair(second) + LanePair{row[2], row[3]});
}

/// Two pieces whose sections press each other under a law, above the crushed depth of the mortar [m].
///
/// Springs push along the normals of the walkers' edges, and in total along some n. If other pieces of the same two
/// bodies press at the same position, n is the direction of their total. The motion along n is damped. A section whose
/// push on b is along u closes at -m (n . v), with m = u . n where positive, and its damping acts on b along n with the
/// factor m. So sliding across n is not braked, and damping dissipates energy for any motion.
template <class K>
struct OverlapPress {
  const PlacedPiece &a, &b;
  const PieceSides &sides_a, &sides_b;
  const K& law;
  double crushed;
  std::span<Vec2> on_a, on_b;
  Vec2 normal = Vec2::Zero();  ///< n, unit vector

  /// Force on b of the springs of `count` sections from `list` on, over kn / 2 [m2]. Length times normal is the
  /// section's vector rotated to the right.
  [[nodiscard]] TRILITH_INLINE Vec2 springs(const OverlapStretch* list, int count) const {
    Vec2 push = Vec2::Zero();
    for (int i = 0; i < count; ++i) {
      const OverlapStretch& s = list[i];
      const EdgeRow *const rows = (s.walker_is_b ? sides_b : sides_a).row, &edge = rows[s.edge],
                           &next = rows[edge_after(s.walker_is_b ? b : a, s.edge)];
      const double phi0 = larger(s.d0 + (s.d1 - s.d0) * s.span.from - crushed, 0.0),
                   phi1 = larger(s.d0 + (s.d1 - s.d0) * s.span.to - crushed, 0.0);
      const double pressed = (s.span.to - s.span.from) * law.stretch(phi0, phi1, 0.0, 0.0).spring.sum;
      const Vec2 turned(pressed * (next.y - edge.y), pressed * (edge.x - next.x));
      push += s.walker_is_b ? Vec2(-turned) : turned;
    }
    return push;
  }

  /// `count` sections from `list` on, in groups of four.
  TRILITH_INLINE void press(const OverlapStretch* list, int count, OverlapSums& sums) const {
    for (int i = 0; i < count; i += lane_count) {
      const int some = std::min(count - i, lane_count);
      const SectionLanes on = gather(list + i, some);
      add(on, evaluate(on, some), some, sums);
    }
  }

 private:
  /// Speed along the normal at which b moves against a at points of the sections, in lanes [m/s].
  [[nodiscard]] TRILITH_INLINE Lanes speed(const PlacedPiece& p, const PlacedPiece& q, const OverlapStretch* const* s,
                                           const Lanes& x, const Lanes& y) const {
    Lanes u, v;
    if (p.corner_velocity.empty() && q.corner_velocity.empty()) {
      u = (q.velocity.x() - q.spin * (y - q.origin.y())) - (p.velocity.x() - p.spin * (y - p.origin.y()));
      v = (q.velocity.y() + q.spin * (x - q.origin.x())) - (p.velocity.y() + p.spin * (x - p.origin.x()));
      if (p.over_step == nullptr && q.over_step == nullptr) {
        const double of_q = chord_rate(q.spin, law.dt), of_p = chord_rate(p.spin, law.dt);
        u += of_q * (x - q.origin.x()) - of_p * (x - p.origin.x());
        v += of_q * (y - q.origin.y()) - of_p * (y - p.origin.y());
      }
    } else
      for (int i = 0; i < lane_count; ++i) {
        const Vec2 at(x[i], y[i]);
        const bool b_walks = s[i]->walker_is_b;
        const Vec2 w =
            q.velocity_at(b_walks ? s[i]->edge : s[i]->face, at) - p.velocity_at(b_walks ? s[i]->face : s[i]->edge, at);
        u[i] = w.x(), v[i] = w.y();
      }
    return normal.x() * u + normal.y() * v;
  }
  /// Reads 1 to 4 sections from `list` on.
  [[nodiscard]] TRILITH_INLINE SectionLanes gather(const OverlapStretch* list, int count) const;
  /// Pressures on the first `count` sections.
  [[nodiscard]] TRILITH_INLINE SectionForces evaluate(const SectionLanes& on, int count) const;
  /// Adds the sections one after another, so that the sums do not depend on their lanes.
  TRILITH_INLINE void add(const SectionLanes& on, const SectionForces& found, int count, OverlapSums& sums) const;
};

template <class K>
TRILITH_INLINE SectionLanes OverlapPress<K>::gather(const OverlapStretch* list, int count) const {
  const OverlapStretch* s[lane_count];
  const EdgeRow *walkers[lane_count], *owners[lane_count], *past_walkers[lane_count], *past_owners[lane_count];
  Lanes sign{};
  for (int i = 0; i < lane_count; ++i) {
    s[i] = &list[i < count ? i : 0];
    const bool b_walks = s[i]->walker_is_b;
    const PieceSides &walks = b_walks ? sides_b : sides_a, &owns = b_walks ? sides_a : sides_b;
    walkers[i] = walks.row + s[i]->edge, past_walkers[i] = walks.row + edge_after(b_walks ? b : a, s[i]->edge);
    owners[i] = owns.row + s[i]->face, past_owners[i] = owns.row + edge_after(b_walks ? a : b, s[i]->face);
    sign[i] = s[i]->walker_is_b ? 1.0 : -1.0;
  }
  const FourByFour parts(load_lanes(&s[0]->span.from), load_lanes(&s[1]->span.from), load_lanes(&s[2]->span.from),
                         load_lanes(&s[3]->span.from));
  return {{s[0], s[1], s[2], s[3]},
          sign,
          EdgeColumns{EdgeLanes(walkers), EdgeLanes(past_walkers)},
          EdgeColumns{EdgeLanes(owners), EdgeLanes(past_owners)},
          parts.v[0],
          parts.v[1],
          parts.v[2],
          parts.v[3]};
}

template <class K>
TRILITH_INLINE SectionForces OverlapPress<K>::evaluate(const SectionLanes& on, int count) const {
  const EdgeColumns& walker = on.walker;
  const Lanes zero{}, sign = on.sign, nx = walker.nx, ny = walker.ny;  // out of the walker, into the owner
  const Lanes x0 = walker.x + on.from * walker.along_x, y0 = walker.y + on.from * walker.along_y;
  const Lanes x1 = walker.x + on.to * walker.along_x, y1 = walker.y + on.to * walker.along_y;
  const Lanes way_x = x1 - x0, way_y = y1 - y0;
  const Lanes slope = on.d1 - on.d0, phi0 = larger(on.d0 + slope * on.from - crushed, zero),
              phi1 = larger(on.d0 + slope * on.to - crushed, zero);
  // The force on b is along -n where b walks, because n points from b into a, and along +n where a does: hence `sign`.
  const Lanes along = -sign * (normal.x() * nx + normal.y() * ny), facing = larger(along, zero);
  const auto closing = [&](const PlacedPiece& p, const PlacedPiece& q, const Lanes& x, const Lanes& y)
                           TRILITH_INLINE_LAMBDA { return Lanes(-facing * speed(p, q, on.s, x, y)); };
  // c > 0: closing. k is half of kn, and half the length counts, because the other piece's walk adds the other halves.
  const Lanes c0 = closing(a, b, x0, y0), c1 = closing(a, b, x1, y1);
  const Lanes length = root(way_x * way_x + way_y * way_y), force = (0.5 * law.kn) * length;
  const auto [stress, spring] = law.stretch(phi0, phi1, c0, c1);
  const Lanes total = force * stress.sum, elastic = force * spring.sum;
  const Lanes damping = force * (stress.sum - spring.sum), first_moment = force * (stress.moment - spring.moment);
  const Lanes along_n = facing * damping, first_along_n = facing * first_moment;
  const Lanes way_n = way_x * normal.y() - way_y * normal.x();
  const Lanes damping_moment =
      along_n * ((x0 - a.origin.x()) * normal.y() - (y0 - a.origin.y()) * normal.x()) + first_along_n * way_n;
  Lanes m0 = c0, m1 = c1;
  if (a.over_step != nullptr || b.over_step != nullptr)
    m0 = closing(a.mean(), b.mean(), x0, y0), m1 = closing(a.mean(), b.mean(), x1, y1);
  const Lanes damped = damping * m0 + first_moment * (m1 - m0);
  // No pressure where the two separate fast; the damping that cancels the spring force is accounted for above.
  const LaneMask counts = LaneMask{0, 1, 2, 3} < count, presses = counts & ~(elastic <= zero);
  // At the centre of the spring pressure; the damping has a moment about it.
  const Lanes share = spring.moment / select(presses, spring.sum, all_lanes(1));
  const Lanes x = x0 + share * way_x, y = y0 + share * way_y;
  const Lanes on_b_x = along_n * normal.x() - sign * elastic * nx, on_b_y = along_n * normal.y() - sign * elastic * ny,
              moment_on_b = (first_along_n - share * along_n) * way_n;
  const Lanes fx = sign * on_b_x, fy = sign * on_b_y, moment = sign * moment_on_b;
  const auto of = [&](const LaneMask& m, const Lanes& v) TRILITH_INLINE_LAMBDA { return select(m, v, zero); };
  const Lanes first_total = force * stress.moment;
  return {presses,
          CornerForces(walker, x, y, fx, fy, moment),
          CornerForces(on.owner, x, y, -fx, -fy, -moment),
          FourByFour(of(counts, along_n * normal.x()), of(counts, along_n * normal.y()), of(counts, damping_moment),
                     of(counts, damped)),
          FourByFour(of(presses, along * total), of(presses, total), of(counts, 0.5 * length), zero),
          total,
          total * x0 + first_total * way_x,
          total * y0 + first_total * way_y,
          larger(phi0, phi1)};
}

template <class K>
TRILITH_INLINE void OverlapPress<K>::add(const SectionLanes& on, const SectionForces& found, int count,
                                         OverlapSums& sums) const {
  Lanes sum_damping{sums.damping.x(), sums.damping.y(), sums.damping_moment, sums.damped};
  Lanes sum_force{sums.force, sums.pressure, sums.length, 0};
  for (int i = 0; i < count; ++i) {
    sum_damping += found.dampings.v[i];
    sum_force += found.forces.v[i];
    sums.deepest = larger(sums.deepest, found.deepest[i]);
    if (found.presses[i] == 0) continue;
    const OverlapStretch& stretch = *on.s[i];
    const bool b_walks = stretch.walker_is_b;
    add_row(b_walks ? on_b : on_a, b_walks ? b : a, stretch.edge, found.on_walker.row.v[i]);
    add_row(b_walks ? on_a : on_b, b_walks ? a : b, stretch.face, found.on_owner.row.v[i]);
    sums.moment_arm += Vec2(found.arm_x[i], found.arm_y[i]);
    // The edges with the largest pressure represent their pieces for friction, which acts at one point.
    const int edge_a = b_walks ? stretch.face : stretch.edge, edge_b = b_walks ? stretch.edge : stretch.face;
    if (found.total[i] > sums.most_a) sums.most_a = found.total[i], sums.edge_a = edge_a;
    if (found.total[i] > sums.most_b) sums.most_b = found.total[i], sums.edge_b = edge_b;
  }
  sums.damping = {sum_damping[0], sum_damping[1]}, sums.damping_moment = sum_damping[2], sums.damped = sum_damping[3];
  sums.force = sum_force[0], sums.pressure = sum_force[1], sums.length = sum_force[2];
}

}  // namespace trilith
