// Overlap of two convex pieces with one corner of either inside the other, or one of both; four pairs in lanes.
//
// Input: the edges at these corners, in the present positions; the motion of the pieces; a law of pure friction.
// Output: the sections with linear pressure, the forces on the wedge about its corner v and related sums, and the lanes
// in which the shape is clearly valid. See contact/plane/corner_overlap.hpp for a sketch.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "contact/plane/corner_overlap.hpp"
#include "contact/plane/overlap_depths.hpp"

namespace trilith {

/// Limit for intersections of an edge and a face, relative to either length: closer to an end is not clearly valid.
inline constexpr double clear_share = 1e-9;

struct Plane2 {
  Lanes x, y;
  TRILITH_INLINE Plane2 operator+(const Plane2& o) const { return {x + o.x, y + o.y}; }
  TRILITH_INLINE Plane2 operator-(const Plane2& o) const { return {x - o.x, y - o.y}; }
};
TRILITH_INLINE Plane2 operator*(const Lanes& s, const Plane2& v) {
  return {s * v.x, s * v.y};
}
TRILITH_INLINE Lanes dot_of(const Plane2& a, const Plane2& b) {
  return a.x * b.x + a.y * b.y;
}
TRILITH_INLINE Lanes cross_of(const Plane2& a, const Plane2& b) {
  return a.x * b.y - a.y * b.x;
}
TRILITH_INLINE Plane2 select_point(const LaneMask& m, const Plane2& a, const Plane2& b) {
  return {select(m, a.x, b.x), select(m, a.y, b.y)};
}

/// Motion of the wedge relative to the owner about the corner v.
struct RelativeMotion {
  Plane2 at_corner;
  Lanes spin, chord;  ///< `chord`: difference of chord_rate, see contact/joint/chord.hpp
  [[nodiscard]] TRILITH_INLINE Plane2 at(const Plane2& arm) const {
    return {at_corner.x - spin * arm.y + chord * arm.x, at_corner.y + spin * arm.x + chord * arm.y};
  }
};

/// The edge before this edge or corner.
TRILITH_INLINE int edge_before(const PlacedPiece& piece, int e) {
  return (e > 0 ? e : static_cast<int>(piece.corner.size())) - 1;
}

/// Four edges of one piece of each pair: before and after a corner, the next one, and the edge before these in a piece
/// with four. In a triangle the third edge is repeated.
struct CornerRowsOf {
  const EdgeRow *before[lane_count], *after[lane_count], *next[lane_count], *far[lane_count];
  TRILITH_INLINE void set(int lane, const PlacedPiece& piece, int corner) {
    const EdgeRow* const row = piece.sides.row;
    const int one = edge_after(piece, corner);
    before[lane] = row + edge_before(piece, corner), after[lane] = row + corner;
    next[lane] = row + one, far[lane] = row + (piece.corner.size() > 3 ? edge_after(piece, one) : one);
  }
};

/// The same edges as columns.
struct CornerEdges {
  EdgeLanes before, after, next, far;
  TRILITH_INLINE explicit CornerEdges(const CornerRowsOf& e)
      : before(e.before), after(e.after), next(e.next), far(e.far) {}

  [[nodiscard]] TRILITH_INLINE EdgeColumns edge_before() const { return {before, after}; }
  [[nodiscard]] TRILITH_INLINE EdgeColumns edge_after() const { return {after, next}; }
  /// Where a world point is deeper than `depth` below the two edges that do not meet in the corner.
  [[nodiscard]] TRILITH_INLINE LaneMask is_nearer(const Plane2& at, const Lanes& depth) const {
    return ~(below(next, at) <= depth) & ~(below(far, at) <= depth);
  }
  [[nodiscard]] TRILITH_INLINE static Lanes below(const EdgeLanes& e, const Plane2& at) {
    return e.nx * (e.x - at.x) + e.ny * (e.y - at.y);
  }
};

/// Depth of a world point below the edges of a piece with many, four at a time: true where it is deeper than `depth`
/// below all but two.
TRILITH_INLINE bool is_deeper(const PlacedPiece& piece, double x, double y, double depth, int but, int and_but) {
  const Lanes px = all_lanes(x), py = all_lanes(y);
  std::uint64_t shallow = 0;
  for (int k = 0; k < edge_blocks(static_cast<int>(piece.corner.size())); ++k) {
    const EdgeLanes e(piece.sides.row + k * lane_count);
    const Lanes d = e.nx * (e.x - px) + e.ny * (e.y - py);
    shallow |= bits_of_mask(d <= all_lanes(depth)) << (k * lane_count);
  }
  return (shallow & piece.sides.surface & ~(std::uint64_t{1} << but | std::uint64_t{1} << and_but)) == 0;
}

/// The two pieces of each pair, and the relevant edges: about the corner of the wedge, and about the corner at which
/// the owner's face begins.
struct PiecesOfPairs {
  const PlacedPiece *wedge[lane_count], *owner[lane_count];
  CornerRowsOf of_wedge, of_owner;
  std::uint64_t wedge_is_b = 0;  ///< bit i: in lane i
  std::uint64_t many = 0;        ///< bit i: a piece of lane i has more than four corners

  /// Unused lanes repeat the first pair.
  TRILITH_INLINE explicit PiecesOfPairs(std::span<const CornerCase> pairs) {
    for (int i = 0; i < lane_count; ++i) {
      const CornerCase& pair = pairs[static_cast<std::size_t>(i) < pairs.size() ? static_cast<std::size_t>(i) : 0];
      const CornerOnFace at = pair.at;
      const PlacedPiece &w = at.wedge_is_b ? *pair.b : *pair.a, &o = at.wedge_is_b ? *pair.a : *pair.b;
      wedge[i] = &w, owner[i] = &o;
      of_wedge.set(i, w, at.corner), of_owner.set(i, o, at.face);
      wedge_is_b |= std::uint64_t{at.wedge_is_b ? 1U : 0U} << i;
      many |= std::uint64_t{w.corner.size() > lane_count || o.corner.size() > lane_count ? 1U : 0U} << i;
    }
  }
};

/// The triangle of each lane, about the corner v, and where it is valid.
struct Triangle {
  EdgeColumns before, after, face;  ///< edges p v and v n of the wedge; the face of the owner
  Plane2 corner;                    ///< v in world coordinates [m]
  Lanes depth, depth_b;             ///< of v below f, of B below both edges [m]
  Lanes share_before, share_after;  ///< parts of both edges below f
  Plane2 p1, p2, b;                 ///< relative to v [m]
  Lanes share_b;                    ///< position of B between P2 and P1, relative
  LaneMask clear;                   ///< the triangle is the overlap, and no other edges are as near

  TRILITH_INLINE Triangle(const CornerEdges& wedge, const CornerEdges& owner)
      : before(wedge.edge_before()), after(wedge.edge_after()), face(owner.edge_after()), corner{after.x, after.y} {
    const Lanes zero{}, one = all_lanes(1);
    depth = face.nx * (face.x - corner.x) + face.ny * (face.y - corner.y);
    const Lanes out_before = face.nx * (face.x - before.x) + face.ny * (face.y - before.y);
    const Lanes out_after = depth - (face.nx * after.along_x + face.ny * after.along_y);
    clear = (depth > zero) & (out_before < zero) & (out_after < zero);
    share_before = depth / select(clear, depth - out_before, one);
    share_after = depth / select(clear, depth - out_after, one);
    p1 = -share_before * Plane2{before.along_x, before.along_y};
    p2 = share_after * Plane2{after.along_x, after.along_y};
    const Plane2 from_start{corner.x - face.x, corner.y - face.y}, along{face.along_x, face.along_y};
    const Lanes at1 = dot_of(from_start + p1, along) / face.length2,
                at2 = dot_of(from_start + p2, along) / face.length2;
    const auto is_clear = [&](const Lanes& share)
                              TRILITH_INLINE_LAMBDA { return (share > clear_share) & (share < 1 - clear_share); };
    // Depth of each end of the base below the edge through the other end.
    const Lanes below_before = -(before.nx * p2.x + before.ny * p2.y),
                below_after = -(after.nx * p1.x + after.ny * p1.y);
    clear &= is_clear(share_before) & is_clear(share_after) & is_clear(at1) & is_clear(at2) & (below_before > zero) &
             (below_after > zero);
    share_b = below_before / select(clear, below_before + below_after, one);
    depth_b = share_b * below_after;
    b = p2 + share_b * (p1 - p2);
    // No other face of the owner is as near to v, and no other edge of the wedge as near to B.
    clear &= ~(owner.below(owner.before, corner) <= depth) & owner.is_nearer(corner, depth) &
             wedge.is_nearer(corner + b, depth_b);
  }
  [[nodiscard]] TRILITH_INLINE Lanes deepest() const { return larger(depth, depth_b); }
  /// The last two conditions for pieces with many edges.
  [[nodiscard]] TRILITH_INLINE bool is_nearest(int i, const PiecesOfPairs& pairs, const CornerOnFace& at) const {
    const PlacedPiece &wedge = *pairs.wedge[i], &owner = *pairs.owner[i];
    return is_deeper(owner, corner.x[i], corner.y[i], depth[i], at.face, at.face) &&
           is_deeper(wedge, corner.x[i] + b.x[i], corner.y[i] + b.y[i], depth_b[i], edge_before(wedge, at.corner),
                     at.corner);
  }
};

/// A section of an edge under pressure. It begins at `from` and extends along `way`, both relative to v [m], pushes the
/// wedge along `push`, and has the depths d0 at its start and d1 at its end [m].
struct alignas(32) DeepStretch {
  Plane2 push, from, way;
  Lanes d0, d1, length;

  /// Mean depth times length, along its push: the force of its springs over kn.
  [[nodiscard]] TRILITH_INLINE Plane2 springs() const { return (0.5 * length * (d0 + d1)) * push; }
};

/// Forces on the wedge and related sums, about v. Springs push along the normals of their edges, and in total along
/// `normal`; all dampings act along `normal`.
struct alignas(32) WedgeSums {
  Plane2 normal;                              ///< unit vector
  Lanes size{}, damping{};                    ///< of the force along `normal`, and its damping part [N]
  Lanes moment{}, damping_moment{}, power{};  ///< [N m], its damping part [N m], power of that [W]
  Lanes pressure{}, length{};                 ///< magnitude in any direction [N]; [m]
  Plane2 arm{};                               ///< pressure times position [N m]

  TRILITH_INLINE explicit WedgeSums(const Plane2& n) : normal(n) {}

  /// m is the component of the push along the normal n. The section closes at -m (n . v), and its damping acts along n
  /// with the factor m.
  TRILITH_INLINE void add(const PlainFriction& law, const RelativeMotion& motion, const DeepStretch& s) {
    const Lanes along = dot_of(normal, s.push), facing = larger(along, Lanes{});
    const Lanes c0 = -facing * dot_of(normal, motion.at(s.from)),
                c1 = -facing * dot_of(normal, motion.at(s.from + s.way));
    const auto [stress, spring] = law.stretch(s.d0, s.d1, c0, c1);
    const Lanes force = (0.5 * law.kn) * s.length, total = force * stress.sum, first = force * stress.moment;
    const Lanes damped = force * (stress.sum - spring.sum), damped_first = force * (stress.moment - spring.moment);
    size += along * total, damping += facing * damped;
    const Lanes turning = facing * (damped * cross_of(s.from, normal) + damped_first * cross_of(s.way, normal));
    moment += force * (spring.sum * cross_of(s.from, s.push) + spring.moment * cross_of(s.way, s.push)) + turning;
    damping_moment += turning, power += damped * c0 + damped_first * (c1 - c0);
    pressure += total, arm = arm + total * s.from + first * s.way;
    length += 0.5 * s.length;
  }
};

/// The elastic force is along the normal of the single face f, because motion along the face does not change it.
TRILITH_INLINE WedgeSums press(const Triangle& t, const RelativeMotion& motion, const PlainFriction& law) {
  const Plane2 zero{}, e{t.before.nx, t.before.ny}, g{t.after.nx, t.after.ny}, f{t.face.nx, t.face.ny};
  const Lanes none{}, base = root(dot_of(t.p1 - t.p2, t.p1 - t.p2));
  WedgeSums sums(f);
  // Sections on the wedge's edges push it back along their normals; sections on the owner's face push along the face's
  // normal.
  sums.add(law, motion, {zero - e, t.p1, zero - t.p1, none, t.depth, t.share_before * root(t.before.length2)});
  sums.add(law, motion, {zero - g, zero, t.p2, t.depth, none, t.share_after * root(t.after.length2)});
  sums.add(law, motion, {f, t.p2, t.b - t.p2, none, t.depth_b, t.share_b * base});
  sums.add(law, motion, {f, t.b, t.p1 - t.b, t.depth_b, none, (1.0 - t.share_b) * base});
  return sums;
}

/// Two edges of one piece, the walker, that meet in a corner inside the other. They enter through the edge `first` of
/// the other piece and leave through `last`, its edges before and after its own corner in reverse. Up to `turn` the
/// edge `first` is nearer, beyond it `last`. The point `turn` is before the corner if it is `early`, otherwise after
/// it. Depths are linear on both parts:
///
///     first: 0 .. d0 at the corner .. d0_out      last: d1_in .. d1 at the corner .. 0.
struct CornerChain {
  EdgeColumns before, after;
  Plane2 corner, in, out, turn;  ///< all relative to v [m]
  Lanes share_in, share_out;     ///< parts of both edges inside
  Lanes d0, d1, depth, on_way;   ///< [m]; [m] at `turn`; its relative position
  LaneMask early, clear;

  /// `v`: of the wedge, in world coordinates [m].
  TRILITH_INLINE CornerChain(const EdgeColumns& w0, const EdgeColumns& w1, const EdgeColumns& first,
                             const EdgeColumns& last, const Plane2& v)
      : before(w0), after(w1), corner{after.x - v.x, after.y - v.y} {
    const Lanes zero{}, one = all_lanes(1);
    const auto below = [](const EdgeColumns& e, const EdgeColumns& at)
                           TRILITH_INLINE_LAMBDA { return e.nx * (e.x - at.x) + e.ny * (e.y - at.y); };
    const auto along = [](const EdgeColumns& e, const EdgeColumns& way)
                           TRILITH_INLINE_LAMBDA { return e.nx * way.along_x + e.ny * way.along_y; };
    d0 = below(first, after), d1 = below(last, after);
    const Lanes d0_start = below(first, before), d1_start = below(last, before);
    const Lanes d0_end = d0 - along(first, after), d1_end = d1 - along(last, after);
    clear = (d0 > zero) & (d1 > zero) & (d0_start < zero) & (d1_end < zero);
    share_in = d0 / select(clear, d0 - d0_start, one), share_out = d1 / select(clear, d1 - d1_end, one);
    in = corner - share_in * Plane2{before.along_x, before.along_y};
    out = corner + share_out * Plane2{after.along_x, after.along_y};
    const Lanes d1_in = d1 + share_in * (d1_start - d1), d0_out = d0 + share_out * (d0_end - d0);
    const auto is_clear = [&](const Lanes& share)
                              TRILITH_INLINE_LAMBDA { return (share > clear_share) & (share < 1 - clear_share); };
    clear &= is_clear(share_in) & is_clear(share_out) & (d1_in > zero) & (d0_out > zero);
    early = d0 > d1;
    const Lanes nearer = magnitude(d0 - d1), beside = select(early, d1_in, d0_out);
    on_way = select(early, beside, nearer) / select(clear, nearer + beside, one);
    turn = select_point(early, in + on_way * (corner - in), corner + on_way * (out - corner));
    depth = select(early, on_way * d0, (1.0 - on_way) * d1);
  }
  [[nodiscard]] TRILITH_INLINE Lanes deepest() const { return larger(select(early, d1, d0), depth); }
  /// Where all other edges of the other piece are deeper at the corner and at `turn`.
  [[nodiscard]] TRILITH_INLINE LaneMask are_nearest(const CornerEdges& other, const Plane2& v) const {
    return other.is_nearer(v + corner, smaller(d0, d1)) & other.is_nearer(v + turn, depth);
  }
  /// For lane i and all edges of a piece with many; `at`: the corner of the other piece.
  [[nodiscard]] TRILITH_INLINE bool is_nearest(int i, const PlacedPiece& other, int at, const Plane2& v) const {
    const int before_it = edge_before(other, at);
    return is_deeper(other, v.x[i] + corner.x[i], v.y[i] + corner.y[i], smaller(d0[i], d1[i]), before_it, at) &&
           is_deeper(other, v.x[i] + turn.x[i], v.y[i] + turn.y[i], depth[i], before_it, at);
  }
  /// Its three sections. `way` is 1.0 for edges of the wedge, -1.0 for edges of the owner, which push the wedge along
  /// their normals.
  [[nodiscard]] TRILITH_INLINE std::array<DeepStretch, 3> stretches(double way) const {
    const Lanes zero{}, one = all_lanes(1);
    const Plane2 n0{-way * before.nx, -way * before.ny}, n1{-way * after.nx, -way * after.ny};
    const Plane2 x = select_point(early, turn, corner), y = select_point(early, corner, turn);
    const Lanes at_x = select(early, depth, d0), at_y = select(early, d1, depth);
    const Lanes long_in = share_in * root(before.length2), long_out = share_out * root(after.length2);
    const Lanes rest = one - on_way;
    return {{{n0, in, x - in, zero, at_x, long_in * select(early, on_way, one)},
             {select_point(early, n0, n1), x, y - x, at_x, at_y, select(early, long_in * rest, long_out * on_way)},
             {n1, y, out - y, at_y, zero, long_out * select(early, one, rest)}}};
  }
};

/// One corner of each of two pieces inside the other: the overlap has these two corners and the two intersections of
/// edges. Input: four edges; output: the path of each piece through the other.
struct CornerPair {
  EdgeColumns before, after, face;  ///< of the wedge; the edge after the owner's corner
  Plane2 corner;                    ///< v of the wedge in world coordinates [m]
  CornerChain wedge, owner;
  LaneMask clear;  ///< see Triangle

  TRILITH_INLINE CornerPair(const CornerEdges& w, const CornerEdges& o)
      : CornerPair(w.edge_before(), w.edge_after(), o.edge_before(), o.edge_after()) {
    clear &= wedge.are_nearest(o, corner) & owner.are_nearest(w, corner);
  }
  [[nodiscard]] TRILITH_INLINE Lanes deepest() const { return larger(wedge.deepest(), owner.deepest()); }
  /// See Triangle.
  [[nodiscard]] TRILITH_INLINE bool is_nearest(int i, const PiecesOfPairs& pairs, const CornerOnFace& at) const {
    return wedge.is_nearest(i, *pairs.owner[i], at.face, corner) &&
           owner.is_nearest(i, *pairs.wedge[i], at.corner, corner);
  }

 private:
  TRILITH_INLINE CornerPair(const EdgeColumns& w0, const EdgeColumns& w1, const EdgeColumns& o0, const EdgeColumns& o1)
      : before(w0),
        after(w1),
        face(o1),
        corner{after.x, after.y},
        wedge(w0, w1, o1, o0, corner),
        owner(o0, o1, w1, w0, corner),
        clear(wedge.clear & owner.clear) {}
};

TRILITH_INLINE WedgeSums press(const CornerPair& t, const RelativeMotion& motion, const PlainFriction& law) {
  const auto of_wedge = t.wedge.stretches(1.0), of_owner = t.owner.stretches(-1.0);
  Plane2 push{};
  for (const auto* chain : {&of_wedge, &of_owner})
    for (const DeepStretch& s : *chain) push = push + s.springs();
  const Lanes size = root(dot_of(push, push));
  WedgeSums sums((1.0 / select(size > Lanes{}, size, all_lanes(1))) * push);
  for (const auto* chain : {&of_wedge, &of_owner})
    for (const DeepStretch& s : *chain) sums.add(law, motion, s);
  return sums;
}

}  // namespace trilith
