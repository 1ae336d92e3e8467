// Shear of one half of two faces: a Kelvin-Voigt spring in series with a slider.
//
//      body A ---/\/\/\/---+---[ slider: |shear| <= limit ]--- body B
//             ---[|-------+
//               beta ks         slip = stretch of the spring + sliding
//
// Input: the slip of the step, the force in memory, and the lengths that carry it before and now. Output: the present
// force, of which the spring keeps a part, and the energy dissipated by damping and sliding. Both energies use the mean
// of their force before and after the step, which is the work of a leapfrog step. Written for T = double or Lanes.
#pragma once

#include "law/contact/face_half.hpp"

namespace trilith {

/// Lengths up to this carry no shear: their squares would underflow [m].
inline constexpr double shortest_length = 1e-100;

/// Shear memory of a half.
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

/// Compliances of the lengths that carry shear, before and now [m/N]; 0 if there is none.
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

/// Elastic shear energy released because the length in contact changed to one with the given stiffness. Length that
/// separates takes its share of the force with it, new length starts without force. `kept`: the remaining force. Never
/// negative.
template <class T>
TRILITH_INLINE T released_energy(const ShearBefore<T>& before, T stiffness, const ShearCompliance<T>& compliance,
                                 T& kept) {
  const T one = T{} + 1.0;
  kept = before.elastic * smaller(one, stiffness * compliance.before);
  return 0.5 * (before.elastic * before.elastic * compliance.before - kept * kept * compliance.now);
}

/// One step of a half's shear before its slider. `ks` per metre of length; `beta` and `dt` from the law.
template <class T>
struct ShearTrial {
  T kept, elastic, total;  ///< force kept, force with all slip elastic, force with damping [N]
  T move, relaxed;         ///< slip [m]; energy released by length that separated [J]
  ShearCompliance<T> compliance;

  TRILITH_INLINE ShearTrial(const HalfState<T>& h, double ks, double beta, double dt, T active,
                            const ShearBefore<T>& before)
      : compliance(before.active, active, ks) {
    const T stiffness = ks * active;
    relaxed = released_energy(before, stiffness, compliance, kept);
    move = h.slip_mean * dt;
    elastic = kept + stiffness * move;
    total = elastic + beta * stiffness * h.slip_rate;
  }
};

/// Ends a shear step. Where it `slides`, its force is `held`, of which `slid` is elastic.
template <class T>
TRILITH_INLINE void end_shear(const ShearTrial<T>& trial, T active, const ShearBefore<T>& before, Mask<T> slides,
                              T held, T slid, HalfResponse<T>& out) {
  const T zero{};
  const Mask<T> open = active <= shortest_length;
  out.shear_elastic = select(open, zero, select(slides, slid, trial.elastic));
  out.shear_total = select(open, zero, select(slides, held, trial.total));
  const T stretch = select(slides, (out.shear_elastic - trial.kept) * trial.compliance.now, trial.move);
  const T slip = select(open, zero, trial.move - stretch);
  const T mean_total = 0.5 * (out.shear_total + before.total);
  const T mean_elastic = 0.5 * (out.shear_elastic + before.elastic);
  // If the whole half opens, the previous force did work over half of the displacement, which no dissipation accounts
  // for.
  const T parted = 0.5 * (before.elastic - trial.kept) * select(open, trial.move, stretch);
  out.slip = magnitude(slip);
  out.active = active;
  out.lost_friction = mean_total * slip + trial.relaxed + parted;
  out.lost_damping = (mean_total - mean_elastic) * select(open, trial.move, stretch);
}

}  // namespace trilith
