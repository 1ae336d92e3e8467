// Stress spread over the overlap of two faces that look at each other: exact for a linear overlap.
//
// A's face runs from a.0 to a.1, B's from b.0 to b.1, each counter-clockwise around its own body, so they run
// against each other. d is their common direction, n = -left_of(d) points from A to B. Over the shared length
// [lo, hi] the gap g(s) is linear; where closed, sigma(s) = kn (-g - beta dg/dt), clipped at 0 where no bond holds.
// The shared length is cut into two halves that keep their own shear history and bond (ContactMemory).
// Forces at the face ends have the resultant, the moment and the power of the stresses (rigid or linear faces).
//
// Written over T = double or Lanes. Source: Barbosa, "Discontinuous structural analysis", eqs. 3 to 5.
#pragma once

#include "base/lanes.hpp"
#include "contact/face_overlap.hpp"

namespace trilith {

/// A contact law's numbers times the thickness, and the step.
struct FaceLaw {
  double kn, ks;             ///< [N/m per m of length]
  double mu, beta;           ///< [1], [s]
  double cohesion, tension;  ///< [N per m of length]
  double dt;                 ///< [s]
  bool loss_by_point;
};

/// ContactMemory, lane by lane.
template <class T>
struct FaceMemory {
  T shear_elastic[2], shear_total[2], damping_force[2], active[2], slip;
  Mask<T> bonds[2];
  Mask<T> general{};  ///< the last step found the contact by overlap: the halves share one shear force
};

template <class T>
struct FaceResponse {
  T ax0, ay0, ax1, ay1, bx0, by0, bx1, by1;  ///< forces at the face ends [N]
  FaceMemory<T> memory;
  T lost_damping, lost_friction, lost_fracture;  ///< energy given off in this step [J]
  Mask<T> is_face_pair;                          ///< false: nothing above holds, the shape is general
  Mask<T> touching;
};

/// Linear stress p over [l0, l1] of a half, in shares of the half: its integral and first moment.
template <class T>
struct LinearStress {
  T sum, moment;
  TRILITH_INLINE LinearStress(T p0, T p1, T l0, T l1) {
    const T width = l1 - l0;
    sum = 0.5 * width * (p0 + p1);
    moment = width * (p0 * (2.0 * l0 + l1) + p1 * (l0 + 2.0 * l1)) * (1.0 / 6.0);
  }
};

/// The part of [0, 1] where a linear function from f0 to f1 is positive; empty as from == to.
template <class T>
struct PositivePart {
  T from, to;
  TRILITH_INLINE PositivePart(T f0, T f1) {
    const T zero{}, one = zero + 1.0;
    const T fall = f0 - f1;
    const T root_at = smaller(larger(f0 / select(fall == zero, one, fall), zero), one);
    from = select(f0 > zero, zero, root_at);
    to = select(f1 > zero, one, root_at);
    to = larger(from, to);
    const Mask<T> none = (f0 <= zero) & (f1 <= zero);
    to = select(none, from, to);
  }
};

/// What one half of the shared length carries.
template <class T>
struct HalfResponse {
  T normal, normal_moment;    ///< N, and its first moment about the half's start [N], [N m]
  T damping, damping_moment;  ///< the damping part of both
  T shear_elastic, shear_total, slip, active;
  T lost_damping, lost_friction;
};

template <class T>
struct HalfState {
  T g0, g1;     ///< gap at both ends [m], negative where overlapping
  T r0, r1;     ///< gap rate at both ends [m/s]
  T slip_rate;  ///< of B along d, at the middle [m/s]
  T length;     ///< [m]
  Mask<T> bonded;
};

/// True where a bonded half is beyond its tensile or shear limit (elastic stresses, trial shear).
template <class T>
TRILITH_INLINE Mask<T> bond_broken(const HalfState<T>& h, T shear_elastic, const FaceLaw& law) {
  const T widest = larger(h.g0, h.g1);
  const T trial = magnitude(shear_elastic + law.ks * h.length * h.slip_rate * law.dt);
  const T strength = law.cohesion - law.mu * law.kn * widest;
  return h.bonded & ((law.kn * widest > law.tension + T{}) | (trial > strength * h.length));
}

/// The part of the shared length where a linear function is positive, as shares of both halves.
template <class T>
struct PositiveHalves {
  T from[2], to[2];
  TRILITH_INLINE PositiveHalves(T f_lo, T f_hi) {
    const T zero{}, one = zero + 1.0;
    const PositivePart<T> whole(f_lo, f_hi);
    const T from2 = whole.from + whole.from, to2 = whole.to + whole.to;
    from[0] = smaller(from2, one), to[0] = smaller(to2, one);
    from[1] = larger(from2 - one, zero), to[1] = larger(to2 - one, zero);
  }
};

/// Normal stresses of both halves: where closed, or all along where bonded; never pulling without a bond. `active`:
/// the share of each half that carries stress.
template <class T>
TRILITH_INLINE void respond_normal(const HalfState<T>* halves, const FaceLaw& law, T* active, HalfResponse<T>* out) {
  const T zero{}, one = zero + 1.0;
  const HalfState<T>&first = halves[0], &second = halves[1];
  PositiveHalves<T> closed(-first.g0, -second.g1);
  PositiveHalves<T> pressed(-first.g0 - law.beta * first.r0, -second.g1 - law.beta * second.r1);
  for (const int h : {0, 1}) {
    const HalfState<T>& half = halves[h];
    const T c0 = -half.g0, q0 = c0 - law.beta * half.r0, q1 = -half.g1 - law.beta * half.r1;
    const T closed_from = select(half.bonded, zero, closed.from[h]), closed_to = select(half.bonded, one, closed.to[h]);
    const T from = select(half.bonded, zero, larger(pressed.from[h], closed_from));
    const T to = select(half.bonded, one, larger(from, smaller(pressed.to[h], closed_to)));
    const T dc = half.g0 - half.g1, dq = q1 - q0;
    const LinearStress<T> elastic(c0 + dc * closed_from, c0 + dc * closed_to, closed_from, closed_to);
    const LinearStress<T> total(q0 + dq * from, q0 + dq * to, from, to);
    const T scale = law.kn * half.length;
    active[h] = closed_to - closed_from;
    out[h].normal = scale * total.sum;
    out[h].normal_moment = scale * half.length * total.moment;
    out[h].damping = out[h].normal - scale * elastic.sum;
    out[h].damping_moment = out[h].normal_moment - scale * half.length * elastic.moment;
  }
}

/// Lengths up to this carry no shear: so short that their squares would vanish [m].
inline constexpr double shortest_length = 1e-100;

/// What a half remembered of its shear.
template <class T>
struct ShearBefore {
  T elastic, total, active;  ///< [N], [N], [m]
};

/// 1/v where v is above 0, else 0.
template <class T>
TRILITH_INLINE T inverse_or_zero(T v) {
  const T zero{}, one = zero + 1.0;
  const Mask<T> positive = v > zero;
  return select(positive, one / select(positive, v, one), zero);
}

/// Compliances of the lengths that carry shear, before and now [m/N]; 0 where there is none.
template <class T>
struct ShearCompliance {
  T before, now;
  TRILITH_INLINE ShearCompliance(T length_before, T length, double ks) {
    const T zero{}, one = zero + 1.0;
    const Mask<T> had = length_before > shortest_length, has = length > shortest_length;
    const T b = select(had, length_before, one), a = select(has, length, one);
    const T inverse = (ks > 0 ? 1.0 / ks : 0.0) / (b * a);  // one division for both
    before = select(had, a * inverse, zero);
    now = select(has, b * inverse, zero);
  }
};

/// Elastic shear energy let go because the length in contact changed to one of the given stiffness: length that parts
/// takes its share of the force along, new length carries none. `kept`: the force left. Never negative.
template <class T>
TRILITH_INLINE T let_go(const ShearBefore<T>& before, T stiffness, const ShearCompliance<T>& compliance, T& kept) {
  const T one = T{} + 1.0;
  kept = before.elastic * smaller(one, stiffness * compliance.before);
  return 0.5 * (before.elastic * before.elastic * compliance.before - kept * kept * compliance.now);
}

/// Kelvin-Voigt spring in series with a Coulomb slider; the damping acts on the elastic part only. `active`: length
/// that carries shear [m].
template <class T>
TRILITH_INLINE void respond_shear(const HalfState<T>& h, const FaceLaw& law, T active, const ShearBefore<T>& before,
                                  HalfResponse<T>& out) {
  const T zero{};
  const T stiffness = law.ks * active;
  const ShearCompliance<T> compliance(before.active, active, law.ks);
  T kept;
  const T relaxed = let_go(before, stiffness, compliance, kept);
  const T move = h.slip_rate * law.dt;
  const T trial = kept + stiffness * move;
  const T trial_total = trial + law.beta * stiffness * h.slip_rate;
  const T limit = select(h.bonded, zero + 1e300, law.mu * larger(out.normal, zero));
  const Mask<T> slides = magnitude(trial_total) > limit;
  const T held = select(trial_total < zero, -limit, limit);
  const double share = law.dt > 0 ? law.dt / (law.dt + law.beta) : 0.0;
  const T slid = kept + (held - kept) * share;
  const Mask<T> open = active <= shortest_length;
  out.shear_elastic = select(open, zero, select(slides, slid, trial));
  out.shear_total = select(open, zero, select(slides, held, trial_total));
  const T stretch = select(slides, (out.shear_elastic - kept) * compliance.now, move);
  const T slip = select(open, zero, move - stretch);
  const T mean_total = 0.5 * (out.shear_total + before.total);
  const T mean_elastic = 0.5 * (out.shear_elastic + before.elastic);
  const T parted = select(open, zero, 0.5 * (before.elastic - kept) * stretch);
  out.slip = magnitude(slip);
  out.active = active;
  out.lost_friction = mean_total * slip + relaxed + parted;
  out.lost_damping = select(open, zero, (mean_total - mean_elastic) * stretch);
}

template <class T>
TRILITH_INLINE T fracture_energy(const HalfState<T>& h, const FaceLaw& law, Mask<T> lost) {
  const T zero{};
  const T o0 = larger(h.g0, zero), o1 = larger(h.g1, zero);
  const T stored = law.kn * h.length * (o0 * o0 + o0 * o1 + o1 * o1) * (1.0 / 6.0);
  return select(lost, stored, zero);
}

/// Rates along the shared length: gap, and slip of B against A, at both of its ends [m/s].
template <class T>
struct FaceRates {
  T gap_lo, gap_hi, slip_lo, slip_hi;
  T turning;  ///< of B against A: slope of the gap rate [rad/s]
  FaceRates() = default;
  TRILITH_INLINE FaceRates(const FaceOverlap<T>& o, const FaceEnds<T>& a, const FaceEnds<T>& b) {
    const T na0 = o.dy * a.u0 - o.dx * a.v0, na1 = o.dy * a.u1 - o.dx * a.v1;
    const T nb0 = o.dy * b.u0 - o.dx * b.v0, nb1 = o.dy * b.u1 - o.dx * b.v1;
    const T ta0 = o.dx * a.u0 + o.dy * a.v0, ta1 = o.dx * a.u1 + o.dy * a.v1;
    const T tb0 = o.dx * b.u0 + o.dy * b.v0, tb1 = o.dx * b.u1 + o.dy * b.v1;
    const T spin_a = (na1 - na0) * o.inv_a, spin_b = (nb0 - nb1) * o.inv_b;
    const T stretch_a = (ta1 - ta0) * o.inv_a, stretch_b = (tb0 - tb1) * o.inv_b;
    const T lo_b = o.lo - o.sb1, hi_b = o.hi - o.sb1;
    turning = spin_b - spin_a;
    gap_lo = nb1 + spin_b * lo_b - na0 - spin_a * o.lo;
    gap_hi = nb1 + spin_b * hi_b - na0 - spin_a * o.hi;
    // At mid-gap, where the shear acts: so a spin that both share slips nothing.
    const T spin = 0.5 * (spin_a + spin_b);
    slip_lo = tb1 + stretch_b * lo_b - ta0 - stretch_a * o.lo + spin * o.gap_lo;
    slip_hi = tb1 + stretch_b * hi_b - ta0 - stretch_a * o.hi + spin * o.gap_hi;
  }
};

/// The two halves of the shared length.
template <class T>
struct FaceHalves {
  HalfState<T> half[2];
  TRILITH_INLINE FaceHalves(const FaceOverlap<T>& o, const FaceRates<T>& r, const FaceMemory<T>& m) {
    const T gap = 0.5 * (o.gap_lo + o.gap_hi), rate = 0.5 * (r.gap_lo + r.gap_hi), length = 0.5 * o.shared;
    half[0] = {o.gap_lo, gap, r.gap_lo, rate, 0.75 * r.slip_lo + 0.25 * r.slip_hi, length, m.bonds[0]};
    half[1] = {gap, o.gap_hi, rate, r.gap_hi, 0.25 * r.slip_lo + 0.75 * r.slip_hi, length, m.bonds[1]};
  }
};

/// Takes the bonds that are beyond their limit; returns the energy they gave off [J].
template <class T>
TRILITH_INLINE T lose_bonds(FaceHalves<T>& h, const FaceMemory<T>& before, const FaceLaw& law) {
  Mask<T> lost0 = bond_broken(h.half[0], before.shear_elastic[0], law);
  Mask<T> lost1 = bond_broken(h.half[1], before.shear_elastic[1], law);
  if (!law.loss_by_point) {
    const Mask<T> any = lost0 | lost1;
    lost0 = h.half[0].bonded & any;
    lost1 = h.half[1].bonded & any;
  }
  h.half[0].bonded = h.half[0].bonded & flip(lost0);
  h.half[1].bonded = h.half[1].bonded & flip(lost1);
  return fracture_energy(h.half[0], law, lost0) + fracture_energy(h.half[1], law, lost1);
}

/// Forces at the four face ends from the stresses of both halves: same resultant, moment and power. The couple
/// moves the shear to mid-gap, so that both bodies feel it along one line and angular momentum is kept.
template <class T>
TRILITH_INLINE void spread_to_ends(const FaceOverlap<T>& o, const HalfResponse<T>& s0, const HalfResponse<T>& s1,
                                   FaceResponse<T>& out) {
  const T half = 0.5 * o.shared, gap_mid = 0.5 * (o.gap_lo + o.gap_hi);
  const T normal = s0.normal + s1.normal;
  const T normal_moment = s0.normal_moment + s1.normal_moment + o.lo * s0.normal + (o.lo + half) * s1.normal;
  const T shear = s0.shear_total + s1.shear_total;
  const T at0 = o.lo + 0.5 * half, at1 = at0 + half;
  const T shear_moment = s0.shear_total * at0 + s1.shear_total * at1;
  const T couple = 0.25 * (s0.shear_total * (o.gap_lo + gap_mid) + s1.shear_total * (gap_mid + o.gap_hi));
  const T na1 = -(normal_moment + couple) * o.inv_a, na0 = -normal - na1;
  const T ta1 = shear_moment * o.inv_a, ta0 = shear - ta1;
  const T nb0 = (normal_moment - normal * o.sb1 - couple) * o.inv_b, nb1 = normal - nb0;
  const T tb0 = -(shear_moment - shear * o.sb1) * o.inv_b, tb1 = -shear - tb0;
  out.ax0 = na0 * o.dy + ta0 * o.dx;
  out.ay0 = ta0 * o.dy - na0 * o.dx;
  out.ax1 = na1 * o.dy + ta1 * o.dx;
  out.ay1 = ta1 * o.dy - na1 * o.dx;
  out.bx0 = nb0 * o.dy + tb0 * o.dx;
  out.by0 = tb0 * o.dy - nb0 * o.dx;
  out.bx1 = nb1 * o.dy + tb1 * o.dx;
  out.by1 = tb1 * o.dy - nb1 * o.dx;
}

/// Takes over what a contact of general shape remembers: its shear and the length that carried it are spread by the
/// `length` of both halves that carries shear now [m], its damping force counts along the normal; its moment is not
/// kept.
template <class T>
TRILITH_INLINE void take_over(const FaceOverlap<T>& o, const T* length, FaceMemory<T>& m) {
  const T zero{}, one = zero + 1.0, sum = length[0] + length[1];
  for (const int h : {0, 1}) {
    const T weight = select(m.general & (sum > zero), 2.0 * length[h] * inverse_or_zero(sum), one);
    m.shear_elastic[h] *= weight;
    m.shear_total[h] *= weight;
    m.active[h] *= weight;
  }
  const T along_normal = m.damping_force[0] * o.dy - m.damping_force[1] * o.dx;
  m.damping_force[0] = select(m.general, along_normal, m.damping_force[0]);
  m.damping_force[1] = select(m.general, zero, m.damping_force[1]);
}

/// New memory and energy given off. The power of the damping force is taken with the mean of the forces before and
/// after the step, which is what a leapfrog step does work with.
template <class T>
TRILITH_INLINE void remember(const FaceOverlap<T>& o, const FaceRates<T>& r, const FaceMemory<T>& before, double dt,
                             const HalfResponse<T>& s0, const HalfResponse<T>& s1, FaceResponse<T>& out) {
  FaceMemory<T>& m = out.memory;
  m.shear_elastic[0] = s0.shear_elastic;
  m.shear_elastic[1] = s1.shear_elastic;
  m.shear_total[0] = s0.shear_total;
  m.shear_total[1] = s1.shear_total;
  m.active[0] = s0.active;
  m.active[1] = s1.active;
  m.slip = before.slip + 0.5 * (s0.slip + s1.slip);
  m.damping_force[0] = s0.damping + s1.damping;
  m.damping_force[1] = s0.damping_moment - 0.5 * o.shared * s0.damping + s1.damping_moment;
  const T power = (m.damping_force[0] + before.damping_force[0]) * 0.5 * (r.gap_lo + r.gap_hi) +
                  (m.damping_force[1] + before.damping_force[1]) * r.turning;
  out.lost_damping = s0.lost_damping + s1.lost_damping - 0.5 * dt * power;
  out.lost_friction = s0.lost_friction + s1.lost_friction;
}

/// Where two faces share length and how they move there: all that the stresses depend on but their memory.
/// `corner`: at least 1; the largest cot of the turning angle at the four face ends (see world/flatness.hpp).
template <class T>
struct FaceMotion {
  FaceOverlap<T> overlap;
  FaceRates<T> rates;
  Mask<T> flat;
  FaceMotion() = default;
  TRILITH_INLINE FaceMotion(const FaceEnds<T>& a, const FaceEnds<T>& b, T corner)
      : overlap(a, b), rates(overlap, a, b), flat(overlap.is_flat(corner)) {}
};

/// `CanBond` drops the bond arithmetic for laws without one.
template <bool CanBond, class T>
TRILITH_INLINE FaceResponse<T> respond_face_motion(const FaceMotion<T>& motion, FaceMemory<T> before,
                                                   const FaceLaw& law) {
  const T zero{};
  const FaceOverlap<T>& overlap = motion.overlap;
  if constexpr (!CanBond) before.bonds[0] = before.bonds[1] = Mask<T>{};
  FaceHalves<T> halves(overlap, motion.rates, before);
  FaceResponse<T> out;
  out.is_face_pair = overlap.sane & motion.flat;
  out.lost_fracture = zero;
  if constexpr (CanBond) {
    out.is_face_pair = overlap.sane & (motion.flat | before.bonds[0] | before.bonds[1]);
    out.lost_fracture = lose_bonds(halves, before, law);
  }
  HalfResponse<T> s[2];
  T active[2];
  respond_normal(halves.half, law, active, s);
  out.touching = (active[0] > zero) | (active[1] > zero);
  const T length[2] = {active[0] * halves.half[0].length, active[1] * halves.half[1].length};
  if (any(before.general)) take_over(overlap, length, before);
  for (const int h : {0, 1})
    respond_shear(halves.half[h], law, length[h], {before.shear_elastic[h], before.shear_total[h], before.active[h]},
                  s[h]);
  out.memory.bonds[0] = halves.half[0].bonded;
  out.memory.bonds[1] = halves.half[1].bonded;
  remember(overlap, motion.rates, before, law.dt, s[0], s[1], out);
  spread_to_ends(overlap, s[0], s[1], out);
  return out;
}

template <bool CanBond, class T>
TRILITH_INLINE FaceResponse<T> respond_face_pair(const FaceEnds<T>& a, const FaceEnds<T>& b, T corner,
                                                 const FaceMemory<T>& before, const FaceLaw& law) {
  return respond_face_motion<CanBond>(FaceMotion<T>(a, b, corner), before, law);
}

}  // namespace trilith
