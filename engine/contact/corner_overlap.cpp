#include "contact/corner_overlap.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>

#include "base/registers.hpp"
#include "contact/corner_shapes.hpp"

namespace trilith {
namespace {

/// Lanes of the lowest bits.
template <class T>
TRILITH_INLINE Mask<T> lanes_of_bits(std::uint64_t bits) {
  Mask<T> lane;
  for (int i = 0; i < lane_count_of<T>; ++i) lane[i] = std::int64_t{1} << i;
  return ((Mask<T>{} + static_cast<std::int64_t>(bits)) & lane) != Mask<T>{};
}
/// Bit i: lane i of the mask is true.
template <class T>
TRILITH_INLINE std::uint64_t bits_of_lanes(const Mask<T>& m) {
  if constexpr (lane_count_of<T> == lane_count)
    return bits_of_mask(m);
  else
    return bits_of_mask(__builtin_shufflevector(m, m, 0, 1, 2, 3)) |
           bits_of_mask(__builtin_shufflevector(m, m, 4, 5, 6, 7)) << lane_count;
}

/// Points of pieces and how they move, as columns.
template <class T>
struct PieceMotions {
  Plane2<T> at, velocity;
  T spin;
  TRILITH_INLINE explicit PieceMotions(const PlacedPiece* const* p) {
    const RowColumns<T> columns([&](int i) {
      const LanePair place = load_pair(p[i]->origin.data()), rate = load_pair(p[i]->velocity.data());
      return Lanes(__builtin_shufflevector(place, rate, 0, 1, 2, 3));
    });
    at = {columns.v[0], columns.v[1]}, velocity = {columns.v[2], columns.v[3]};
    for (int i = 0; i < lane_count_of<T>; ++i) spin[i] = p[i]->spin;
  }
  /// Of what moves with the piece at a point of the world.
  [[nodiscard]] TRILITH_INLINE Plane2<T> velocity_at(const Plane2<T>& x) const {
    return {velocity.x - spin * (x.y - at.y), velocity.y + spin * (x.x - at.x)};
  }
};

/// What contacts remembered, both halves as one.
template <class T>
struct RememberedLanes {
  ShearBefore<T> shear;
  Plane2<T> damping;
  T damping_moment;

  TRILITH_INLINE explicit RememberedLanes(const ContactMemory* const* m) {
    const RowColumns<T> shears([&](int i) { return load_four(m[i]->shear_elastic); }),
        others([&](int i) { return load_four(m[i]->damping_force); });
    static_assert(offsetof(ContactMemory, shear_total) == offsetof(ContactMemory, shear_elastic) + sizeof(LanePair) &&
                  offsetof(ContactMemory, active) == offsetof(ContactMemory, damping_force) + sizeof(LanePair));
    shear = {shears.v[0] + shears.v[1], shears.v[2] + shears.v[3], others.v[2] + others.v[3]};
    damping = {others.v[0], others.v[1]};
    for (int i = 0; i < lane_count_of<T>; ++i) damping_moment[i] = m[i]->damping_moment;
  }
};

/// A force at v with a moment about it, as forces on the two corners of an edge, a row for each lane: first x and y,
/// second x and y.
template <class T>
TRILITH_INLINE ColumnRows<T> on_edge(const EdgeColumns<T>& e, const Plane2<T>& v, const Plane2<T>& force,
                                     const T& moment) {
  const Plane2<T> along{e.along_x, e.along_y}, from_start{v.x - e.x, v.y - e.y};
  const T share = dot_of(along, from_start) / e.length2;
  const Plane2<T> off = from_start - share * along;
  const T turn = (cross_of(off, force) + moment) / e.length2;
  const Plane2<T> second{share * force.x - turn * along.y, share * force.y + turn * along.x}, first = force - second;
  return {first.x, first.y, second.x, second.y};
}

TRILITH_INLINE void write_vectors(const Lanes& row, Vec2& first, Vec2& second) {
  store_pair(first.data(), LanePair{row[0], row[1]});
  store_pair(second.data(), LanePair{row[2], row[3]});
}

/// What every lane came to.
template <class T>
struct CornerAnswer {
  Plane2<T> force, centre, damping;  ///< on b [N], [m], [N]
  T damping_moment, length, depth, lost_damping;
  HalfResponse<T> shear;
};

/// The same, row by row, as it is written.
template <class T>
struct AnswerRows {
  ColumnRows<T> force_and_centre, sizes_and_losses, shears, dampings, others;
  TRILITH_INLINE explicit AnswerRows(const CornerAnswer<T>& r)
      : force_and_centre(r.force.x, r.force.y, r.centre.x, r.centre.y),
        sizes_and_losses(r.length, r.depth, r.lost_damping + r.shear.lost_damping, r.shear.lost_friction),
        shears(0.5 * r.shear.shear_elastic, 0.5 * r.shear.shear_elastic, 0.5 * r.shear.shear_total,
               0.5 * r.shear.shear_total),
        dampings(r.damping.x, r.damping.y, 0.5 * r.length, 0.5 * r.length),
        others(r.shear.slip, r.damping_moment, r.shear.slip, r.damping_moment) {}

  TRILITH_INLINE void write(int i, const CornerCase& pair) const {
    OverlapResponse& out = *pair.out;
    write_vectors(force_and_centre.v[i], out.force, out.centre);
    out.length = sizes_and_losses.v[i][0], out.depth = sizes_and_losses.v[i][1];
    out.lost_damping = sizes_and_losses.v[i][2], out.lost_friction = sizes_and_losses.v[i][3];
    out.lost_fracture = out.separation = 0, out.apart_by = -1;
    out.touching = true;
    ContactMemory& m = *pair.after;
    __builtin_memcpy(m.shear_elastic, &shears.v[i], sizeof shears.v[i]);
    __builtin_memcpy(m.damping_force, &dampings.v[i], sizeof dampings.v[i]);
    m.slip = pair.before->slip + others.v[i][0], m.damping_moment = others.v[i][1];
    m.bonds = 0, m.state = contact_touching | contact_general;
  }
};

/// Lanes in which the shape is clearly the one that was said.
template <class T, class Shape>
TRILITH_INLINE std::uint64_t clear_lanes(const Shape& t, const PiecesOfPairs<T>& pieces,
                                         std::span<const CornerCase> pairs) {
  std::uint64_t clear = bits_of_lanes<T>(t.clear) & ((std::uint64_t{1} << pairs.size()) - 1);
  for (std::uint64_t left = clear & pieces.many; left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    if (!t.is_nearest(i, pieces, pairs[static_cast<std::size_t>(i)].at)) clear &= ~(std::uint64_t{1} << i);
  }
  return clear;
}

/// Several pairs, a lane each; beyond the last one the first again. `Shape`: of what they share, Triangle or
/// CornerPair.
template <class T, template <class> class Shape>
TRILITH_INLINE std::uint32_t respond_lanes(std::span<const CornerCase> pairs, const Coulomb& given) {
  const Coulomb law = given;
  const PiecesOfPairs<T> pieces(pairs);
  const Shape<T> t{CornerEdges<T>(pieces.of_wedge), CornerEdges<T>(pieces.of_owner)};
  std::uint64_t sound = clear_lanes<T>(t, pieces, pairs);
  if (sound == 0) return 0;
  const T zero{}, one = all_lanes<T>(1);
  const Mask<T> wedge_is_b = lanes_of_bits<T>(pieces.wedge_is_b);
  const T sign = select(wedge_is_b, one, -one);  // of the force on b to that on the wedge
  const PieceMotions<T> w(pieces.wedge), o(pieces.owner);
  RelativeMotion<T> motion;
  motion.at_corner = w.velocity_at(t.corner) - o.velocity_at(t.corner);
  motion.spin = w.spin - o.spin;
  const WedgeSums<T> sums = press(t, motion, law);
  const T normal = root(dot_of(sums.force, sums.force));
  // Where the damping of pieces that part takes all the pressure away, the other one says what is left.
  const Mask<T> pressed = (sums.pressure > zero) & (normal > zero);
  CornerAnswer<T> r;
  r.force = sign * sums.force;
  const Plane2<T> arm = (1.0 / select(pressed, sums.pressure, one)) * sums.arm;
  r.centre = t.corner + arm;
  r.length = sums.length, r.depth = t.deepest();
  r.damping = sign * sums.damping;
  const Plane2<T> from_a = t.corner - select_point(wedge_is_b, o.at, w.at);
  r.damping_moment = sign * (sums.damping_moment + cross_of(from_a, sums.damping));
  const ContactMemory* memory[lane_count_of<T>];
  for (std::size_t i = 0; i < std::size(memory); ++i) memory[i] = pairs[i < pairs.size() ? i : 0].before;
  const RememberedLanes<T> before(memory);
  // The mean of the damping force of before and of now does the work, the former at the motion of b against a now.
  const Plane2<T> at_a = sign * motion.at(Plane2<T>{} - from_a);
  const T power_before = dot_of(before.damping, at_a) + before.damping_moment * (sign * motion.spin);
  r.lost_damping = (0.5 * law.dt) * (sums.power - power_before);
  const Plane2<T> direction = (1.0 / select(pressed, normal, one)) * r.force, along{-direction.y, direction.x};
  HalfState<T> state{};
  state.length = sums.length;
  state.slip_rate = state.slip_mean = dot_of(along, sign * motion.at(arm));
  r.shear.normal = normal;
  law.slide(state, sums.length, before.shear, r.shear);
  // Shear above 0 drives a along t and b against it.
  const Plane2<T> friction = (-sign * r.shear.shear_total) * along, whole = sums.force + friction;
  const T moment = sums.moment + cross_of(arm, friction);
  const ColumnRows<T> on_wedge = on_edge(t.before, t.corner, whole, moment),
                      on_owner = on_edge(t.face, t.corner, Plane2<T>{} - whole, -moment);
  const AnswerRows<T> rows(r);
  sound &= bits_of_lanes<T>(pressed);
  for (std::uint64_t left = sound; left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    const CornerCase& pair = pairs[static_cast<std::size_t>(i)];
    rows.write(i, pair);
    write_vectors(on_wedge.v[i], pair.push->on_wedge[0], pair.push->on_wedge[1]);
    write_vectors(on_owner.v[i], pair.push->on_owner[0], pair.push->on_owner[1]);
  }
  return static_cast<std::uint32_t>(sound);
}

// One copy for each width of registers: the same operations, so the same bits.

template <class T>
TRILITH_INLINE std::uint32_t respond_shapes(std::span<const CornerCase> pairs, const Coulomb& law) {
  return pairs.front().at.both ? respond_lanes<T, CornerPair>(pairs, law) : respond_lanes<T, Triangle>(pairs, law);
}
std::uint32_t respond_narrow(std::span<const CornerCase> pairs, const Coulomb& law) {
  return respond_shapes<Lanes>(pairs, law);
}
#ifdef __x86_64__
[[gnu::target("avx2")]] std::uint32_t respond_wide(std::span<const CornerCase> pairs, const Coulomb& law) {
  return respond_shapes<Lanes>(pairs, law);
}
[[gnu::target("arch=x86-64-v4")]] std::uint32_t respond_widest(std::span<const CornerCase> pairs, const Coulomb& law) {
  return respond_shapes<WideLanes>(pairs, law);
}
#endif

/// Four pairs at a time, where eight are too many for the registers.
template <class Respond>
std::uint32_t respond_by_fours(std::span<const CornerCase> pairs, const Coulomb& law, Respond&& respond) {
  const std::size_t first = std::min<std::size_t>(pairs.size(), lane_count);
  std::uint32_t done = respond(pairs.first(first), law);
  if (pairs.size() > first) done |= respond(pairs.subspan(first), law) << first;
  return done;
}

}  // namespace

std::uint32_t respond_corners(std::span<const CornerCase> pairs, const Coulomb& law) {
  assert(!pairs.empty() && pairs.size() <= static_cast<std::size_t>(most_corner_cases));
#ifdef __x86_64__
  static const Registers here = registers_here();
  if (here == Registers::widest) return respond_widest(pairs, law);
  if (here == Registers::wide) return respond_by_fours(pairs, law, respond_wide);
#endif
  return respond_by_fours(pairs, law, respond_narrow);
}

}  // namespace trilith
