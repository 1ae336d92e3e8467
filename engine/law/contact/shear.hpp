// Shear of one half of two faces: a Kelvin-Voigt spring in series with a slider.
//
//      body A ---/\/\/\/---+---[ slider: |shear| <= limit ]--- body B
//             ---[|-------+
//               beta ks         slip = stretch of the spring + sliding
//
// Comes in: the slip of the step, the force remembered, the length that carried it and the one that does now. Goes out:
// the force now, of which the spring keeps a part, and what damping and sliding gave off, each with the mean of its
// force before and after the step, which is what a leapfrog step does work with. Written over T = double or Lanes.
#pragma once

#include "law/contact/face_half.hpp"

namespace trilith {

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
TRILITH_INLINE T released_energy(const ShearBefore<T>& before, T stiffness, const ShearCompliance<T>& compliance,
                                 T& kept) {
  const T one = T{} + 1.0;
  kept = before.elastic * smaller(one, stiffness * compliance.before);
  return 0.5 * (before.elastic * before.elastic * compliance.before - kept * kept * compliance.now);
}

/// One step of a half's shear before its slider is asked. `ks` per metre of length, `beta` and `dt` as of the law.
template <class T>
struct ShearTrial {
  T kept, elastic, total;  ///< force kept, with the step's slip all elastic, and with its damping [N]
  T move, relaxed;         ///< slip [m]; energy let go by length that parted [J]
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

/// Ends a step of shear. Where it `slides`, its force is `held`, of which `slid` is elastic.
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
  // Where all of it opens, the force of before worked for half of the way, and nothing takes that.
  const T parted = 0.5 * (before.elastic - trial.kept) * select(open, trial.move, stretch);
  out.slip = magnitude(slip);
  out.active = active;
  out.lost_friction = mean_total * slip + trial.relaxed + parted;
  out.lost_damping = (mean_total - mean_elastic) * select(open, trial.move, stretch);
}

}  // namespace trilith
