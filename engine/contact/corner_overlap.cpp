#include "contact/corner_overlap.hpp"

#include <array>
#include <bit>
#include <cassert>

#include "base/registers.hpp"
#include "contact/overlap_depths.hpp"

namespace trilith {
namespace {

/// Where an edge crosses a face, as a share of either: nearer than this to an end is not clear.
constexpr double clear_share = 1e-9;

/// How deep a point lies below the edges of a piece, four at a time: f(first edge, depths). Lanes beyond the last edge
/// are as the first one.
template <class F>
TRILITH_INLINE void for_depths(const PlacedPiece& piece, double x, double y, F&& f) {
  const Lanes px = all_lanes(x), py = all_lanes(y);
  const int edges = static_cast<int>(piece.corner.size());
  for (int k = 0; k < edge_blocks(edges); ++k) {
    const EdgeLanes& e = piece.sides.four[k];
    f(k * lane_count, Lanes(e.nx * (e.x - px) + e.ny * (e.y - py)));
  }
}

/// Edges of a piece, as bits, but for these two.
TRILITH_INLINE std::uint64_t edges_but(const PlacedPiece& piece, int one, int other) {
  return piece.sides.surface & ~(std::uint64_t{1} << one | std::uint64_t{1} << other);
}

/// True where a point is deeper than `depth` below all `edges`.
TRILITH_INLINE bool is_deeper(const PlacedPiece& piece, double x, double y, double depth, std::uint64_t edges) {
  std::uint64_t shallow = 0;
  for_depths(piece, x, y, [&](int first, const Lanes& d) { shallow |= bits_of_mask(d <= all_lanes(depth)) << first; });
  return (shallow & edges) == 0;
}

/// Two numbers beside each other, twice, of four lanes: as columns.
struct PieceMotions {
  Lanes x, y, u, v, spin;
  TRILITH_INLINE explicit PieceMotions(const PlacedPiece* const* p) {
    const auto row = [&](int i) {
      const LanePair at = load_pair(p[i]->origin.data()), velocity = load_pair(p[i]->velocity.data());
      return __builtin_shufflevector(at, velocity, 0, 1, 2, 3);
    };
    const FourByFour columns(row(0), row(1), row(2), row(3));
    x = columns.v[0], y = columns.v[1], u = columns.v[2], v = columns.v[3];
    spin = Lanes{p[0]->spin, p[1]->spin, p[2]->spin, p[3]->spin};
  }
};

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

/// The motion of the wedge against the owner about the corner v.
struct RelativeMotion {
  Plane2 at_corner;
  Lanes spin;
  [[nodiscard]] TRILITH_INLINE Plane2 at(const Plane2& arm) const {
    return {at_corner.x - spin * arm.y, at_corner.y + spin * arm.x};
  }
};

/// The edge before that with this number, or before that corner.
TRILITH_INLINE int edge_before(const PlacedPiece& piece, int e) {
  return (e > 0 ? e : static_cast<int>(piece.corner.size())) - 1;
}

/// The two pieces of each pair, and the edges that matter: those before and after the corner of the wedge; the face of
/// the owner, which is also the edge after its corner, and the edge before that.
struct FourPairs {
  const PlacedPiece *wedge[lane_count], *owner[lane_count];
  const EdgeRow *before[lane_count], *after[lane_count], *face[lane_count], *face_before[lane_count];

  TRILITH_INLINE explicit FourPairs(std::span<const CornerCase> pairs) {
    for (std::size_t i = 0; i < lane_count; ++i) {
      const CornerCase& pair = pairs[i < pairs.size() ? i : 0];
      const CornerOnFace at = pair.at;
      wedge[i] = at.wedge_is_b ? pair.b : pair.a, owner[i] = at.wedge_is_b ? pair.a : pair.b;
      after[i] = wedge[i]->sides.row + at.corner, before[i] = wedge[i]->sides.row + edge_before(*wedge[i], at.corner);
      face[i] = owner[i]->sides.row + at.face, face_before[i] = owner[i]->sides.row + edge_before(*owner[i], at.face);
    }
  }
};

/// The triangle of every lane, about the corner v, and where it is none.
struct Triangle {
  EdgeColumns before, after, face;  ///< edges p v and v n of the wedge; the face of the owner
  Plane2 corner;                    ///< v in the world [m]
  Lanes depth, depth_b;             ///< of v below f, of B below both edges [m]
  Lanes share_before, share_after;  ///< what of both edges is below f
  Plane2 p1, p2, b;                 ///< from v [m]
  Lanes share_b;                    ///< of B on the way from P2 to P1
  LaneMask clear;

  TRILITH_INLINE explicit Triangle(const FourPairs& four)
      : before(four.before), after(four.after), face(four.face), corner{after.x, after.y} {
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
    const auto is_clear = [&](const Lanes& share) { return (share > clear_share) & (share < 1 - clear_share); };
    // How deep each end of the base lies below the edge that the other one is on.
    const Lanes below_before = -(before.nx * p2.x + before.ny * p2.y),
                below_after = -(after.nx * p1.x + after.ny * p1.y);
    clear &= is_clear(share_before) & is_clear(share_after) & is_clear(at1) & is_clear(at2) & (below_before > zero) &
             (below_after > zero);
    share_b = below_before / select(clear, below_before + below_after, one);
    depth_b = share_b * below_after;
    b = p2 + share_b * (p1 - p2);
  }
  [[nodiscard]] TRILITH_INLINE Lanes deepest() const { return larger(depth, depth_b); }
  /// In lane i no other face of the owner is as near to v, and no other edge of the wedge as near to B.
  [[nodiscard]] TRILITH_INLINE bool is_nearest(std::size_t i, const FourPairs& four, const CornerOnFace& at) const {
    const PlacedPiece &wedge = *four.wedge[i], &owner = *four.owner[i];
    return is_deeper(owner, corner.x[i], corner.y[i], depth[i], edges_but(owner, at.face, at.face)) &&
           is_deeper(wedge, corner.x[i] + b.x[i], corner.y[i] + b.y[i], depth_b[i],
                     edges_but(wedge, edge_before(wedge, at.corner), at.corner));
  }
};

/// One of the four stretches: the force over it, where it acts, and the damping part of it, along one normal.
struct PressedStretch {
  Lanes total, share;             ///< [N]; where on the way it acts
  Lanes damping, damping_moment;  ///< [N]; its first moment, over the way
  Lanes power, length;            ///< of the damping [W]; [m]

  TRILITH_INLINE PressedStretch(const Coulomb& law, const Lanes& d0, const Lanes& d1, const Lanes& c0, const Lanes& c1,
                                const Lanes& way)
      : length(way) {
    const auto [stress, spring] = law.stretch(d0, d1, c0, c1);
    const Lanes force = (0.5 * law.kn) * way, zero{};
    total = larger(force * stress.sum, zero);
    share = stress.moment / select(stress.sum > zero, stress.sum, all_lanes(1));
    damping = force * (stress.sum - spring.sum), damping_moment = force * (stress.moment - spring.moment);
    power = damping * c0 + damping_moment * (c1 - c0);
  }
};

/// Forces on the wedge and what goes with them, about v.
struct WedgeSums {
  Plane2 force{}, damping{}, arm{};  ///< [N], [N]; pressure times place [N m]
  Lanes moment{}, damping_moment{}, pressure{}, power{}, length{};

  /// A stretch that begins at `from` and goes `way`, whose force on the wedge is along `normal`.
  TRILITH_INLINE void add(const PressedStretch& s, const Plane2& normal, const Plane2& from, const Plane2& way) {
    const Plane2 at = from + s.share * way;
    force = force + s.total * normal, moment += s.total * cross_of(at, normal);
    arm = arm + s.total * at, pressure += s.total;
    damping = damping + s.damping * normal;
    damping_moment += s.damping * cross_of(from, normal) + s.damping_moment * cross_of(way, normal);
    power += s.power, length += 0.5 * s.length;
  }
};

TRILITH_INLINE WedgeSums press(const Triangle& t, const RelativeMotion& motion, const Coulomb& law) {
  const Plane2 zero{}, e{t.before.nx, t.before.ny}, g{t.after.nx, t.after.ny}, f{t.face.nx, t.face.ny};
  const Plane2 at1 = motion.at(t.p1), at2 = motion.at(t.p2), at_b = motion.at(t.b);
  const Lanes none{}, base = root(dot_of(t.p1 - t.p2, t.p1 - t.p2));
  // The wedge walks: it closes as it moves along its own normal, and is pushed back against it.
  const PressedStretch a(law, none, t.depth, dot_of(e, at1), dot_of(e, motion.at_corner),
                         t.share_before * root(t.before.length2));
  const PressedStretch b(law, t.depth, none, dot_of(g, motion.at_corner), dot_of(g, at2),
                         t.share_after * root(t.after.length2));
  // The owner walks along f: it closes as the wedge comes against its normal.
  const PressedStretch c(law, none, t.depth_b, -dot_of(f, at2), -dot_of(f, at_b), t.share_b * base);
  const PressedStretch d(law, t.depth_b, none, -dot_of(f, at_b), -dot_of(f, at1), (1.0 - t.share_b) * base);
  WedgeSums sums;
  sums.add(a, zero - e, t.p1, zero - t.p1);
  sums.add(b, zero - g, zero, t.p2);
  sums.add(c, f, t.p2, t.b - t.p2);
  sums.add(d, f, t.b, t.p1 - t.b);
  return sums;
}

/// Two edges of one piece, the walker, that meet in a corner inside the other: in through the edge `first` of that one
/// and out through `last`, the edges before and after its own corner in reverse. Up to `turn` the first of the two is
/// the nearer one, from there on the last; `turn` lies on the way to the corner where it is `early`, else beyond it.
/// Depths are linear on each of both ways:
///
///     first: 0 .. d0 at the corner .. d0_out      last: d1_in .. d1 at the corner .. 0
struct CornerChain {
  EdgeColumns before, after;
  Plane2 corner, in, out, turn;  ///< all from v [m]
  Lanes share_in, share_out;     ///< what of both edges is inside
  Lanes d0, d1, depth, on_way;   ///< [m]; [m] at `turn`; share of its way there
  LaneMask early, clear;

  /// `v`: of the wedge, in the world [m].
  TRILITH_INLINE CornerChain(const EdgeColumns& w0, const EdgeColumns& w1, const EdgeColumns& first,
                             const EdgeColumns& last, const Plane2& v)
      : before(w0), after(w1), corner{after.x - v.x, after.y - v.y} {
    const Lanes zero{}, one = all_lanes(1);
    const auto below = [](const EdgeColumns& e, const EdgeColumns& at) {
      return e.nx * (e.x - at.x) + e.ny * (e.y - at.y);
    };
    const auto along = [](const EdgeColumns& e, const EdgeColumns& way) {
      return e.nx * way.along_x + e.ny * way.along_y;
    };
    d0 = below(first, after), d1 = below(last, after);
    const Lanes d0_start = below(first, before), d1_start = below(last, before);
    const Lanes d0_end = d0 - along(first, after), d1_end = d1 - along(last, after);
    clear = (d0 > zero) & (d1 > zero) & (d0_start < zero) & (d1_end < zero);
    share_in = d0 / select(clear, d0 - d0_start, one), share_out = d1 / select(clear, d1 - d1_end, one);
    in = corner - share_in * Plane2{before.along_x, before.along_y};
    out = corner + share_out * Plane2{after.along_x, after.along_y};
    const Lanes d1_in = d1 + share_in * (d1_start - d1), d0_out = d0 + share_out * (d0_end - d0);
    const auto is_clear = [&](const Lanes& share) { return (share > clear_share) & (share < 1 - clear_share); };
    clear &= is_clear(share_in) & is_clear(share_out) & (d1_in > zero) & (d0_out > zero);
    early = d0 > d1;
    const Lanes nearer = magnitude(d0 - d1), beside = select(early, d1_in, d0_out);
    on_way = select(early, beside, nearer) / select(clear, nearer + beside, one);
    turn = select_point(early, in + on_way * (corner - in), corner + on_way * (out - corner));
    depth = select(early, on_way * d0, (1.0 - on_way) * d1);
  }
  TRILITH_INLINE static Plane2 select_point(const LaneMask& m, const Plane2& a, const Plane2& b) {
    return {select(m, a.x, b.x), select(m, a.y, b.y)};
  }
  [[nodiscard]] TRILITH_INLINE Lanes deepest() const { return larger(select(early, d1, d0), depth); }
  /// Lane i: the edges of the other piece but these two are deeper below at the corner and where it turns.
  [[nodiscard]] TRILITH_INLINE bool is_nearest(std::size_t i, const PlacedPiece& other, const Plane2& v,
                                               std::uint64_t edges) const {
    return is_deeper(other, v.x[i] + corner.x[i], v.y[i] + corner.y[i], smaller(d0[i], d1[i]), edges) &&
           is_deeper(other, v.x[i] + turn.x[i], v.y[i] + turn.y[i], depth[i], edges);
  }
  /// Its three stretches. `way` is 1.0 for the edges of the wedge, -1.0 for those of the owner.
  TRILITH_INLINE void press(const RelativeMotion& motion, const Coulomb& law, double way, WedgeSums& sums) const {
    const Lanes zero{}, one = all_lanes(1);
    const Plane2 n0{way * before.nx, way * before.ny}, n1{way * after.nx, way * after.ny},
        n = select_point(early, n0, n1);
    const Plane2 x = select_point(early, turn, corner), y = select_point(early, corner, turn);
    const Lanes at_x = select(early, depth, d0), at_y = select(early, d1, depth);
    const Lanes long_in = share_in * root(before.length2), long_out = share_out * root(after.length2);
    const Lanes rest = one - on_way;
    const Plane2 moves_x = motion.at(x), moves_y = motion.at(y), none{};
    const PressedStretch a(law, zero, at_x, dot_of(n0, motion.at(in)), dot_of(n0, moves_x),
                           long_in * select(early, on_way, one));
    const PressedStretch b(law, at_x, at_y, dot_of(n, moves_x), dot_of(n, moves_y),
                           select(early, long_in * rest, long_out * on_way));
    const PressedStretch c(law, at_y, zero, dot_of(n1, moves_y), dot_of(n1, motion.at(out)),
                           long_out * select(early, one, rest));
    // The wedge is pushed back against its normals, and where the owner walks along them.
    sums.add(a, none - n0, in, x - in);
    sums.add(b, none - n, x, y - x);
    sums.add(c, none - n1, y, out - y);
  }
};

/// One corner of each of two pieces in the other: what they share has these two corners and the two points at which
/// their edges cross. Comes in: four edges; goes out: the way of each piece through the other.
struct CornerPair {
  EdgeColumns before, after, face;  ///< of the wedge; the edge after the owner's corner
  Plane2 corner;                    ///< v of the wedge in the world [m]
  CornerChain wedge, owner;
  LaneMask clear;

  TRILITH_INLINE explicit CornerPair(const FourPairs& four) : CornerPair(four, EdgeColumns(four.face_before)) {}
  TRILITH_INLINE CornerPair(const FourPairs& four, const EdgeColumns& face_before)
      : before(four.before),
        after(four.after),
        face(four.face),
        corner{after.x, after.y},
        wedge(before, after, face, face_before, corner),
        owner(face_before, face, after, before, corner),
        clear(wedge.clear & owner.clear) {}
  [[nodiscard]] TRILITH_INLINE Lanes deepest() const { return larger(wedge.deepest(), owner.deepest()); }
  [[nodiscard]] TRILITH_INLINE bool is_nearest(std::size_t i, const FourPairs& four, const CornerOnFace& at) const {
    const PlacedPiece &w = *four.wedge[i], &o = *four.owner[i];
    return wedge.is_nearest(i, o, corner, edges_but(o, edge_before(o, at.face), at.face)) &&
           owner.is_nearest(i, w, corner, edges_but(w, edge_before(w, at.corner), at.corner));
  }
};

TRILITH_INLINE WedgeSums press(const CornerPair& t, const RelativeMotion& motion, const Coulomb& law) {
  WedgeSums sums;
  t.wedge.press(motion, law, 1.0, sums);
  t.owner.press(motion, law, -1.0, sums);
  return sums;
}

/// What four contacts remembered, both halves as one.
struct RememberedFour {
  ShearBefore<Lanes> shear;
  Plane2 damping;
  Lanes damping_moment;

  TRILITH_INLINE explicit RememberedFour(const ContactMemory* const* m) {
    for (int i = 0; i < lane_count; ++i) {
      const ContactMemory& own = *m[i];
      shear.elastic[i] = own.shear_elastic[0] + own.shear_elastic[1];
      shear.total[i] = own.shear_total[0] + own.shear_total[1];
      shear.active[i] = own.active[0] + own.active[1];
      damping.x[i] = own.damping_force[0], damping.y[i] = own.damping_force[1];
      damping_moment[i] = own.damping_moment;
    }
  }
};

/// A force at v with a moment about it, as forces on the two corners of an edge, a lane each: first x and y, second x
/// and y.
TRILITH_INLINE FourByFour on_edge(const EdgeColumns& e, const Plane2& v, const Plane2& force, const Lanes& moment) {
  const Plane2 along{e.along_x, e.along_y}, from_start{v.x - e.x, v.y - e.y};
  const Lanes share = dot_of(along, from_start) / e.length2;
  const Plane2 off = from_start - share * along;
  const Lanes turn = (cross_of(off, force) + moment) / e.length2;
  const Plane2 second{share * force.x - turn * along.y, share * force.y + turn * along.x}, first = force - second;
  return {first.x, first.y, second.x, second.y};
}

/// What every lane came to, to be written row by row.
struct CornerAnswer {
  Plane2 force, centre, damping;  ///< on b [N], [m], [N]
  Lanes damping_moment, length, depth, lost_damping;
  HalfResponse<Lanes> shear;
};

/// `on_wedge`, `on_owner`: forces on the corners of the edge before v and of the face, see on_edge().
TRILITH_INLINE void write_lane(const CornerCase& pair, const CornerAnswer& r, const Lanes& on_wedge,
                               const Lanes& on_owner, int i) {
  OverlapResponse& out = *pair.out;
  out = {};
  out.touching = true;
  out.force = {r.force.x[i], r.force.y[i]}, out.centre = {r.centre.x[i], r.centre.y[i]};
  out.length = r.length[i], out.depth = r.depth[i];
  out.lost_damping = r.lost_damping[i] + r.shear.lost_damping[i], out.lost_friction = r.shear.lost_friction[i];
  ContactMemory& m = out.memory;
  for (const int h : {0, 1}) {
    m.shear_elastic[h] = 0.5 * r.shear.shear_elastic[i], m.shear_total[h] = 0.5 * r.shear.shear_total[i];
    m.active[h] = 0.5 * r.length[i];
  }
  m.damping_force[0] = r.damping.x[i], m.damping_force[1] = r.damping.y[i];
  m.damping_moment = r.damping_moment[i];
  m.slip = pair.before->slip + r.shear.slip[i];
  m.state = contact_touching | contact_general;
  const CornerOnFace at = pair.at;
  const PlacedPiece &wedge = at.wedge_is_b ? *pair.b : *pair.a, &owner = at.wedge_is_b ? *pair.a : *pair.b;
  add_row(at.wedge_is_b ? pair.on_b : pair.on_a, wedge, edge_before(wedge, at.corner), on_wedge);
  add_row(at.wedge_is_b ? pair.on_a : pair.on_b, owner, at.face, on_owner);
}

/// Lanes in which no other edges are as near as those of the shape.
template <class Shape>
TRILITH_INLINE std::uint32_t nearest_lanes(const Shape& t, const FourPairs& four, std::span<const CornerCase> pairs) {
  std::uint32_t sound = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (t.clear[i] != 0 && t.is_nearest(i, four, pairs[i].at)) sound |= 1U << i;
  return sound;
}

/// Four pairs, a lane each; beyond the last one the first again. `Shape`: of what they share, Triangle or CornerPair.
template <class Shape>
TRILITH_INLINE std::uint32_t respond_four(std::span<const CornerCase> pairs, const Coulomb& given) {
  const Coulomb law = given;
  const FourPairs four(pairs);
  const ContactMemory* memory[lane_count];
  Lanes sign{};  // of the force on b to that on the wedge
  Plane2 a_origin;
  for (std::size_t i = 0; i < lane_count; ++i) {
    const CornerCase& pair = pairs[i < pairs.size() ? i : 0];
    memory[i] = pair.before;
    sign[i] = pair.at.wedge_is_b ? 1.0 : -1.0;
    a_origin.x[i] = pair.a->origin.x(), a_origin.y[i] = pair.a->origin.y();
  }
  const Shape t(four);
  if (!any(t.clear)) return 0;
  std::uint32_t sound = nearest_lanes(t, four, pairs);
  if (sound == 0) return 0;
  const PieceMotions w(four.wedge), o(four.owner);
  RelativeMotion motion;
  motion.at_corner = {(w.u - w.spin * (t.corner.y - w.y)) - (o.u - o.spin * (t.corner.y - o.y)),
                      (w.v + w.spin * (t.corner.x - w.x)) - (o.v + o.spin * (t.corner.x - o.x))};
  motion.spin = w.spin - o.spin;
  const WedgeSums sums = press(t, motion, law);
  const Lanes zero{}, normal = root(dot_of(sums.force, sums.force));
  // Where the damping of pieces that part takes all the pressure away, the other one says what is left.
  const LaneMask pressed = (sums.pressure > zero) & (normal > zero);
  CornerAnswer r;
  r.force = sign * sums.force;
  const Plane2 arm = (1.0 / select(pressed, sums.pressure, all_lanes(1))) * sums.arm;
  r.centre = t.corner + arm;
  r.length = sums.length, r.depth = t.deepest();
  r.damping = sign * sums.damping;
  const Plane2 from_a = t.corner - a_origin;
  r.damping_moment = sign * (sums.damping_moment + cross_of(from_a, sums.damping));
  // The mean of the damping force of before and of now does the work, the former at the motion of b against a now.
  const RememberedFour before(memory);
  const Plane2 at_a = sign * motion.at(Plane2{} - from_a);
  const Lanes power_before = dot_of(before.damping, at_a) + before.damping_moment * (sign * motion.spin);
  r.lost_damping = (0.5 * law.dt) * (sums.power - power_before);
  const Plane2 direction = (1.0 / select(pressed, normal, all_lanes(1))) * r.force, along{-direction.y, direction.x};
  HalfState<Lanes> state{};
  state.length = sums.length;
  state.slip_rate = state.slip_mean = dot_of(along, sign * motion.at(arm));
  r.shear.normal = normal;
  law.slide(state, sums.length, before.shear, r.shear);
  // Shear above 0 drives a along t and b against it.
  const Plane2 friction = (-sign * r.shear.shear_total) * along, whole = sums.force + friction;
  const Lanes moment = sums.moment + cross_of(arm, friction);
  const FourByFour on_wedge = on_edge(t.before, t.corner, whole, moment);
  const FourByFour on_owner = on_edge(t.face, t.corner, Plane2{} - whole, -moment);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (pressed[i] == 0) sound &= ~(1U << i);
    if ((sound >> i & 1U) != 0) write_lane(pairs[i], r, on_wedge.v[i], on_owner.v[i], static_cast<int>(i));
  }
  return sound;
}

// One copy for each width of registers: the same operations, so the same bits.

TRILITH_INLINE std::uint32_t respond_shapes(std::span<const CornerCase> pairs, const Coulomb& law) {
  return pairs.front().at.both ? respond_four<CornerPair>(pairs, law) : respond_four<Triangle>(pairs, law);
}
std::uint32_t respond_narrow(std::span<const CornerCase> pairs, const Coulomb& law) {
  return respond_shapes(pairs, law);
}
#ifdef __x86_64__
[[gnu::target("avx2")]] std::uint32_t respond_wide(std::span<const CornerCase> pairs, const Coulomb& law) {
  return respond_shapes(pairs, law);
}
[[gnu::target("arch=x86-64-v4")]] std::uint32_t respond_widest(std::span<const CornerCase> pairs, const Coulomb& law) {
  return respond_shapes(pairs, law);
}
#endif

}  // namespace

std::uint32_t respond_corners(std::span<const CornerCase> pairs, const Coulomb& law) {
  assert(!pairs.empty() && pairs.size() <= static_cast<std::size_t>(lane_count));
#ifdef __x86_64__
  static const Registers here = registers_here();
  if (here == Registers::widest) return respond_widest(pairs, law);
  if (here == Registers::wide) return respond_wide(pairs, law);
#endif
  return respond_narrow(pairs, law);
}

}  // namespace trilith
