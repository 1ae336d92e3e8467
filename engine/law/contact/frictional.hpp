// Purely frictional contact: linear in the overlap, no tension, Coulomb friction in shear.
//
// sigma = kn (delta + beta d(delta)/dt), never below 0; |tau| <= mu sigma. Barbosa, "Discontinuous structural
// analysis", eqs. 3 to 5 and the paragraph on damping stresses.
#pragma once

#include <array>

#include "base/schema.hpp"
#include "law/contact/coulomb.hpp"

namespace trilith {

struct Frictional {
  double kn = 0;    ///< [Pa/m]
  double ks = 0;    ///< [Pa/m]
  double mu = 0;    ///< tan of the friction angle
  double beta = 0;  ///< [s]

  static constexpr std::string_view name = "frictional";
  static constexpr std::string_view sentence = "contact without bond: pressure from overlap, Coulomb friction";
  static constexpr auto parameters() {
    using P = Parameter<Frictional>;
    return std::array{
        P{&Frictional::kn, "kn", "Pa/m", no_default, 0, unbounded, false, "normal stiffness, stress per overlap"},
        P{&Frictional::ks, "ks", "Pa/m", no_default, 0, unbounded, true, "shear stiffness, stress per elastic slip"},
        P{&Frictional::mu, "mu", "1", no_default, 0, 100, true, "friction coefficient, tan of the friction angle"},
        P{&Frictional::beta, "beta", "s", 0, 0, 1, true, "damping stress per stiffness and velocity"}};
  }

  using Kernel = Coulomb;
};

}  // namespace trilith
