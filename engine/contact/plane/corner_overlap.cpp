#include "contact/plane/corner_overlap.hpp"

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>

#include "base/simd/registers.hpp"
#include "contact/joint/chord.hpp"
#include "contact/plane/corner_shapes.hpp"

namespace trilith {
namespace {

/// Points of pieces and their motion, as columns.
struct PieceMotions {
  Plane2 at, velocity;
  Lanes spin, chord;
  TRILITH_INLINE PieceMotions(const PlacedPiece* const* p, double dt) {
    const auto row = [&](int i) TRILITH_INLINE_LAMBDA {
      const LanePair place = load_pair(p[i]->origin.data()), rate = load_pair(p[i]->velocity.data());
      return Lanes(__builtin_shufflevector(place, rate, 0, 1, 2, 3));
    };
    const FourByFour columns(row(0), row(1), row(2), row(3));
    at = {columns.v[0], columns.v[1]}, velocity = {columns.v[2], columns.v[3]};
    spin = Lanes{p[0]->spin, p[1]->spin, p[2]->spin, p[3]->spin};
    chord = chord_rate(spin, dt);
  }
  /// Velocity of the piece's point at a world position, mean over the step.
  [[nodiscard]] TRILITH_INLINE Plane2 velocity_at(const Plane2& x) const {
    const Plane2 arm = x - at;
    return {velocity.x - spin * arm.y + chord * arm.x, velocity.y + spin * arm.x + chord * arm.y};
  }
  /// The same with present velocities.
  [[nodiscard]] TRILITH_INLINE Plane2 rigid_velocity_at(const Plane2& x) const {
    const Plane2 arm = x - at;
    return {velocity.x - spin * arm.y, velocity.y + spin * arm.x};
  }
};

/// Memory of the contacts, both halves merged.
struct RememberedFour {
  ShearBefore<Lanes> shear;
  Plane2 damping;
  Lanes damping_moment;

  TRILITH_INLINE explicit RememberedFour(const ContactMemory* const* m) {
    static_assert(offsetof(ContactMemory, shear_total) == offsetof(ContactMemory, shear_elastic) + sizeof(LanePair) &&
                  offsetof(ContactMemory, active) == offsetof(ContactMemory, damping_force) + sizeof(LanePair));
    const auto shear_of = [&](int i) TRILITH_INLINE_LAMBDA { return load_lanes(m[i]->shear_elastic); };
    const auto damping_of = [&](int i) TRILITH_INLINE_LAMBDA { return load_lanes(m[i]->damping_force); };
    const FourByFour shears(shear_of(0), shear_of(1), shear_of(2), shear_of(3)),
        others(damping_of(0), damping_of(1), damping_of(2), damping_of(3));
    shear = {shears.v[0] + shears.v[1], shears.v[2] + shears.v[3], others.v[2] + others.v[3]};
    damping = {others.v[0], others.v[1]};
    damping_moment = Lanes{m[0]->damping_moment, m[1]->damping_moment, m[2]->damping_moment, m[3]->damping_moment};
  }
};

/// A force at v and a moment about it, as forces on the two corners of an edge, one row per lane: first x and y, second
/// x and y.
TRILITH_INLINE FourByFour on_edge(const EdgeColumns& e, const Plane2& v, const Plane2& force, const Lanes& moment) {
  const Plane2 along{e.along_x, e.along_y}, from_start{v.x - e.x, v.y - e.y};
  const Lanes share = dot_of(along, from_start) / e.length2;
  const Plane2 off = from_start - share * along;
  const Lanes turn = (cross_of(off, force) + moment) / e.length2;
  const Plane2 second{share * force.x - turn * along.y, share * force.y + turn * along.x}, first = force - second;
  return {first.x, first.y, second.x, second.y};
}

TRILITH_INLINE void write_row(const Lanes& row, double* first_two, double* last_two) {
  store_pair(first_two, LanePair{row[0], row[1]});
  store_pair(last_two, LanePair{row[2], row[3]});
}

/// Results of each lane.
struct CornerAnswer {
  Plane2 force, centre, damping;  ///< on b [N], [m], [N]
  Lanes damping_moment, length, depth, lost_damping;
  HalfResponse<Lanes> shear;
};

/// The results as rows, for storage.
struct AnswerRows {
  FourByFour force_and_centre, sizes_and_losses, shears, dampings, others;
  TRILITH_INLINE explicit AnswerRows(const CornerAnswer& r)
      : force_and_centre(r.force.x, r.force.y, r.centre.x, r.centre.y),
        sizes_and_losses(r.length, r.depth, r.lost_damping + r.shear.lost_damping, r.shear.lost_friction),
        shears(0.5 * r.shear.shear_elastic, 0.5 * r.shear.shear_elastic, 0.5 * r.shear.shear_total,
               0.5 * r.shear.shear_total),
        dampings(r.damping.x, r.damping.y, 0.5 * r.length, 0.5 * r.length),
        others(r.shear.slip, r.damping_moment, r.shear.slip, r.damping_moment) {}

  TRILITH_INLINE void write(int i, const CornerCase& pair) const {
    OverlapResponse& out = *pair.out;
    write_row(force_and_centre.v[i], out.force.data(), out.centre.data());
    out.length = sizes_and_losses.v[i][0], out.depth = sizes_and_losses.v[i][1];
    out.lost_damping = sizes_and_losses.v[i][2], out.lost_friction = sizes_and_losses.v[i][3];
    out.lost_fracture = out.separation = 0, out.apart_by = -1;
    out.touching = true;
    ContactMemory& m = *pair.after;
    write_row(shears.v[i], m.shear_elastic, m.shear_total);
    write_row(dampings.v[i], m.damping_force, m.active);
    m.slip = pair.before->slip + others.v[i][0], m.damping_moment = others.v[i][1];
    m.bonds = 0, m.state = contact_touching | contact_general;
  }
};

/// Lanes in which the assumed shape is clearly valid.
template <class Shape>
TRILITH_INLINE std::uint64_t clear_lanes(const Shape& t, const PiecesOfPairs& pieces,
                                         std::span<const CornerCase> pairs) {
  std::uint64_t clear = bits_of_mask(t.clear) & ((std::uint64_t{1} << pairs.size()) - 1);
  for (std::uint64_t left = clear & pieces.many; left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    if (!t.is_nearest(i, pieces, pairs[static_cast<std::size_t>(i)].at)) clear &= ~(std::uint64_t{1} << i);
  }
  return clear;
}

/// Four pairs in lanes; unused lanes repeat the first pair. `Shape`: the shape of the overlap, Triangle or CornerPair.
template <class Shape>
TRILITH_INLINE std::uint32_t respond_four(std::span<const CornerCase> pairs, const PlainFriction& given) {
  const PlainFriction law = given;
  const PiecesOfPairs pieces(pairs);
  const Shape t{CornerEdges(pieces.of_wedge), CornerEdges(pieces.of_owner)};
  std::uint64_t sound = clear_lanes(t, pieces, pairs);
  if (sound == 0) return 0;
  const Lanes zero{}, one = all_lanes(1);
  const LaneMask wedge_is_b = mask_of_bits(pieces.wedge_is_b);
  const Lanes sign = select(wedge_is_b, one, -one);  // from the force on b to the force on the wedge
  const PieceMotions w(pieces.wedge, law.dt), o(pieces.owner, law.dt);
  RelativeMotion motion;
  motion.at_corner = w.velocity_at(t.corner) - o.velocity_at(t.corner);
  motion.spin = w.spin - o.spin, motion.chord = w.chord - o.chord;
  const WedgeSums sums = press(t, motion, law);
  const Lanes normal = sums.size;
  // If damping cancels the whole pressure of separating pieces, the general contact is used.
  const LaneMask pressed = (sums.pressure > zero) & (normal > zero);
  CornerAnswer r;
  const Plane2 direction = sign * sums.normal, along{-direction.y, direction.x}, force = normal * sums.normal;
  r.force = sign * force;
  const Plane2 arm = (1.0 / select(pressed, sums.pressure, one)) * sums.arm;
  r.centre = t.corner + arm;
  r.length = sums.length, r.depth = t.deepest();
  r.damping = sums.damping * direction;
  const Plane2 origin_a = select_point(wedge_is_b, o.at, w.at), from_a = t.corner - origin_a;
  r.damping_moment = sign * (sums.damping_moment + cross_of(from_a, sums.damping * sums.normal));
  const ContactMemory* memory[lane_count];
  for (std::size_t i = 0; i < lane_count; ++i) memory[i] = pairs[i < pairs.size() ? i : 0].before;
  const RememberedFour before(memory);
  // Damping work uses the mean of the previous and the present damping force; the previous one acts on the present
  // rigid motion of b relative to a.
  const Plane2 at_a = sign * (w.rigid_velocity_at(origin_a) - o.rigid_velocity_at(origin_a));
  const Lanes power_before = dot_of(before.damping, at_a) + before.damping_moment * (sign * motion.spin);
  r.lost_damping = (0.5 * law.dt) * (sums.power - power_before);
  HalfState<Lanes> state{};
  state.length = sums.length;
  state.slip_rate = state.slip_mean = dot_of(along, sign * motion.at(arm));
  r.shear.normal = normal;
  law.slide(state, sums.length, before.shear, r.shear);
  // Positive shear drives a along t and b against it.
  const Plane2 friction = (-sign * r.shear.shear_total) * along, whole = force + friction;
  const Lanes moment = sums.moment + cross_of(arm, friction);
  const FourByFour on_wedge = on_edge(t.before, t.corner, whole, moment),
                   on_owner = on_edge(t.face, t.corner, Plane2{} - whole, -moment);
  const AnswerRows rows(r);
  sound &= bits_of_mask(pressed);
  for (std::uint64_t left = sound; left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    const CornerCase& pair = pairs[static_cast<std::size_t>(i)];
    rows.write(i, pair);
    write_row(on_wedge.v[i], pair.push->on_wedge[0].data(), pair.push->on_wedge[1].data());
    write_row(on_owner.v[i], pair.push->on_owner[0].data(), pair.push->on_owner[1].data());
  }
  return static_cast<std::uint32_t>(sound);
}

// One copy for each register width: the same operations, so the same bits.

TRILITH_INLINE std::uint32_t respond_shapes(std::span<const CornerCase> pairs, const PlainFriction& law) {
  return pairs.front().at.both ? respond_four<CornerPair>(pairs, law) : respond_four<Triangle>(pairs, law);
}
std::uint32_t respond_narrow(std::span<const CornerCase> pairs, const PlainFriction& law) {
  return respond_shapes(pairs, law);
}
#ifdef __x86_64__
[[gnu::target("avx2")]] std::uint32_t respond_wide(std::span<const CornerCase> pairs, const PlainFriction& law) {
  return respond_shapes(pairs, law);
}
[[gnu::target("arch=x86-64-v4")]] std::uint32_t respond_widest(std::span<const CornerCase> pairs,
                                                               const PlainFriction& law) {
  return respond_shapes(pairs, law);
}
#endif

}  // namespace

std::uint32_t respond_corners(std::span<const CornerCase> pairs, const PlainFriction& law) {
  assert(!pairs.empty() && pairs.size() <= static_cast<std::size_t>(most_corner_cases));
#ifdef __x86_64__
  static const Registers here = registers_here();
  if (here == Registers::widest) return respond_widest(pairs, law);
  if (here == Registers::wide) return respond_wide(pairs, law);
#endif
  return respond_narrow(pairs, law);
}

}  // namespace trilith
