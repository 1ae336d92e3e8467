// What one half of the length two faces share carries: normal stress from the overlap, shear from the slip.
//
// Over a half the gap g(s) is linear; where closed, sigma(s) = kn (-g - beta dg/dt), clipped at 0 where no bond holds.
// Shear is a Kelvin-Voigt spring in series with a Coulomb slider. Written over T = double or Lanes.
#pragma once

#include "base/lanes.hpp"
#include "contact/face_law.hpp"

namespace trilith {

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

/// Mortar that fills a half where the faces stood apart as it set: its thickness is linear over [from, to], in shares
/// of the half, and 0 elsewhere. While the half is bonded, its stresses come from the gap less that thickness, so that
/// the bond begins without changing any stress.
template <class T>
struct Filling {
  T from{}, to{}, w0{}, w1{};  ///< thickness at `from` and `to` [m]
  T end0{}, end1{};            ///< ... and at the ends of the half [m]

  [[nodiscard]] TRILITH_INLINE LinearStress<T> stress() const { return {w0, w1, from, to}; }
  /// Mean over the half of the thickness times a function that is linear from q0 to q1.
  [[nodiscard]] TRILITH_INLINE T times(T q0, T q1) const {
    const T a = q0 + (q1 - q0) * from, b = q0 + (q1 - q0) * to;
    return (to - from) * (2.0 * (w0 * a + w1 * b) + w0 * b + w1 * a) * (1.0 / 6.0);
  }
  /// Mean over the half of (g - w)(p - w) - g p, for gaps linear from g0 to g1 and from p0 to p1 [m2].
  [[nodiscard]] TRILITH_INLINE T product(T g0, T g1, T p0, T p1) const {
    return (to - from) * (w0 * w0 + w0 * w1 + w1 * w1) * (1.0 / 3.0) - times(g0 + p0, g1 + p1);
  }
};

/// The mortar of both halves of a joint whose gaps at the ends, as it set, were `lo` and `hi` [m].
template <class T>
struct JointFilling {
  Filling<T> half[2];
  TRILITH_INLINE JointFilling(T lo, T hi) {
    const T zero{}, mid = 0.5 * (lo + hi), end[3] = {lo, mid, hi};
    for (const int h : {0, 1}) {
      const T rise = end[h + 1] - end[h];
      const PositivePart<T> open(end[h], end[h + 1]);
      half[h] = {open.from,
                 open.to,
                 larger(end[h] + rise * open.from, zero),
                 larger(end[h] + rise * open.to, zero),
                 larger(end[h], zero),
                 larger(end[h + 1], zero)};
    }
  }
};

template <class T>
struct HalfState {
  T g0, g1;     ///< gap at both ends [m], negative where overlapping
  T r0, r1;     ///< gap rate at both ends [m/s]
  T slip_rate;  ///< of B along d, at the middle [m/s]
  T length;     ///< [m]
  Mask<T> bonded;
  T strength{};  ///< softening bond: share of its strength left
  T hold{};      ///< ... and of its stiffness where open
  Filling<T> filling{};

  /// The gaps a bond feels at both ends of the half, and the wider of them [m].
  [[nodiscard]] TRILITH_INLINE T bond0() const { return g0 - filling.end0; }
  [[nodiscard]] TRILITH_INLINE T bond1() const { return g1 - filling.end1; }
  [[nodiscard]] TRILITH_INLINE T widest() const { return larger(bond0(), bond1()); }
};

/// The part of the shared length where a function is positive, as shares of both halves.
template <class T>
struct PositiveHalves {
  T from[2], to[2];
  /// Linear over both from f_lo to f_hi: one division.
  TRILITH_INLINE PositiveHalves(T f_lo, T f_hi) {
    const T zero{}, one = zero + 1.0;
    const PositivePart<T> whole(f_lo, f_hi);
    const T from2 = whole.from + whole.from, to2 = whole.to + whole.to;
    from[0] = smaller(from2, one), to[0] = smaller(to2, one);
    from[1] = larger(from2 - one, zero), to[1] = larger(to2 - one, zero);
  }
  /// Linear over each half.
  TRILITH_INLINE PositiveHalves(T first0, T first1, T second0, T second1) {
    const PositivePart<T> first(first0, first1), second(second0, second1);
    from[0] = first.from, to[0] = first.to;
    from[1] = second.from, to[1] = second.to;
  }
};

/// A softening bond: its share holds all along, `full`, the rest where closed only.
template <class T>
TRILITH_INLINE void mix(LinearStress<T>& closed, const LinearStress<T>& full, T share) {
  closed.sum += share * (full.sum - closed.sum);
  closed.moment += share * (full.moment - closed.moment);
}

template <class T>
TRILITH_INLINE void add(LinearStress<T>& stress, const LinearStress<T>& more, Mask<T> where) {
  const T zero{};
  stress.sum += select(where, more.sum, zero);
  stress.moment += select(where, more.moment, zero);
}

/// Normal stresses of both halves: where closed, or all along where bonded; never pulling without a bond. `active`:
/// the share of each half that carries stress.
template <Bond B, class T>
TRILITH_INLINE void respond_normal(const HalfState<T>* halves, const FaceLaw& law, T* active, HalfResponse<T>* out) {
  const T zero{}, one = zero + 1.0;
  const HalfState<T>&first = halves[0], &second = halves[1];
  PositiveHalves<T> closed(-first.g0, -second.g1);
  PositiveHalves<T> pressed(-first.g0 - law.beta * first.r0, -second.g1 - law.beta * second.r1);
  if constexpr (B == Bond::softening) {
    if (law.crushing > 0) {  // each half has gaps of its own
      closed = {-first.g0, -first.g1, -second.g0, -second.g1};
      pressed = {-first.g0 - law.beta * first.r0, -first.g1 - law.beta * first.r1, -second.g0 - law.beta * second.r0,
                 -second.g1 - law.beta * second.r1};
    }
  }
  for (const int h : {0, 1}) {
    const HalfState<T>& half = halves[h];
    const T c0 = -half.g0, q0 = c0 - law.beta * half.r0, q1 = -half.g1 - law.beta * half.r1;
    T closed_from = closed.from[h], closed_to = closed.to[h], from = larger(pressed.from[h], closed_from);
    T to = larger(from, smaller(pressed.to[h], closed_to));
    if constexpr (B == Bond::brittle) {
      closed_from = select(half.bonded, zero, closed_from), closed_to = select(half.bonded, one, closed_to);
      from = select(half.bonded, zero, from), to = select(half.bonded, one, to);
    }
    const T dc = half.g0 - half.g1, dq = q1 - q0;
    LinearStress<T> elastic(c0 + dc * closed_from, c0 + dc * closed_to, closed_from, closed_to);
    LinearStress<T> total(q0 + dq * from, q0 + dq * to, from, to);
    active[h] = closed_to - closed_from;
    if constexpr (B == Bond::brittle) {
      const LinearStress<T> mortar = half.filling.stress();
      add(elastic, mortar, half.bonded), add(total, mortar, half.bonded);
    }
    if constexpr (B == Bond::softening) {
      const LinearStress<T> mortar = half.filling.stress();
      LinearStress<T> bond(c0, -half.g1, zero, one), bond_total(q0, q1, zero, one);
      add(bond, mortar, half.bonded), add(bond_total, mortar, half.bonded);
      mix(elastic, bond, half.hold);
      mix(total, bond_total, half.hold);
      active[h] = select(half.bonded, one, active[h]);
    }
    const T scale = law.kn * half.length;
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

/// One step of a half's shear before its slider is asked.
template <class T>
struct ShearTrial {
  T kept, elastic, total;  ///< force kept, with the step's slip all elastic, and with its damping [N]
  T move, relaxed;         ///< slip [m]; energy let go by length that parted [J]
  ShearCompliance<T> compliance;

  TRILITH_INLINE ShearTrial(const HalfState<T>& h, const FaceLaw& law, T active, const ShearBefore<T>& before)
      : compliance(before.active, active, law.ks) {
    const T stiffness = law.ks * active;
    relaxed = let_go(before, stiffness, compliance, kept);
    move = h.slip_rate * law.dt;
    elastic = kept + stiffness * move;
    total = elastic + law.beta * stiffness * h.slip_rate;
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
  const T parted = select(open, zero, 0.5 * (before.elastic - trial.kept) * stretch);
  out.slip = magnitude(slip);
  out.active = active;
  out.lost_friction = mean_total * slip + trial.relaxed + parted;
  out.lost_damping = select(open, zero, (mean_total - mean_elastic) * stretch);
}

/// Kelvin-Voigt spring in series with a Coulomb slider; the damping acts on the elastic part only. `active`: length
/// that carries shear [m].
template <class T>
TRILITH_INLINE void respond_shear(const HalfState<T>& h, const FaceLaw& law, T active, const ShearBefore<T>& before,
                                  HalfResponse<T>& out) {
  const T zero{};
  const ShearTrial<T> trial(h, law, active, before);
  const T limit = select(h.bonded, zero + 1e300, law.mu * larger(out.normal, zero));
  const T held = select(trial.total < zero, -limit, limit);
  const double share = law.dt > 0 ? law.dt / (law.dt + law.beta) : 0.0;
  const T slid = trial.kept + (held - trial.kept) * share;
  end_shear(trial, active, before, magnitude(trial.total) > limit, held, slid, out);
}

}  // namespace trilith
