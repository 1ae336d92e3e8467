#include "contact/corner_overlap.hpp"

#include <cassert>

#include "base/registers.hpp"
#include "contact/corner_shapes.hpp"

namespace trilith {
namespace {

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
