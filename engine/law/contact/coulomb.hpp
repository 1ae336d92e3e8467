// The base kernel of contact laws: pressure proportional to the overlap, damping, Coulomb friction, no memory.
//
// A law's kernel holds its equations and its parameters prepared for one step, i.e. multiplied by the model's
// thickness. The driver in contact/plane/face_pair.hpp calls it for each half of two faces, in this order:
//
//     begin   effect of the new gaps on bond and mortar      -> dissipated energy
//     press   gaps and rates                                 -> normal stress, its damping part, length that carries
//     slide   slip and normal force                          -> shear                -> dissipated energy
//     end     remaining bond and mortar                      -> memory               -> dissipated energy
//
// General polygons in the plane call `stretch`, `over` and `slide`. Flat faces, polyhedra and spheres in space call
// `effective` and `friction`. Readings call `gaps`, `hold`, `stored`, `pressure`, `tangent` and the queries below.
//
// A law whose pressure depends on the overlap and whose friction depends on pressure and slip speed defines `effective`
// or `friction` on law/contact/point_law.hpp, which derives the other members: it acts in every geometry. A short
// example is law/contact/power.hpp. At compile time law/contact/law_forms.hpp finds the geometries in which the
// equations of a kernel act.
#pragma once

#include <algorithm>
#include <array>

#include "law/contact/face_motion.hpp"
#include "law/contact/memory.hpp"
#include "law/contact/shear.hpp"

namespace trilith {

/// Memory of a law that needs only the memory common to all contacts.
template <class T>
struct NoMemory {
  template <class F>
  TRILITH_INLINE void fields(F&& /*two*/) {}
};

/// Gaps at the ends of one half that determine its stresses, including the mortar that fills it [m].
struct HalfGaps {
  double g0, g1;
  Filling<double> filling;
};

/// Elastic normal force of one half and its moment about the half's start [N], [N m].
struct HalfPressure {
  double force = 0, moment = 0;
};

/// Pressure over a section with linear overlap and closing speed, with damping and of the springs alone. Divided by the
/// stiffness, relative to the section's length.
template <class T>
struct StretchPressure {
  LinearStress<T> total, spring;
};

/// Events of a joint between two instants.
struct JointChange {
  bool broken = false, cracked = false, crushed = false;
};

/// Energy that a contact releases when it is no longer a face contact [J].
struct ShapeLoss {
  double friction = 0, fracture = 0;
};

/// Stiffness of a contact: upper bound of its tangent [N/m per m of length], and its damping [s].
struct ContactTangent {
  double normal, shear, beta;
};

struct Coulomb {
  double kn, ks;    ///< [N/m per m of length]
  double mu, beta;  ///< [1], [s]
  double dt;        ///< the step [s]

  template <class L>
  Coulomb(const L& law, double thickness, double step)
      : kn(law.kn * thickness), ks(law.ks * thickness), mu(law.mu), beta(law.beta), dt(step) {}

  static constexpr bool bonds = false;    ///< may transmit tension between faces
  static constexpr bool crushes = false;  ///< may lose depth permanently
  static constexpr int parts = 1;         ///< of each half that soften separately
  static constexpr bool linear = true;    ///< pressure proportional to the overlap
  template <class T>
  using Memory = NoMemory<T>;

  // --- of two faces, in order of calls ---

  template <class T, class M>
  TRILITH_INLINE T begin(FaceHalves<T>& /*halves*/, const FaceMemory<T>& /*before*/, const M& /*own*/,
                         M& /*after*/) const {
    return T{};
  }
  template <class T>
  TRILITH_INLINE void press(const HalfState<T>* halves, T* active, HalfResponse<T>* out) const;
  template <class T>
  TRILITH_INLINE T slide(HalfState<T>& half, T active, const ShearBefore<T>& before, HalfResponse<T>& out) const;
  /// Like slide, for a half with the shear limit `limit` [N] if it is not bonded.
  template <class T>
  TRILITH_INLINE T slide_within(T limit, HalfState<T>& half, T active, const ShearBefore<T>& before,
                                HalfResponse<T>& out) const;
  template <class T, class M>
  TRILITH_INLINE T end(const FaceHalves<T>& /*halves*/, const FaceMemory<T>& /*before*/, const M& /*own*/,
                       FaceMemory<T>& /*memory*/, M& /*after*/) const {
    return T{};
  }
  /// Work of sliding against the pressure as it opens the joint [J].
  template <class T, class M>
  TRILITH_INLINE T lifting(const FaceHalves<T>& /*halves*/, const FaceMemory<T>& /*before*/,
                           const FaceMemory<T>& /*memory*/, const M& /*own*/, const HalfResponse<T>* /*s*/,
                           M& /*after*/) const {
    return T{};
  }
  /// True where the step began or ended a state that is reported.
  template <class T, class M>
  TRILITH_INLINE static Mask<T> changes(const FaceMemory<T>& /*before*/, const M& /*own*/,
                                        const FaceMemory<T>& /*memory*/, const M& /*after*/) {
    return Mask<T>{};
  }
  /// True where the memory is kept even when the faces separate.
  template <class T, class M>
  TRILITH_INLINE static Mask<T> keeps(const M& /*own*/) {
    return Mask<T>{};
  }

  // --- of a general contact ---

  /// The overlap at which a linear spring of stiffness kn has the law's pressure at `overlap` [m].
  [[nodiscard]] double effective(double overlap) const { return overlap; }
  /// Coefficient of friction under a mean pressure [Pa] at a slip speed [m/s].
  [[nodiscard]] double friction(double /*pressure*/, double /*speed*/) const { return mu; }
  /// Depths d [m] and closing speeds c [m/s] at both ends of a section.
  template <class T>
  [[nodiscard]] TRILITH_INLINE StretchPressure<T> stretch(T d0, T d1, T c0, T c1) const;
  /// Integral of the pressure over kn over a triangle with the given area and depths at its corners.
  [[nodiscard]] static double over(double area, double d0, double d1, double d2) { return area * (d0 + d1 + d2) / 3; }

  // --- readings ---

  /// Both halves of the shared length.
  template <class M>
  [[nodiscard]] static std::array<HalfGaps, 2> gaps(const FaceOverlap<double>& o, const ContactMemory& /*m*/,
                                                    const M& /*own*/) {
    const double mid = 0.5 * (o.gap_lo + o.gap_hi);
    return {{{o.gap_lo, mid, {}}, {mid, o.gap_hi, {}}}};
  }
  /// Opening by the slip of the last step, which acts from the next step on [m].
  template <class M>
  [[nodiscard]] static double opening_to_come(const M& /*own*/) {
    return 0;
  }
  /// Stiffness share of the bond of a part of a half where open: 1 if intact, 0 without a bond.
  template <class M>
  [[nodiscard]] static double hold(const ContactMemory& /*m*/, const M& /*own*/, int /*half*/, int /*part*/) {
    return 0;
  }
  /// Elastic energy of one half [J].
  [[nodiscard]] double stored(const HalfGaps& gaps, double length, double hold) const;
  [[nodiscard]] HalfPressure pressure(const HalfGaps& gaps, double length, double hold) const;
  /// At an overlap of `depth` [m] or less.
  [[nodiscard]] ContactTangent tangent(double /*depth*/) const { return {kn, ks, beta}; }
  /// For two faces whose contact continues as a general one.
  template <class M>
  [[nodiscard]] ShapeLoss leave_faces(const FaceOverlap<double>& /*o*/, const ContactMemory& /*m*/,
                                      const M& /*own*/) const {
    return {};
  }

  // --- queries about the memory ---

  template <class M>
  [[nodiscard]] static M parted(const M& /*own*/) {
    return {};
  }
  template <class M>
  [[nodiscard]] static double crushed(const M& /*own*/) {
    return 0;
  }
  template <class M>
  [[nodiscard]] static double damage(const M& /*own*/, int /*half*/) {
    return 0;
  }
  template <class M>
  [[nodiscard]] static JointChange change(const ContactMemory& /*before*/, const M& /*own*/,
                                          const ContactMemory& /*now*/, const M& /*after*/) {
    return {};
  }
};

/// The gaps of the present stresses of a law. Opening by the slip of the last step does not act yet.
template <class K, class M>
[[nodiscard]] std::array<HalfGaps, 2> stressed_gaps(const K& law, const FaceOverlap<double>& o, const ContactMemory& m,
                                                    const M& own) {
  std::array<HalfGaps, 2> gaps = law.gaps(o, m, own);
  const double to_come = law.opening_to_come(own);
  for (HalfGaps& half : gaps) half.g0 += to_come, half.g1 += to_come;
  return gaps;
}

/// Gaps of the part [from, to] of a half, in units of the half.
inline HalfGaps part_of_half(const HalfGaps& half, double from, double to) {
  const double rise = half.g1 - half.g0, width = to - from;
  HalfGaps part{half.g0 + from * rise, half.g0 + to * rise, {}};
  const Filling<double>& f = half.filling;
  const double begin = std::max(f.from, from), end = std::min(f.to, to);
  if (!(end > begin)) return part;
  const double slope = (f.w1 - f.w0) / (f.to - f.from);
  part.filling.from = (begin - from) / width, part.filling.to = (end - from) / width;
  part.filling.w0 = f.w0 + slope * (begin - f.from), part.filling.w1 = f.w0 + slope * (end - f.from);
  return part;
}

/// Calls f(gaps, start, width, hold) for each part of a half that softens separately, as far as it lies in [from, to].
/// `start`, `width`: of this piece, in units of the half.
template <class K, class M, class F>
void each_part(const K& law, const HalfGaps& half, const ContactMemory& m, const M& own, int which, double from,
               double to, F&& f) {
  for (int part = 0; part < K::parts; ++part) {
    const double a = std::max(from, static_cast<double>(part) / K::parts);
    const double b = std::min(to, static_cast<double>(part + 1) / K::parts);
    if (!(b > a)) continue;
    const bool whole = a == 0 && b == 1;
    f(whole ? half : part_of_half(half, a, b), a, b - a, law.hold(m, own, which, part));
  }
}

/// Elastic energy of a half of `length` [m], with the bond of its memory [J].
template <class K, class M>
[[nodiscard]] double stored_in_half(const K& law, const HalfGaps& half, double length, const ContactMemory& m,
                                    const M& own, int which) {
  double sum = 0;
  each_part(law, half, m, own, which, 0, 1, [&](const HalfGaps& gaps, double /*start*/, double width, double hold) {
    sum += law.stored(gaps, width * length, hold);
  });
  return sum;
}

/// Elastic normal force of the part [from, to] of a half of `length` [m], and its moment about the start of the half.
template <class K, class M>
[[nodiscard]] HalfPressure pressure_of_half(const K& law, const HalfGaps& half, double length, const ContactMemory& m,
                                            const M& own, int which, double from = 0, double to = 1) {
  HalfPressure sum;
  each_part(law, half, m, own, which, from, to, [&](const HalfGaps& gaps, double start, double width, double hold) {
    const HalfPressure p = law.pressure(gaps, width * length, hold);
    sum.force += p.force, sum.moment += p.moment + start * length * p.force;
  });
  return sum;
}

/// Normal stress of one half, of its springs and with its damping: linear over the closed and over the pressed part.
template <class T>
struct HalfStress {
  LinearStress<T> elastic, total;
  TRILITH_INLINE HalfStress(const HalfState<T>& half, double beta, T closed_from, T closed_to, T from, T to)
      : elastic(between(-half.g0, -half.g1, closed_from, closed_to)),
        total(between(-half.g0 - beta * half.r0, -half.g1 - beta * half.r1, from, to)) {}
  /// For the function that is linear from p0 to p1 over the whole half.
  TRILITH_INLINE static LinearStress<T> between(T p0, T p1, T from, T to) {
    const T rise = p1 - p0;
    return {p0 + rise * from, p0 + rise * to, from, to};
  }
  TRILITH_INLINE void write(const HalfState<T>& half, double kn, HalfResponse<T>& out) const {
    const T scale = kn * half.length;
    out.normal = scale * total.sum;
    out.normal_moment = scale * half.length * total.moment;
    out.damping = out.normal - scale * elastic.sum;
    out.damping_moment = out.normal_moment - scale * half.length * elastic.moment;
  }
};

/// The closed part of both halves, and the part pressed including damping: no tension without a bond.
template <class T>
struct PressedHalves {
  PositiveHalves<T> closed, pressed;
  /// Gaps are linear over both halves together.
  TRILITH_INLINE PressedHalves(const HalfState<T>* h, double beta)
      : closed(-h[0].g0, -h[1].g1), pressed(-h[0].g0 - beta * h[0].r0, -h[1].g1 - beta * h[1].r1) {}
  /// Each half has separate gaps.
  TRILITH_INLINE void apart(const HalfState<T>* h, double beta) {
    const HalfState<T>&first = h[0], &second = h[1];
    closed = {-first.g0, -first.g1, -second.g0, -second.g1};
    pressed = {-first.g0 - beta * first.r0, -first.g1 - beta * first.r1, -second.g0 - beta * second.r0,
               -second.g1 - beta * second.r1};
  }
  [[nodiscard]] TRILITH_INLINE T from(int h) const { return larger(pressed.from[h], closed.from[h]); }
  [[nodiscard]] TRILITH_INLINE T to(int h) const { return larger(from(h), smaller(pressed.to[h], closed.to[h])); }
};

template <class T>
TRILITH_INLINE void Coulomb::press(const HalfState<T>* halves, T* active, HalfResponse<T>* out) const {
  const PressedHalves<T> areas(halves, beta);
  for (const int h : {0, 1}) {
    const HalfStress<T> stress(halves[h], beta, areas.closed.from[h], areas.closed.to[h], areas.from(h), areas.to(h));
    active[h] = areas.closed.to[h] - areas.closed.from[h];
    stress.write(halves[h], kn, out[h]);
  }
}

/// Kelvin-Voigt spring in series with a Coulomb slider, which a bond locks; the damping acts on the elastic part only.
/// `active`: length that carries shear [m].
template <class T>
TRILITH_INLINE T Coulomb::slide(HalfState<T>& half, T active, const ShearBefore<T>& before,
                                HalfResponse<T>& out) const {
  return slide_within<T>(mu * larger(out.normal, T{}), half, active, before, out);
}

template <class T>
TRILITH_INLINE T Coulomb::slide_within(T friction_limit, HalfState<T>& half, T active, const ShearBefore<T>& before,
                                       HalfResponse<T>& out) const {
  const T zero{};
  const ShearTrial<T> trial(half, ks, beta, dt, active, before);
  const T limit = select(half.bonded, zero + 1e300, friction_limit);
  const T held = select(trial.total < zero, -limit, limit);
  const double share = dt > 0 ? dt / (dt + beta) : 0.0;
  const T slid = trial.kept + (held - trial.kept) * share;
  end_shear(trial, active, before, magnitude(trial.total) > limit, held, slid, out);
  return zero;
}

template <class T>
TRILITH_INLINE StretchPressure<T> Coulomb::stretch(T d0, T d1, T c0, T c1) const {
  const T zero{}, one = zero + 1.0;
  const T p0 = d0 + beta * c0, p1 = d1 + beta * c1;
  const PositivePart<T> part(p0, p1);
  const T q0 = p0 + (p1 - p0) * part.from, q1 = p0 + (p1 - p0) * part.to;
  return {{q0, q1, part.from, part.to}, {d0, d1, zero, one}};
}

/// kn/2 times the integral of g^2 over the closed part, plus the bond's share over the whole half.
inline double Coulomb::stored(const HalfGaps& gaps, double length, double hold) const {
  const double g0 = gaps.g0, g1 = gaps.g1;
  const PositivePart<double> part(-g0, -g1);
  const double d0 = -g0 - (g1 - g0) * part.from, d1 = -g0 - (g1 - g0) * part.to;
  const double closed = (part.to - part.from) * (d0 * d0 + d0 * d1 + d1 * d1), all = g0 * g0 + g0 * g1 + g1 * g1;
  const double mortar = 3 * gaps.filling.product(g0, g1, g0, g1);
  return kn * length * (closed + hold * (all + mortar - closed)) / 6;
}

inline HalfPressure Coulomb::pressure(const HalfGaps& gaps, double length, double hold) const {
  const double c0 = -gaps.g0, c1 = -gaps.g1;
  const PositivePart<double> closed(c0, c1);
  const double slope = c1 - c0;
  LinearStress<double> stress(c0 + slope * closed.from, c0 + slope * closed.to, closed.from, closed.to);
  LinearStress<double> bond(c0, c1, 0, 1);
  add(bond, gaps.filling.stress(), hold > 0);
  mix(stress, bond, hold);
  return {kn * length * stress.sum, kn * length * length * stress.moment};
}

/// Linear pressure and Coulomb friction alone, for which closed forms exist. No law's kernel converts to it;
/// plain_friction() in law/contact/list.hpp makes it from a law's parameters.
struct PlainFriction final : Coulomb {
  using Coulomb::Coulomb;
};

}  // namespace trilith
