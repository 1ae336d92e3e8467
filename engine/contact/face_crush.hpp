// Mortar that crushes: an elastic, perfectly plastic cap on the pressure of one half of two faces.
//
// Each half keeps the depth z it is crushed by; its stresses come from the gap g + z. While the mean stress over the
// part of the half that is pressed would exceed the compressive strength, z grows until it does not: where all of the
// half is pressed, until the mean overlap is strength / kn; where it is pressed from one end on, its stress is a
// triangle, and the overlap of that end stays at twice that. Mortar is thin: beyond a greatest depth it is crushed no
// more. Unloading and loading again up to there are elastic (the cap of Lourenco and Rots, "Multisurface interface
// model for analysis of masonry structures", J. Eng. Mech. 123(7), 1997, without their hardening and softening; each
// half counts as one point of integration). The damping acts on the elastic part of the motion only.
#pragma once

#include "contact/face_half.hpp"

namespace trilith {

/// The depth a half is crushed by once its gaps have been those of now; `before`: up to now [m].
template <class T>
TRILITH_INLINE T crushed_depth(const HalfState<T>& h, T before, const FaceLaw& law) {
  // Mortar that fills a half is pressed there as well.
  const T c0 = select(h.bonded, -h.bond0(), -h.g0), c1 = select(h.bonded, -h.bond1(), -h.g1);
  const T pressed_whole = 0.5 * (c0 + c1) - law.crushing, pressed_at_end = larger(c0, c1) - 2.0 * law.crushing;
  const T most = T{} + law.crushing_depth;
  return larger(before, smaller(larger(pressed_whole, pressed_at_end), most));
}

/// Crushes a half as far as its gaps ask, and lets its gaps and their rates be those of what is left of the mortar.
/// Returns the depth [m].
template <class T>
TRILITH_INLINE T crush(HalfState<T>& h, T before, const FaceLaw& law) {
  const T depth = crushed_depth(h, before, law), rate = (depth - before) * (law.dt > 0 ? 1.0 / law.dt : 0.0);
  h.g0 += depth, h.g1 += depth;
  h.r0 += rate, h.r1 += rate;
  return depth;
}

/// Mean elastic pressure over kn of a half with the gaps g0 and g1 at its ends, of which the bond holds the share
/// `hold` all along [m].
template <class T>
TRILITH_INLINE T mean_overlap(T g0, T g1, T hold, const Filling<T>& filling) {
  const PositivePart<T> part(-g0, -g1);
  const T rise = g0 - g1;
  const LinearStress<T> closed(rise * part.from - g0, rise * part.to - g0, part.from, part.to);
  return closed.sum + hold * (filling.stress().sum - 0.5 * (g0 + g1) - closed.sum);
}

/// Energy that a crushed half takes in as its depth grows by `deeper` [m], with the mean of its pressure at both ends
/// of the step; `hold`: of its bond before the step [J].
template <class T>
TRILITH_INLINE T crushing_loss(const HalfState<T>& h, T deeper, T hold, const FaceLaw& law) {
  const T before = mean_overlap(h.g0 - law.dt * h.r0, h.g1 - law.dt * h.r1, hold, h.filling);
  const T now = mean_overlap(h.g0, h.g1, h.hold, h.filling);
  return 0.5 * law.kn * h.length * deeper * (before + now);
}

}  // namespace trilith
