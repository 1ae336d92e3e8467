// Bonded faces: tension up to a limit, cohesion; the bond once lost leaves friction.
//
// A bond carries sigma = kn delta in both signs. It is lost where the tension exceeds `tension` or the shear stress
// exceeds cohesion + sigma mu (Barbosa, "Discontinuous structural analysis"). Cohesion and tension are independent:
// in tension
// the shear strength falls along the Coulomb line to the tensile strength, or, where that is beyond the line's apex
// cohesion/mu, along the line from cohesion to tension.
#pragma once

#include <array>

#include "base/schema.hpp"
#include "contact/face_law.hpp"

namespace trilith {

struct Bonded {
  double kn = 0;             ///< [Pa/m]
  double ks = 0;             ///< [Pa/m]
  double mu = 0;             ///< tan of the friction angle
  double beta = 0;           ///< [s]
  double cohesion = 0;       ///< [Pa]
  double tension = 0;        ///< [Pa]
  double loss_by_point = 0;  ///< 0: one point beyond its limit frees the whole face; 1: frees its half

  static constexpr std::string_view name = "bonded";
  static constexpr std::string_view sentence = "contact with cohesion and tensile strength until the bond is lost";
  static constexpr Bond bond = Bond::brittle;
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

  /// A plain word on numbers that are allowed but may surprise; empty where there is none.
  [[nodiscard]] std::string note() const {
    if (!(mu * tension > cohesion)) return "";
    return fmt::format(
        "tension {:g} Pa is above cohesion/mu = {:g} Pa, the apex of the Coulomb line; in tension the shear strength "
        "falls in a line from cohesion to 0 at the tensile strength",
        tension, cohesion / mu);
  }
};

}  // namespace trilith
