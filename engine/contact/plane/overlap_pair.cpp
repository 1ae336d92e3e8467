#include "contact/plane/overlap_pair.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "base/simd/registers.hpp"
#include "contact/plane/overlap_energy.hpp"
#include "contact/plane/overlapping.hpp"

namespace trilith {

Vec2 PlacedPiece::velocity_of_edge(int e, const Vec2& x) const {
  const int e1 = (e + 1) % static_cast<int>(corner.size());
  const Vec2 along = corner[e1] - corner[e], turning = corner_velocity[e1] - corner_velocity[e];
  const double length2 = along.squaredNorm(), share = along.dot(x - corner[e]) / length2;
  const Vec2 off = x - corner[e] - share * along;
  return corner_velocity[e] + share * turning + cross(cross(along, turning) / length2, off);
}

namespace {

TRILITH_INLINE ShearBefore<double> both_halves(const ContactMemory& m) {
  return {m.shear_elastic[0] + m.shear_elastic[1], m.shear_total[0] + m.shear_total[1], m.active[0] + m.active[1]};
}

/// Elastic shear energy released where a contact separates [J].
double released_energy(const ContactMemory& m, double ks) {
  const ShearBefore<double> both = both_halves(m);
  double kept = 0;
  return released_energy(both, 0.0, ShearCompliance<double>(both.active, 0.0, ks), kept);
}

/// Elastic shear energy released where two halves of different stress merge to one contact; never negative. T_0^2 / 2
/// ks l_0 + T_1^2 / 2 ks l_1 is at least (T_0 + T_1)^2 / 2 ks (l_0 + l_1).
TRILITH_INLINE double merging_loss(const ContactMemory& m, double ks) {
  // Halves of equal stress, as every general contact leaves them, lose nothing.
  if (m.shear_elastic[0] == m.shear_elastic[1] && m.active[0] == m.active[1]) return 0;
  double sum = 0;
  for (const int h : {0, 1}) sum += 0.5 * m.shear_elastic[h] * m.shear_elastic[h] * inverse_or_zero(ks * m.active[h]);
  const ShearBefore<double> both = both_halves(m);
  return std::max(0.0, sum - 0.5 * both.elastic * both.elastic * inverse_or_zero(ks * both.active));
}

/// Velocities of b relative to a at the centre of pressure: present, and mean over the step.
struct CentreRates {
  Vec2 now, mean;
  TRILITH_INLINE CentreRates(const PlacedPiece& a, const PlacedPiece& b, const OverlapSums& sums, const Vec2& centre,
                             double dt)
      : now(at_centre(a, b, sums, centre) + chord_of(b, centre, dt) - chord_of(a, centre, dt)),
        mean(a.over_step == nullptr && b.over_step == nullptr ? now : at_centre(a.mean(), b.mean(), sums, centre)) {}

 private:
  /// For a rigid piece after a leapfrog step; corners move straight.
  TRILITH_INLINE static Vec2 chord_of(const PlacedPiece& p, const Vec2& x, double dt) {
    if (p.over_step != nullptr || !p.corner_velocity.empty()) return Vec2::Zero();
    return chord_rate(p.spin, dt) * (x - p.origin);
  }
  TRILITH_INLINE static Vec2 at_centre(const PlacedPiece& a, const PlacedPiece& b, const OverlapSums& sums,
                                       const Vec2& centre) {
    return b.velocity_at(sums.edge_b, centre) - a.velocity_at(sums.edge_a, centre);
  }
};

/// Power of the previous damping force in the present rigid motion of b relative to a [W]. A face contact's damping
/// force acted along the normal, which is assumed to be the direction of the present force on b, at `rate`.
TRILITH_INLINE double damping_power(const PlacedPiece& a, const PlacedPiece& b, const ContactMemory& m,
                                    const Vec2& force, const Vec2& rate_now) {
  if ((m.state & contact_general) == 0) {
    const double size = force.norm();
    return size > 0 ? m.damping_force[0] * force.dot(rate_now) / size : 0;
  }
  const Vec2 rate = b.mean().velocity_at(a.origin) - a.mean().velocity_at(a.origin);
  return Vec2(m.damping_force[0], m.damping_force[1]).dot(rate) + m.damping_moment * (b.mean().spin - a.mean().spin);
}

/// Ratio of the previous damping force to the present one, where both have the same direction.
double similarity(const ContactMemory& before, const ContactMemory& now) {
  const Vec2 was(before.damping_force[0], before.damping_force[1]), is(now.damping_force[0], now.damping_force[1]);
  const double size2 = is.squaredNorm();
  return (before.state & contact_general) != 0 && size2 > 0 ? std::clamp(was.dot(is) / size2, 0.0, 1.0) : 0.0;
}

/// Energy dissipated by damping in a step: with the mean of its force before and now. The motion of deforming pieces
/// differs from the rigid one. The correction of the present force is also applied, scaled, to the previous one.
/// `rate`: mean over the step.
TRILITH_INLINE double damping_loss(const PlacedPiece& a, const PlacedPiece& b, const ContactMemory& before,
                                   const OverlapSums& sums, const Vec2& rate, double dt, const OverlapResponse& out) {
  double taken = sums.damped - damping_power(a, b, before, out.force, rate);
  if (!a.corner_velocity.empty() || !b.corner_velocity.empty())
    taken += similarity(before, out.memory) * (sums.damped + damping_power(a, b, out.memory, out.force, rate));
  return 0.5 * dt * taken;
}

/// Adds `force` at point `x` to the two corners of edge e of one piece, and the opposite force to the corners of edge f
/// of the other: same resultants, and same moments through a couple. One lane each.
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

/// Friction on the resultant, along t = left_of(n), at the centre of pressure.
template <class K>
TRILITH_INLINE void add_friction(const PlacedPiece& a, const PlacedPiece& b, const ContactMemory& before, const K& law,
                                 const OverlapSums& sums, const CentreRates& rates, std::span<Vec2> on_a,
                                 std::span<Vec2> on_b, OverlapResponse& out) {
  const double normal = sums.force;
  if (!(normal > 0)) {
    out.lost_friction += released_energy(before, law.ks);
    return;
  }
  const Vec2 t = left_of(sums.normal);
  // The law is evaluated as for one half of a face; each half then stores half of the memory, valid for two faces in
  // any step.
  HalfState<double> state{};
  state.length = sums.length;
  state.slip_rate = t.dot(rates.now);
  state.slip_mean = t.dot(rates.mean);
  state.bonded = false;
  HalfResponse<double> half{};
  half.normal = normal;
  slide_unbonded(law, state, sums.length, both_halves(before), half);
  add_opposite(on_a, a, sums.edge_a, on_b, b, sums.edge_b, out.centre, half.shear_total * t);
  for (const int h : {0, 1}) {
    out.memory.shear_elastic[h] = 0.5 * half.shear_elastic;
    out.memory.shear_total[h] = 0.5 * half.shear_total;
    out.memory.active[h] = 0.5 * sums.length;
  }
  out.memory.slip += half.slip;
  out.lost_damping += half.lost_damping;
  out.lost_friction += half.lost_friction;
}

/// Updates the crushed depth of the mortar and its dissipated energy.
template <class K>
void keep_crushed(const PlacedPiece& a, const PlacedPiece& b, const ContactMemory& before, const LawMemory<K>& own,
                  double depth, const K& law, LawMemory<K>& after, OverlapResponse& out) {
  if constexpr (K::crushes) {
    if (!(depth > 0)) return;
    const bool touched = (before.state & contact_touching) != 0, general = (before.state & contact_general) != 0;
    out.lost_fracture = law.crushed_by(own, depth, crushing_force(a, b, law.kn, depth), touched, general, after);
    out.memory.state |= contact_kept;
  }
}

/// Memory and dissipation where the two separate. The elastic shear is released, and the last damping force does work
/// for half a step more.
template <class K>
void part(const PlacedPiece& a, const PlacedPiece& b, const ContactMemory& before, const K& law, double merged,
          OverlapResponse& out) {
  out.lost_friction = merged + released_energy(before, law.ks);
  out.lost_damping = -0.5 * law.dt * damping_power(a, b, before, out.force, Vec2::Zero());
}

template <class K, int most>
TRILITH_INLINE void respond(const OverlapCase<K>& of, LawMemory<K>& after, OverlapResponse& out) {
  const PlacedPiece &a = of.a, &b = of.b;
  const ContactMemory& before = of.before;
  const K law = of.law;  // a copy that nothing written here can alias
  Overlapping<K, most> pair(of);
  out.memory.state = before.state & contact_kept;  // as ContactMemory::parted
  after = K::parted(of.own);
  const double merged = merging_loss(before, law.ks);
  if (ApartBy by; !pair.measure(by)) {
    out.separation = by.gap;
    out.apart_by = by.face;
    return part(a, b, before, law, merged, out);
  }
  if (of.alone != nullptr && (*of.alone = pair.corner_alone()).is_there()) return;
  const double crushed = pair.crushed_now(law, of.own, of.held);
  const OverlapSums sums = pair.press(law, crushed, of.on_a, of.on_b, of.along);
  if (!(sums.length > 0)) return part(a, b, before, law, merged, out);
  out.touching = true;
  out.force = of.along == nullptr ? Vec2(sums.force * sums.normal) : Vec2(0.5 * law.kn * sums.push + sums.damping);
  out.length = sums.length;
  out.depth = sums.deepest;
  out.memory.slip = before.slip;
  out.memory.state |= contact_touching | contact_general;
  out.memory.damping_force[0] = sums.damping.x();
  out.memory.damping_force[1] = sums.damping.y();
  out.memory.damping_moment = sums.damping_moment;
  if (sums.pressure > 0) out.centre = sums.moment_arm / sums.pressure;
  const CentreRates rates(a, b, sums, out.centre, law.dt);
  out.lost_damping = damping_loss(a, b, before, sums, rates.mean, law.dt, out);
  if (sums.pressure > 0) {
    out.lost_friction = merged;
    add_friction(a, b, before, law, sums, rates, of.on_a, of.on_b, out);
  } else
    out.lost_friction = merged + released_energy(before, law.ks);
  if (!(of.held > 0)) keep_crushed(a, b, before, of.own, crushed, law, after, out);
  if constexpr (K::crushes) law.wear(after);
}

// One copy for wide registers and one for any machine: the same operations, so the same bits.

template <class K, int most>
void respond_narrow(const OverlapCase<K>& of, LawMemory<K>& after, OverlapResponse& out) {
  respond<K, most>(of, after, out);
}
#ifdef __x86_64__
template <class K, int most>
[[gnu::target("avx2")]] void respond_wide(const OverlapCase<K>& of, LawMemory<K>& after, OverlapResponse& out) {
  respond<K, most>(of, after, out);
}
#endif

#ifdef __x86_64__
template <class K, int most>
[[gnu::target("arch=x86-64-v4")]] void respond_widest(const OverlapCase<K>& of, LawMemory<K>& after,
                                                      OverlapResponse& out) {
  respond<K, most>(of, after, out);
}
#endif

template <class K, int most>
void respond_as_here(const OverlapCase<K>& of, LawMemory<K>& after, OverlapResponse& out) {
#ifdef __x86_64__
  static const Registers here = registers_here();
  // Many corners are rare: a third copy for them would only enlarge the program.
  if constexpr (most == lane_count)
    if (here == Registers::widest) return respond_widest<K, most>(of, after, out);
  if (here != Registers::narrow) return respond_wide<K, most>(of, after, out);
#endif
  respond_narrow<K, most>(of, after, out);
}

/// The sides of a piece, placed in `room` if they have not been placed yet.
struct SidesRoom {
  std::array<EdgeRow, max_piece_corners> row;

  PieceSides of(const PlacedPiece& piece) {
    if (piece.sides.row != nullptr) return piece.sides;
    place_edges(piece.corner, row.data());
    return {row.data(), surface_bits(piece.is_face)};
  }
};

}  // namespace

OverlapResponse respond_overlap(const PlacedPiece& a, const PlacedPiece& b, const Remembered& before,
                                const LawInUse& law, std::span<Vec2> on_a, std::span<Vec2> on_b, double* law_after,
                                CornerOnFace* alone, const Vec2* along) {
  assert(a.corner.size() <= max_piece_corners && b.corner.size() <= max_piece_corners);
  const std::size_t corners = std::max(a.corner.size(), b.corner.size());
  SidesRoom room_a, room_b;
  const PieceSides sides_a = room_a.of(a), sides_b = room_b.of(b);
  return with_kernel(law, [&]<class K>(const K& kernel) {
    OverlapResponse out;
    LawMemory<K> after;
    const LawMemory<K> own = law_memory<K>(before.law);
    const OverlapCase<K> of{a, b, sides_a, sides_b, before.contact, own, kernel, on_a, on_b, alone, law.held, along};
    if (corners <= lane_count)
      respond_as_here<K, lane_count>(of, after, out);
    else if (corners <= 4 * lane_count)
      respond_as_here<K, 4 * lane_count>(of, after, out);
    else
      respond_as_here<K, max_piece_corners>(of, after, out);
    keep_law_memory<K>(after, law_after);
    return out;
  });
}

}  // namespace trilith
