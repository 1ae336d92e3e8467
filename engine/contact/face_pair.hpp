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
#include "contact/face_bond.hpp"
#include "contact/face_crush.hpp"
#include "contact/face_half.hpp"
#include "contact/face_overlap.hpp"

namespace trilith {

/// ContactMemory, lane by lane.
template <class T>
struct FaceMemory {
  T shear_elastic[2], shear_total[2], damping_force[2], active[2], slip;
  Mask<T> bonds[2];
  Mask<T> general{};  ///< the last step found the contact by overlap: the halves share one shear force
  Mask<T> worn{};     ///< dilates no more
  T damage[2]{};      ///< softening bond: share of the strength of each half that is lost
  T set[2]{};         ///< gaps at both ends as the joint's mortar set [m]
  T crushed[2]{};     ///< depth by which the mortar of each half is crushed [m]
};

template <class T>
struct FaceResponse {
  T ax0, ay0, ax1, ay1, bx0, by0, bx1, by1;  ///< forces at the face ends [N]
  FaceMemory<T> memory;
  T lost_damping, lost_friction, lost_fracture;  ///< energy given off in this step [J]
  Mask<T> is_face_pair;                          ///< false: nothing above holds, the shape is general
  Mask<T> touching;
};

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
  /// Puts in the mortar of a joint that had the gaps `set` at its ends as it set [m].
  TRILITH_INLINE void fill(const T* set) {
    const JointFilling<T> mortar(set[0], set[1]);
    for (const int h : {0, 1}) half[h].filling = mortar.half[h];
  }
  /// Faces count as nearer by `opened` [m]: what sliding has put between them.
  TRILITH_INLINE void open_by(T opened) {
    for (HalfState<T>& h : half) h.g0 -= opened, h.g1 -= opened;
  }
};

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

/// Opening of a joint by the sliding it has behind it [m].
template <class T>
TRILITH_INLINE T dilation_of(T slip, Mask<T> worn, const FaceLaw& law) {
  return select(worn, T{}, law.dilation * smaller(slip, law.dilation_slip + T{}));
}

/// Softening mortar before its stresses: opened by dilation, crushed, and with the strength its opening leaves it.
template <class T>
TRILITH_INLINE void begin_softening(FaceHalves<T>& halves, const FaceMemory<T>& before, const FaceLaw& law,
                                    FaceMemory<T>& after) {
  if (law.dilation > 0) halves.open_by(dilation_of(before.slip, before.worn, law));
  for (const int h : {0, 1}) {
    if (law.crushing > 0) after.crushed[h] = crush(halves.half[h], before.crushed[h], law);
    soften_by_opening(halves.half[h], before.damage[h], law);
  }
}

/// Bonds after the normal stresses: what is left of them, and the energy that they and the crushing gave off [J].
template <class T>
TRILITH_INLINE T end_softening(const FaceHalves<T>& halves, const FaceMemory<T>& before, const FaceLaw& law,
                               FaceMemory<T>& after) {
  const T zero{}, one = zero + 1.0;
  T lost = zero;
  for (const int k : {0, 1}) {
    const HalfState<T>& h = halves.half[k];
    const T deeper = after.crushed[k] - before.crushed[k];
    if (law.crushing > 0 && any(deeper > zero))
      lost += crushing_loss(h, deeper, select(before.bonds[k], share_held(one - before.damage[k], law), zero), law);
    lost += opening_loss(h, before.damage[k], h.strength, before.bonds[k], law);
    after.bonds[k] = h.bonded & (h.strength > zero);
    after.damage[k] = select(after.bonds[k], one - h.strength, zero);
  }
  return lost;
}

/// The work sliding does against the pressure as it opens the joint comes out of what friction would take.
template <class T>
TRILITH_INLINE void book_dilation(const FaceMemory<T>& before, const FaceLaw& law, const HalfResponse<T>* s,
                                  FaceResponse<T>& out) {
  const T opened = dilation_of(out.memory.slip, before.worn, law) - dilation_of(before.slip, before.worn, law);
  const T pressure = s[0].normal - s[0].damping + s[1].normal - s[1].damping;
  out.lost_friction -= (pressure + 0.5 * law.kn * opened * (s[0].active + s[1].active)) * opened;
}

/// `B` drops the bond arithmetic for laws without one.
template <Bond B, class T>
TRILITH_INLINE FaceResponse<T> respond_face_motion(const FaceMotion<T>& motion, FaceMemory<T> before,
                                                   const FaceLaw& law) {
  const T zero{};
  const FaceOverlap<T>& overlap = motion.overlap;
  if constexpr (B == Bond::none) before.bonds[0] = before.bonds[1] = Mask<T>{};
  FaceHalves<T> halves(overlap, motion.rates, before);
  FaceResponse<T> out;
  out.is_face_pair = overlap.sane & (motion.flat | before.bonds[0] | before.bonds[1]);
  out.lost_fracture = zero;
  if constexpr (B != Bond::none) {
    if (any((before.set[0] > zero) | (before.set[1] > zero))) halves.fill(before.set);
    for (const int k : {0, 1}) out.memory.set[k] = before.set[k];
  }
  if constexpr (B == Bond::brittle) out.lost_fracture = lose_bonds(halves.half, before.shear_elastic, law);
  if constexpr (B == Bond::softening) begin_softening(halves, before, law, out.memory);
  HalfResponse<T> s[2];
  T active[2];
  respond_normal<B>(halves.half, law, active, s);
  out.touching = (active[0] > zero) | (active[1] > zero);
  const T length[2] = {active[0] * halves.half[0].length, active[1] * halves.half[1].length};
  if (any(before.general)) take_over(overlap, length, before);
  for (const int h : {0, 1}) {
    const ShearBefore<T> shear{before.shear_elastic[h], before.shear_total[h], before.active[h]};
    if constexpr (B == Bond::softening)
      out.lost_fracture += respond_softening_shear(halves.half[h], law, length[h], shear, s[h]);
    else
      respond_shear(halves.half[h], law, length[h], shear, s[h]);
  }
  out.memory.bonds[0] = halves.half[0].bonded;
  out.memory.bonds[1] = halves.half[1].bonded;
  out.memory.worn = before.worn;
  if constexpr (B == Bond::softening) out.lost_fracture += end_softening(halves, before, law, out.memory);
  remember(overlap, motion.rates, before, law.dt, s[0], s[1], out);
  if constexpr (B == Bond::softening)
    if (law.dilation > 0) book_dilation(before, law, s, out);
  spread_to_ends(overlap, s[0], s[1], out);
  return out;
}

template <Bond B, class T>
TRILITH_INLINE FaceResponse<T> respond_face_pair(const FaceEnds<T>& a, const FaceEnds<T>& b, T corner,
                                                 const FaceMemory<T>& before, const FaceLaw& law) {
  return respond_face_motion<B>(FaceMotion<T>(a, b, corner), before, law);
}

}  // namespace trilith
