// Kinematics of two faces over their shared length: everything that determines the stresses except their memory.
//
// Written for T = double or Lanes.
#pragma once

#include "law/contact/face_half.hpp"
#include "law/contact/face_overlap.hpp"

namespace trilith {

/// Rates along the shared length: gap, and slip of B relative to A, at both of its ends [m/s].
template <class T>
struct FaceRates {
  T gap_lo, gap_hi, slip_lo, slip_hi;
  T turning;  ///< relative spin of B: slope of the gap rate [rad/s]
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
    // At mid-gap, where the shear acts: a common spin causes no slip.
    const T spin = 0.5 * (spin_a + spin_b);
    slip_lo = tb1 + stretch_b * lo_b - ta0 - stretch_a * o.lo + spin * o.gap_lo;
    slip_hi = tb1 + stretch_b * hi_b - ta0 - stretch_a * o.hi + spin * o.gap_hi;
  }
};

/// `corner`: at least 1; the largest cotangent of the turning angle at the four face ends (see model/flatness.hpp).
template <class T>
struct LeapfrogMotion {
  FaceOverlap<T> overlap;
  FaceRates<T> rates;
  Mask<T> flat;
  LeapfrogMotion() = default;
  TRILITH_INLINE LeapfrogMotion(const FaceEnds<T>& a, const FaceEnds<T>& b, T corner)
      : overlap(a, b), rates(overlap, a, b), flat(overlap.is_flat(corner)) {}
  /// Mean rates over the step, equal to the present ones.
  [[nodiscard]] TRILITH_INLINE const FaceRates<T>& over_step() const { return rates; }
};

/// For a step whose mean velocities differ from the velocities at its end.
template <class T>
struct FaceMotion : LeapfrogMotion<T> {
  FaceRates<T> mean;
  FaceMotion() = default;
  TRILITH_INLINE FaceMotion(const FaceEnds<T>& a, const FaceEnds<T>& b, T corner)
      : LeapfrogMotion<T>(a, b, corner), mean(this->rates) {}
  /// Sets the mean rates from the faces with their mean velocities.
  TRILITH_INLINE void set_over_step(const FaceEnds<T>& a, const FaceEnds<T>& b) { mean = {this->overlap, a, b}; }
  [[nodiscard]] TRILITH_INLINE const FaceRates<T>& over_step() const { return mean; }
};

/// ContactMemory in lanes.
template <class T>
struct FaceMemory {
  T shear_elastic[2], shear_total[2], damping_force[2], active[2], slip;
  Mask<T> bonds[2];
  Mask<T> general{};  ///< the last step was a general contact: the halves share one shear force
};

/// The two halves of the shared length.
template <class T>
struct FaceHalves {
  HalfState<T> half[2];
  TRILITH_INLINE FaceHalves(const FaceOverlap<T>& o, const FaceRates<T>& r, const FaceRates<T>& mean,
                            const FaceMemory<T>& m) {
    const T gap = 0.5 * (o.gap_lo + o.gap_hi), length = 0.5 * o.shared;
    const T rate = 0.5 * (r.gap_lo + r.gap_hi), middle = 0.5 * (mean.gap_lo + mean.gap_hi);
    // Member by member: an aggregate would be built apart and copied as one block of memory.
    const auto set = [&](HalfState<T>& of, double at_lo, double at_hi) TRILITH_INLINE_LAMBDA {
      of.slip_rate = at_lo * r.slip_lo + at_hi * r.slip_hi;
      of.slip_mean = at_lo * mean.slip_lo + at_hi * mean.slip_hi;
      of.length = length;
    };
    HalfState<T>&first = half[0], &second = half[1];
    set(first, 0.75, 0.25), set(second, 0.25, 0.75);
    first.g0 = o.gap_lo, first.g1 = gap, second.g0 = gap, second.g1 = o.gap_hi;
    first.r0 = r.gap_lo, first.r1 = rate, second.r0 = rate, second.r1 = r.gap_hi;
    first.m0 = mean.gap_lo, first.m1 = middle, second.m0 = middle, second.m1 = mean.gap_hi;
    first.bonded = m.bonds[0], second.bonded = m.bonds[1];
  }
  /// Fills in the mortar of a joint that set at the end gaps `set` [m].
  TRILITH_INLINE void fill(const T* set) {
    const JointFilling<T> mortar(set[0], set[1]);
    for (const int h : {0, 1}) half[h].filling = mortar.half[h];
  }
  /// Reduces the gaps by `opened` [m], the opening due to sliding.
  TRILITH_INLINE void open_by(T opened) {
    for (HalfState<T>& h : half) h.g0 -= opened, h.g1 -= opened;
  }
};

}  // namespace trilith
