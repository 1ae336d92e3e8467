// One half of the length shared by two faces: input and output of a law, and integrals over the half.
//
// Notation, also in the laws: s is the coordinate along the half, from 0 to 1. The gap g is negative where the faces
// overlap, and c = -g is the overlap. The gap rate is r, and q = c - beta r is the overlap with damping. Both g and r
// are linear over a half, so they are given by their values at its ends 0 and 1.
//
//          B  ______g0 .                        g(s) = g0 + (g1 - g0) s
//                       ` - . _                 closed where g < 0, from `from` to `to`
//      0 ----------------------` - ._______ 1   p = stress over the stiffness; sum and moment are its
//          A                           g1       integrals with 1 and with s
//
// A rate is the present one, used for damping. A mean rate times the step is the change over the step, used for slip
// and losses. In a leapfrog step, whose velocities are half a step old, both are equal.
//
// Written for T = double or Lanes.
#pragma once

#include "base/simd/lanes.hpp"

namespace trilith {

/// Equal parts of a half that soften separately.
inline constexpr int bond_parts = 4;
/// Start of a part, relative to its half. Its end is the start of the next part.
inline constexpr double part_start(int part) {
  return static_cast<double>(part) / bond_parts;
}

/// Linear stress p over [l0, l1] of a half, in units of the half: its integral and first moment.
template <class T>
struct LinearStress {
  T sum, moment;
  TRILITH_INLINE LinearStress(T p0, T p1, T l0, T l1) {
    const T width = l1 - l0;
    sum = 0.5 * width * (p0 + p1);
    moment = width * (p0 * (2.0 * l0 + l1) + p1 * (l0 + 2.0 * l1)) * (1.0 / 6.0);
  }
};

/// A part of a half, relative to it.
template <class T>
struct HalfSpan {
  T from, to;
};

/// The part of [0, 1] where a linear function from f0 to f1 is positive; empty where from == to.
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

/// The forces of one half of the shared length.
template <class T>
struct HalfResponse {
  T normal, normal_moment;    ///< [N], and its first moment about the half's start [N m]
  T damping, damping_moment;  ///< the damping part of both
  T shear_elastic, shear_total, slip, active;
  T lost_damping, lost_friction;
};

/// Mortar that fills a half where the faces were apart when it set. Its thickness is linear over [from, to], relative
/// to the half, and 0 elsewhere. While the half is bonded, its stresses follow from the gap minus this thickness, so
/// that setting the bond changes no stress.
template <class T>
struct Filling {
  T from{}, to{}, w0{}, w1{};  ///< thickness at `from` and `to` [m]
  T end0{}, end1{};            ///< thickness at the ends of the half [m]

  [[nodiscard]] TRILITH_INLINE LinearStress<T> stress() const { return {w0, w1, from, to}; }
  /// The filling within [a, b], relative to the half.
  [[nodiscard]] TRILITH_INLINE Filling within(double a, double b) const {
    const T zero{}, one = zero + 1.0, width = to - from;
    const T slope = (w1 - w0) / select(width > zero, width, one);
    Filling part = *this;
    part.from = smaller(larger(from, zero + a), zero + b);
    part.to = larger(part.from, smaller(to, zero + b));
    part.w0 = w0 + slope * (part.from - from), part.w1 = w0 + slope * (part.to - from);
    return part;
  }
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

/// The mortar of both halves of a joint, which set at the end gaps `lo` and `hi` [m].
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
  T slip_rate;  ///< of B along d, at the centre [m/s]
  T m0, m1;     ///< mean over the step of the gap rates [m/s]
  T slip_mean;  ///< mean over the step of the slip rate [m/s]
  T length;     ///< [m]
  Mask<T> bonded;
  T strength{};  ///< softening bond: remaining strength share, mean over the half
  T hold{};      ///< stiffness share where open, at this strength
  Filling<T> filling{};
  T strengths[bond_parts]{};  ///< softening bond: remaining strength share of each part
  /// Softening bond: false where its kernel found that each part has its whole strength, or no bond; then `strengths`
  /// is not read.
  bool damaged = true;

  /// Gaps relevant for the bond at both ends of the half, and the larger of them [m].
  [[nodiscard]] TRILITH_INLINE T bond0() const { return g0 - filling.end0; }
  [[nodiscard]] TRILITH_INLINE T bond1() const { return g1 - filling.end1; }
  [[nodiscard]] TRILITH_INLINE T widest() const { return larger(bond0(), bond1()); }
};

/// The part of the shared length where a function is positive, relative to both halves.
template <class T>
struct PositiveHalves {
  T from[2], to[2];
  /// Linear over both halves from f_lo to f_hi: one division.
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

/// A softening bond: its share acts over the whole half (`full`), the rest on the closed part only.
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

}  // namespace trilith
