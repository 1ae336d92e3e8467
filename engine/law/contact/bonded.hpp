// Bonded faces: tension up to a limit, and cohesion; after the loss of the bond friction remains.
//
// A bond carries sigma = kn delta in both signs. It is lost where the tension exceeds `tension` or the shear stress
// exceeds cohesion + sigma mu (Barbosa, "Discontinuous structural analysis"). Cohesion and tension are independent. In
// tension the shear strength falls along the Coulomb line to the tensile strength. If this is beyond the line's apex
// cohesion/mu, it falls along the line from cohesion to tension.
#pragma once

#include <array>

#include "base/schema.hpp"
#include "law/contact/mortar.hpp"

namespace trilith {

struct Bonded {
  double kn = 0;             ///< [Pa/m]
  double ks = 0;             ///< [Pa/m]
  double mu = 0;             ///< tan of the friction angle
  double beta = 0;           ///< [s]
  double cohesion = 0;       ///< [Pa]
  double tension = 0;        ///< [Pa]
  double loss_by_point = 0;  ///< 0: one point beyond its limit releases the whole face; 1: releases its half

  static constexpr std::string_view name = "bonded";
  static constexpr std::string_view sentence = "contact with cohesion and tensile strength until the bond is lost";
  static constexpr auto parameters() {
    using P = Parameter<Bonded>;
    return std::array{
        P{&Bonded::kn, "kn", "Pa/m", no_default, 0, unbounded, false, "normal stiffness, stress per overlap"},
        P{&Bonded::ks, "ks", "Pa/m", no_default, 0, unbounded, true, "shear stiffness, stress per elastic slip"},
        P{&Bonded::mu, "mu", "1", no_default, 0, 100, true, "friction coefficient, tan of the friction angle"},
        P{&Bonded::beta, "beta", "s", 0, 0, 1, true, "damping stress per stiffness and velocity"},
        P{&Bonded::cohesion, "cohesion", "Pa", no_default, 0, unbounded, true, "shear strength at no normal stress"},
        P{&Bonded::tension, "tension", "Pa", no_default, 0, unbounded, true, "tensile strength of the bond"},
        P{&Bonded::loss_by_point, "loss_by_point", "1", 0, 0, 1, true,
          "0: the whole face fails at once, 1: each half for itself"}};
  }

  /// A note on parameters that are allowed but may surprise; empty if there is none.
  [[nodiscard]] std::string note() const {
    if (!(mu * tension > cohesion)) return "";
    return fmt::format(
        "tension {:g} Pa is above cohesion/mu = {:g} Pa, the apex of the Coulomb line; in tension the shear strength "
        "falls in a line from cohesion to 0 at the tensile strength",
        tension, cohesion / mu);
  }

  struct Kernel;
};

/// A brittle bond: intact or lost, uniformly over a half.
struct Bonded::Kernel : Mortar {
  bool by_point;

  Kernel(const Bonded& law, double thickness, double step)
      : Mortar(law, thickness, step), by_point(law.loss_by_point != 0) {}

  using FrictionRemains = Kernel;  ///< see law/contact/law_forms.hpp
  using JointForm = Kernel;

  template <class T>
  struct Memory {
    T set[2]{};  ///< gaps at both ends of the shared length when the mortar set; it fills open ones [m]
    template <class F>
    TRILITH_INLINE void fields(F&& two) {
      two(set[0], set[1]);
    }
  };

  template <class T>
  TRILITH_INLINE T begin(FaceHalves<T>& halves, const FaceMemory<T>& before, const Memory<T>& own,
                         Memory<T>& after) const {
    fill(halves, own.set);
    for (const int end : {0, 1}) after.set[end] = own.set[end];
    return lose_bonds(halves.half, before.shear_elastic);
  }
  template <class T>
  TRILITH_INLINE void press(const HalfState<T>* halves, T* active, HalfResponse<T>* out) const;
  template <class T>
  TRILITH_INLINE static Mask<T> changes(const FaceMemory<T>& before, const Memory<T>& /*own*/,
                                        const FaceMemory<T>& memory, const Memory<T>& /*after*/) {
    return (before.bonds[0] != memory.bonds[0]) | (before.bonds[1] != memory.bonds[1]);
  }

  [[nodiscard]] static std::array<HalfGaps, 2> gaps(const FaceOverlap<double>& o, const ContactMemory& /*m*/,
                                                    const Memory<double>& own) {
    const double mid = 0.5 * (o.gap_lo + o.gap_hi);
    const JointFilling<double> mortar(own.set[0], own.set[1]);
    return {{{o.gap_lo, mid, mortar.half[0]}, {mid, o.gap_hi, mortar.half[1]}}};
  }
  [[nodiscard]] static double hold(const ContactMemory& m, const Memory<double>& /*own*/, int half, int /*part*/) {
    return m.bonded(half) ? 1 : 0;
  }
  [[nodiscard]] static JointChange change(const ContactMemory& before, const Memory<double>& /*own*/,
                                          const ContactMemory& now, const Memory<double>& /*after*/) {
    return {before.bonds != now.bonds};
  }
  /// A bond that sets now, at gaps of `lo` and `hi` at the ends of its faces [m].
  static void set_bond(Memory<double>& own, double lo, double hi) { own.set[0] = lo, own.set[1] = hi; }
  static void lift_bond(Memory<double>& /*own*/) {}

 private:
  template <class T>
  TRILITH_INLINE Mask<T> broken(const HalfState<T>& h, T shear_elastic) const;
  template <class T>
  TRILITH_INLINE T lose_bonds(HalfState<T>* h, const T* shear_elastic) const;
};

/// True where a half exceeds its limits (elastic stresses, trial shear): tension at either end, or shear over the whole
/// half, as for the friction that follows.
template <class T>
TRILITH_INLINE Mask<T> Bonded::Kernel::broken(const HalfState<T>& h, T shear_elastic) const {
  const T trial = magnitude(shear_elastic + ks * h.length * h.slip_mean * dt);
  const T open = mean_opening(h), closed = open - 0.5 * (h.g0 + h.g1) + h.filling.stress().sum;
  return h.bonded & exceeded(h.widest(), trial, shear_strength(closed, open), h.length);
}

/// Removes the bonds that exceed their limits; returns the dissipated energy [J]. During the step the force at its
/// beginning does work over half of the displacement, and none after the loss. With gaps p before and g now, stored
/// energy plus this work is kn/2 times the integral of p g over the part where both are open.
template <class T>
TRILITH_INLINE T Bonded::Kernel::lose_bonds(HalfState<T>* h, const T* shear_elastic) const {
  const T zero{};
  Mask<T> lost[2] = {broken(h[0], shear_elastic[0]), broken(h[1], shear_elastic[1])};
  if (!by_point) {
    const Mask<T> either = lost[0] | lost[1];
    lost[0] = h[0].bonded & either;
    lost[1] = h[1].bonded & either;
  }
  if (!any(lost[0] | lost[1])) return zero;
  T energy = zero;
  for (const int k : {0, 1}) {
    h[k].bonded = h[k].bonded & flip(lost[k]);
    energy += select(lost[k], 0.5 * kn * open_product(h[k], h[k].g0 - dt * h[k].m0, h[k].g1 - dt * h[k].m1), zero);
  }
  return energy;
}

/// Bonded over the whole half, including the mortar that fills it.
template <class T>
TRILITH_INLINE void Bonded::Kernel::press(const HalfState<T>* halves, T* active, HalfResponse<T>* out) const {
  const T zero{}, one = zero + 1.0;
  const PressedHalves<T> pressed(halves, beta);
  for (const int h : {0, 1}) {
    const HalfState<T>& half = halves[h];
    const Mask<T> bonded = half.bonded;
    const T closed_from = select(bonded, zero, pressed.closed.from[h]),
            closed_to = select(bonded, one, pressed.closed.to[h]);
    HalfStress<T> stress(half, beta, closed_from, closed_to, select(bonded, zero, pressed.from(h)),
                         select(bonded, one, pressed.to(h)));
    active[h] = closed_to - closed_from;
    const LinearStress<T> mortar = half.filling.stress();
    add(stress.elastic, mortar, bonded), add(stress.total, mortar, bonded);
    stress.write(half, kn, out[h]);
  }
}

}  // namespace trilith
