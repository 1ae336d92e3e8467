// The kernel that the laws begin with: pressure in proportion to the overlap, damping, Coulomb friction, no memory.
//
// A law's kernel is its equations with its numbers made ready for one step: those of the law times the model's
// thickness. The driver of contact/plane/face_pair.hpp asks it, half by half of two faces, in this order:
//   begin   what the new gaps do to bond and mortar      -> energy given off
//   press   gaps and rates                               -> normal stress, its damping part, length that carries
//   slide   slip and normal force                        -> shear                -> energy given off
//   end     what is left of bond and mortar              -> memory               -> energy given off
// Polygons of any shape in the plane ask `stretch`, `over` and `slide`; flat faces, polyhedra and spheres in space ask
// `effective` and `friction`. Readings ask `gaps`, `hold`, `stored`, `pressure`, `tangent` and the questions below.
//
// A law that is pressure by overlap and friction by pressure and slip speed has `effective` or `friction` of its own on
// law/contact/point_law.hpp, which makes the rest of them: it acts in every geometry. See law/contact/power.hpp for a
// short one. law/contact/law_forms.hpp tells at compile time in which geometries the equations of a kernel act.
#pragma once

#include <algorithm>
#include <array>

#include "law/contact/face_motion.hpp"
#include "law/contact/memory.hpp"
#include "law/contact/shear.hpp"

namespace trilith {

/// A law that remembers nothing but what every contact does.
template <class T>
struct NoMemory {
  template <class F>
  TRILITH_INLINE void fields(F&& /*two*/) {}
};

/// Gaps of one half that its stresses come from, at its ends, with the mortar that fills it [m].
struct HalfGaps {
  double g0, g1;
  Filling<double> filling;
};

/// Elastic normal force of one half and its moment about the half's start [N], [N m].
struct HalfPressure {
  double force = 0, moment = 0;
};

/// Pressure over a stretch on which overlap and closing speed are linear: with its damping, and of the springs alone.
/// Over the stiffness, in shares of the stretch.
template <class T>
struct StretchPressure {
  LinearStress<T> total, spring;
};

/// What happens to a joint between two instants.
struct JointChange {
  bool broken = false, cracked = false, crushed = false;
};

/// Energy that a contact lets go as it stops to be one of faces [J].
struct ShapeLoss {
  double friction = 0, fracture = 0;
};

/// How stiff a contact is: the most that its tangent can be [N/m per m of length], and its damping [s].
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

  static constexpr bool bonds = false;    ///< may hold faces together
  static constexpr bool crushes = false;  ///< may lose depth for good
  static constexpr bool linear = true;    ///< its pressure goes with the overlap
  template <class T>
  using Memory = NoMemory<T>;

  // --- of two faces, in their order ---

  template <class T, class M>
  TRILITH_INLINE T begin(FaceHalves<T>& /*halves*/, const FaceMemory<T>& /*before*/, const M& /*own*/,
                         M& /*after*/) const {
    return T{};
  }
  template <class T>
  TRILITH_INLINE void press(const HalfState<T>* halves, T* active, HalfResponse<T>* out) const;
  template <class T>
  TRILITH_INLINE T slide(HalfState<T>& half, T active, const ShearBefore<T>& before, HalfResponse<T>& out) const;
  /// As slide, of a half that holds a shear of `limit` [N] at most, if it is not bonded.
  template <class T>
  TRILITH_INLINE T slide_within(T limit, HalfState<T>& half, T active, const ShearBefore<T>& before,
                                HalfResponse<T>& out) const;
  template <class T, class M>
  TRILITH_INLINE T end(const FaceHalves<T>& /*halves*/, const FaceMemory<T>& /*before*/, const M& /*own*/,
                       FaceMemory<T>& /*memory*/, M& /*after*/) const {
    return T{};
  }
  /// Work that sliding does against the pressure as it opens the joint [J].
  template <class T, class M>
  TRILITH_INLINE T lifting(const FaceMemory<T>& /*before*/, const FaceMemory<T>& /*memory*/, const M& /*own*/,
                           const HalfResponse<T>* /*s*/) const {
    return T{};
  }
  /// True where the step began or ended something that is told.
  template <class T, class M>
  TRILITH_INLINE static Mask<T> changes(const FaceMemory<T>& /*before*/, const M& /*own*/,
                                        const FaceMemory<T>& /*memory*/, const M& /*after*/) {
    return Mask<T>{};
  }
  /// True where something is remembered even when the faces part.
  template <class T, class M>
  TRILITH_INLINE static Mask<T> keeps(const M& /*own*/) {
    return Mask<T>{};
  }

  // --- of a contact of any shape ---

  /// The overlap at which a linear spring of stiffness kn would press as much as the law does at `overlap` [m].
  [[nodiscard]] double effective(double overlap) const { return overlap; }
  /// Coefficient of friction under a mean pressure [Pa] at a slip speed [m/s].
  [[nodiscard]] double friction(double /*pressure*/, double /*speed*/) const { return mu; }
  /// Depths d and closing speeds c at both ends of a stretch [m], [m/s].
  template <class T>
  [[nodiscard]] TRILITH_INLINE StretchPressure<T> stretch(T d0, T d1, T c0, T c1) const;
  /// Integral of the pressure over kn over a triangle of the given area with these depths at its corners.
  [[nodiscard]] static double over(double area, double d0, double d1, double d2) { return area * (d0 + d1 + d2) / 3; }

  // --- readings ---

  /// Both halves of the shared length.
  template <class M>
  [[nodiscard]] static std::array<HalfGaps, 2> gaps(const FaceOverlap<double>& o, const ContactMemory& /*m*/,
                                                    const M& /*own*/) {
    const double mid = 0.5 * (o.gap_lo + o.gap_hi);
    return {{{o.gap_lo, mid, {}}, {mid, o.gap_hi, {}}}};
  }
  /// Share of its stiffness that the bond of a half holds where open: 1 where sound, 0 where there is none.
  template <class M>
  [[nodiscard]] static double hold(const ContactMemory& /*m*/, const M& /*own*/, int /*half*/) {
    return 0;
  }
  /// Elastic energy of one half [J].
  [[nodiscard]] double stored(const HalfGaps& gaps, double length, double hold) const;
  [[nodiscard]] HalfPressure pressure(const HalfGaps& gaps, double length, double hold) const;
  /// At an overlap of `depth` [m] or less.
  [[nodiscard]] ContactTangent tangent(double /*depth*/) const { return {kn, ks, beta}; }
  /// Of two faces whose contact goes on as one of general shape.
  template <class M>
  [[nodiscard]] ShapeLoss leave_faces(const FaceOverlap<double>& /*o*/, const ContactMemory& /*m*/,
                                      const M& /*own*/) const {
    return {};
  }

  // --- questions about what it remembers ---

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

/// Normal stress of one half, of its springs and with its damping: linear where closed and where still pressed.
template <class T>
struct HalfStress {
  LinearStress<T> elastic, total;
  TRILITH_INLINE HalfStress(const HalfState<T>& half, double beta, T closed_from, T closed_to, T from, T to)
      : elastic(between(-half.g0, -half.g1, closed_from, closed_to)),
        total(between(-half.g0 - beta * half.r0, -half.g1 - beta * half.r1, from, to)) {}
  /// Of the function that is linear from p0 to p1 over all of the half.
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

/// Where both halves are closed, and pressed with their damping: never pulling without a bond.
template <class T>
struct PressedHalves {
  PositiveHalves<T> closed, pressed;
  /// Gaps are linear over both.
  TRILITH_INLINE PressedHalves(const HalfState<T>* h, double beta)
      : closed(-h[0].g0, -h[1].g1), pressed(-h[0].g0 - beta * h[0].r0, -h[1].g1 - beta * h[1].r1) {}
  /// Each half has gaps of its own.
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
  const PressedHalves<T> parts(halves, beta);
  for (const int h : {0, 1}) {
    const HalfStress<T> stress(halves[h], beta, parts.closed.from[h], parts.closed.to[h], parts.from(h), parts.to(h));
    active[h] = parts.closed.to[h] - parts.closed.from[h];
    stress.write(halves[h], kn, out[h]);
  }
}

/// Kelvin-Voigt spring in series with a Coulomb slider, which a bond holds; the damping acts on the elastic part only.
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

/// kn/2 of the integral of g^2, where closed, and of the share a bond holds all along.
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

/// Pressure in proportion to the overlap and Coulomb friction, and nothing else: what closed forms are made for. No
/// kernel of a law turns into it; plain_friction() of law/contact/list.hpp makes it from the numbers of a law.
struct PlainFriction final : Coulomb {
  using Coulomb::Coulomb;
};

}  // namespace trilith
