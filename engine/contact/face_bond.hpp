// How the bond of one half of two faces is lost: at once, or softening by and by.
//
// A brittle bond is lost where its tension exceeds `tension` or its shear cohesion + mu sigma (Barbosa, "Discontinuous
// structural analysis"); under tension the shear strength falls to that left at `tension`, see FaceLaw::tension_slope.
//
// A softening bond keeps a share chi of both strengths, 1 to 0 (isotropic softening of cohesion and tension: Lourenco
// and Rots, "Multisurface interface model for analysis of masonry structures", J. Eng. Mech. 123(7), 1997; softening
// here linear, as in the bilinear law of Camanho and Davila, NASA/TM-2002-211737). Opening takes chi down along
// tension chi = kn hold g, sliding by its slip over `last_slip`; each alone gives off its fracture energy. Between, an
// open bond unloads to the origin, with the share `hold` of its stiffness, and shear unloads with ks.
#pragma once

#include "contact/face_half.hpp"

namespace trilith {

/// Integral over a half of the products of two linear gaps as a bond feels them, less that where both press [m3]: the
/// gap of now and the one with the ends `p0`, `p1` [m].
template <class T>
TRILITH_INLINE T open_product(const HalfState<T>& h, T p0, T p1) {
  const T zero{}, one = zero + 1.0;
  const T o0 = larger(h.g0, zero), o1 = larger(h.g1, zero), span = magnitude(h.g1 - h.g0);
  const Mask<T> crosses = ((h.g0 < zero) | (h.g1 < zero)) & (o0 + o1 > zero);
  const T share = select(crosses, (o0 + o1) / select(crosses, span, one), one);
  const T mortar = h.filling.product(h.g0, h.g1, p0, p1);
  p0 = larger(p0, zero), p1 = larger(p1, zero);
  return h.length * (share * (2.0 * (p0 * o0 + p1 * o1) + p0 * o1 + p1 * o0) * (1.0 / 6.0) + mortar);
}

/// Mean over a half of its opening where open, 0 elsewhere [m].
template <class T>
TRILITH_INLINE T mean_opening(const HalfState<T>& h) {
  const T zero{}, one = zero + 1.0;
  const T b0 = h.bond0(), b1 = h.bond1();
  const T o0 = larger(b0, zero), o1 = larger(b1, zero), sum = o0 + o1, span = magnitude(b1 - b0);
  const Mask<T> crosses = (smaller(b0, b1) < zero) & (sum > zero);
  return 0.5 * sum * select(crosses, sum / select(crosses, span, one), one);
}

/// True where a brittle half is beyond its limits (elastic stresses, trial shear): of tension at either end, of shear
/// over all of the half, as of the friction that follows.
template <class T>
TRILITH_INLINE Mask<T> bond_broken(const HalfState<T>& h, T shear_elastic, const FaceLaw& law) {
  const T zero{};
  const T trial = magnitude(shear_elastic + law.ks * h.length * h.slip_rate * law.dt);
  const T open = mean_opening(h), closed = open - 0.5 * (h.g0 + h.g1) + h.filling.stress().sum;
  const T strength = law.cohesion + law.kn * (law.mu * closed - law.tension_slope() * open);
  return h.bonded & ((law.kn * h.widest() > law.tension + zero) | (trial > strength * h.length));
}

/// Takes the brittle bonds that are beyond their limit; returns the energy they gave off [J].
template <class T>
TRILITH_INLINE T lose_bonds(HalfState<T>* h, const T* shear_elastic, const FaceLaw& law) {
  const T zero{};
  Mask<T> lost[2] = {bond_broken(h[0], shear_elastic[0], law), bond_broken(h[1], shear_elastic[1], law)};
  if (!law.loss_by_point) {
    const Mask<T> either = lost[0] | lost[1];
    lost[0] = h[0].bonded & either;
    lost[1] = h[1].bonded & either;
  }
  if (!any(lost[0] | lost[1])) return zero;
  T energy = zero;
  for (const int k : {0, 1}) {
    h[k].bonded = h[k].bonded & flip(lost[k]);
    energy += select(lost[k], 0.5 * law.kn * open_product(h[k], h[k].g0, h[k].g1), zero);
  }
  return energy;
}

/// Share of its stiffness that an open bond holds with the share `strength` of its strength.
template <class T>
TRILITH_INLINE T share_held(T strength, const FaceLaw& law) {
  const double range = law.last_opening - law.first_opening();
  return law.tension * strength / (law.kn * (law.last_opening - strength * range));
}

/// Takes the strength that the widest opening of a half leaves it, and what it holds with that. `damage`: before.
template <class T>
TRILITH_INLINE void soften_by_opening(HalfState<T>& h, T damage, const FaceLaw& law) {
  const T zero{}, one = zero + 1.0;
  const double range = law.last_opening - law.first_opening();
  const T left = (law.last_opening - h.widest()) * (1.0 / range);
  h.strength = larger(zero, smaller(one - damage, left));
  h.bonded = h.bonded & (h.strength > zero);
  h.strength = select(h.bonded, h.strength, zero);
  h.hold = share_held(h.strength, law);
}

/// Energy an open half gives off as it holds less: exact for the mean of the forces at both ends of the step [J].
template <class T>
TRILITH_INLINE T opening_loss(const HalfState<T>& h, T damage, T strength, Mask<T> was_bonded, const FaceLaw& law) {
  const T zero{}, one = zero + 1.0;
  const T before = select(was_bonded, share_held(one - damage, law), zero);
  const T fall = before - share_held(strength, law);
  return 0.5 * law.kn * fall * open_product(h, h.g0 - law.dt * h.r0, h.g1 - law.dt * h.r1);
}

/// The shear slider of a half, bonded or not: the most it holds, and where that leaves spring and strength.
template <class T>
struct SofteningSlider {
  T limit;     ///< before it slides [N]
  T held;      ///< size of the force where it slides [N]
  T elastic;   ///< elastic part of that [N]
  T strength;  ///< share of the strength left
  T cohesive;  ///< energy the cohesion takes [J]

  /// `kept`, `move`: elastic force [N] and slip [m] of the step, both counted along the trial force.
  TRILITH_INLINE SofteningSlider(const HalfState<T>& h, const FaceLaw& law, T normal, T compliance, T kept, T move) {
    const T zero{};
    const T friction = law.mu * larger(normal, zero) - law.tension_slope() * larger(-normal, zero);
    const T full = law.cohesion * h.length;
    limit = larger(zero, friction + full * h.strength);
    const double lag = law.dt + law.beta, rate = 1.0 / law.last_slip;
    const double loss = law.ks > 0 ? law.cohesion * rate / law.ks : 0.0;  // below 1: no snap-back
    const T drive = friction + full * (h.strength - rate * move) - kept;
    elastic = kept + drive * (law.dt > 0 ? law.dt / (lag - law.dt * loss) : 0.0);
    T slip = move - (elastic - kept) * compliance;
    strength = h.strength - rate * slip;
    held = friction + full * strength;
    // Where cohesion is used up in this step, or tension leaves no strength: what friction holds.
    const Mask<T> spent = flip(h.bonded) | (strength <= zero) | (held <= zero);
    held = select(spent, larger(zero, friction), held);
    elastic = select(spent, kept + (held - kept) * (law.dt > 0 ? law.dt / lag : 0.0), elastic);
    slip = larger(zero, move - (elastic - kept) * compliance);
    strength = select(h.bonded, smaller(h.strength, larger(zero, h.strength - rate * slip)), zero);
    cohesive = larger(zero, 0.5 * full * (h.strength + strength) + smaller(zero, friction)) * slip;
  }
};

/// The shear of a half whose bond softens; takes its strength down. Returns the energy its cohesion took [J].
template <class T>
TRILITH_INLINE T respond_softening_shear(HalfState<T>& h, const FaceLaw& law, T active, const ShearBefore<T>& before,
                                         HalfResponse<T>& out) {
  const T zero{}, one = zero + 1.0;
  const ShearTrial<T> trial(h, law, active, before);
  const T sign = select(trial.total < zero, -one, one);
  const SofteningSlider<T> slider(h, law, out.normal, trial.compliance.now, sign * trial.kept, sign * trial.move);
  const Mask<T> slides = magnitude(trial.total) > slider.limit;
  end_shear(trial, active, before, slides, sign * slider.held, sign * slider.elastic, out);
  h.strength = select(slides, slider.strength, h.strength);
  const T cohesive = select(slides, slider.cohesive, zero);
  out.lost_friction -= cohesive;
  return cohesive;
}

}  // namespace trilith
