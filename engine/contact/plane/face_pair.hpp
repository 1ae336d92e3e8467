// Stress over the overlap of two opposed faces: exact for a linear overlap.
//
// A's face runs from a.0 to a.1, B's from b.0 to b.1, each counter-clockwise around its body, so they run in opposite
// directions. Their common direction is d, and n = -left_of(d) points from A to B. Over the shared length [lo, hi] the
// gap g(s) is linear. It is divided into two halves with separate shear history and bond (ContactMemory); their
// stresses follow the law, see law/contact/coulomb.hpp. Forces at the face ends have the resultant, the moment and the
// power of the stresses (rigid or linear faces).
//
//            b.1 ____________________________ b.0
//                      B         ^ n
//                    lo |--half 0--+--half 1--| hi
//            a.0 ________________________________ a.1      --> d
//                      A
//
// Written for T = double or Lanes. Source: Barbosa, "Discontinuous structural analysis", eqs. 3 to 5.
#pragma once

#include "law/contact/coulomb.hpp"
#include "law/contact/face_motion.hpp"

namespace trilith {

/// `M`: the law's memory.
template <class T, class M>
struct FaceResponse {
  T ax0, ay0, ax1, ay1, bx0, by0, bx1, by1;  ///< forces at the face ends [N]
  FaceMemory<T> memory;
  M own{};
  T lost_damping, lost_friction, lost_fracture;  ///< energy dissipated in this step [J]
  Mask<T> is_face_pair;                          ///< false: the results are not valid, the contact is a general one
  Mask<T> touching;
};

/// Forces at the four face ends from the stresses of both halves: same resultant, moment and power. The couple moves
/// the shear to mid-gap, so that it acts on both bodies along one line and angular momentum is conserved.
template <class T, class M>
TRILITH_INLINE void spread_to_ends(const FaceOverlap<T>& o, const HalfResponse<T>& s0, const HalfResponse<T>& s1,
                                   FaceResponse<T, M>& out) {
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

/// Converts the memory of a general contact. Its shear and the length that carried it are distributed by the lengths of
/// both halves that carry shear now, `length` [m]. Its damping force counts along the normal; the moment of this force
/// is dropped.
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

/// New memory and dissipated energy; `r`: mean rates over the step. The power of the damping uses the mean of its force
/// before and after the step, which is the work of a leapfrog step.
template <class T, class M>
TRILITH_INLINE void remember(const FaceOverlap<T>& o, const FaceRates<T>& r, const FaceMemory<T>& before, double dt,
                             const HalfResponse<T>& s0, const HalfResponse<T>& s1, FaceResponse<T, M>& out) {
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

/// One step of two faces under the law of kernel `law`. `Motion`: LeapfrogMotion or FaceMotion. `before`, `own`: the
/// previous memory.
template <class K, class T, template <class> class Motion, class M = typename K::template Memory<T>>
TRILITH_INLINE FaceResponse<T, M> respond_face_motion(const Motion<T>& motion, FaceMemory<T> before, const M& own,
                                                      const K& law) {
  const T zero{};
  const FaceOverlap<T>& overlap = motion.overlap;
  if constexpr (!K::bonds) before.bonds[0] = before.bonds[1] = Mask<T>{};
  FaceHalves<T> halves(overlap, motion.rates, motion.over_step(), before);
  FaceResponse<T, M> out;
  out.is_face_pair = overlap.sane & (motion.flat | before.bonds[0] | before.bonds[1]);
  out.lost_fracture = law.begin(halves, before, own, out.own);
  HalfResponse<T> s[2];
  T active[2];
  law.press(halves.half, active, s);
  out.touching = (active[0] > zero) | (active[1] > zero);
  const T length[2] = {active[0] * halves.half[0].length, active[1] * halves.half[1].length};
  if (any(before.general)) take_over(overlap, length, before);
  for (const int h : {0, 1}) {
    const ShearBefore<T> shear{before.shear_elastic[h], before.shear_total[h], before.active[h]};
    out.lost_fracture += law.slide(halves.half[h], length[h], shear, s[h]);
    out.memory.bonds[h] = halves.half[h].bonded;
  }
  out.lost_fracture += law.end(halves, before, own, out.memory, out.own);
  remember(overlap, motion.over_step(), before, law.dt, s[0], s[1], out);
  out.lost_friction -= law.lifting(halves, before, out.memory, own, s, out.own);
  spread_to_ends(overlap, s[0], s[1], out);
  return out;
}

template <class K, class T, class M = typename K::template Memory<T>>
TRILITH_INLINE FaceResponse<T, M> respond_face_pair(const FaceEnds<T>& a, const FaceEnds<T>& b, T corner,
                                                    const FaceMemory<T>& before, const M& own, const K& law) {
  return respond_face_motion<K>(LeapfrogMotion<T>(a, b, corner), before, own, law);
}

}  // namespace trilith
