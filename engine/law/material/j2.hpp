// Metal plasticity: von Mises yield surface, associated flow, linear isotropic hardening.
//
// Yield function: f = sqrt(3 J2) - (yield + hardening e), with the equivalent plastic strain e. Return mapping: radial
// in plane strain (Simo and Hughes, "Computational Inelasticity", 1998, sec. 3.3). In plane stress it acts in the
// subspace of plane stress, with one scalar equation in the principal axes of the projection (Simo and Taylor, Int. J.
// Numer. Meth. Engng 22, 1986).
#pragma once

#include <array>

#include "base/schema.hpp"
#include "law/material/point.hpp"

namespace trilith {

struct J2 {
  double young = 0;      ///< [Pa]
  double poisson = 0;    ///< [1]
  double yield = 0;      ///< [Pa]
  double hardening = 0;  ///< [Pa]
  double damping = 0;    ///< [s]

  static constexpr std::string_view name = "j2";
  static constexpr std::string_view sentence = "von Mises plasticity with linear hardening";
  static constexpr bool is_elastic = false;
  static constexpr bool acts_across = true;  ///< see law/material/tensor_form.hpp
  static constexpr auto parameters() {
    using P = Parameter<J2>;
    return std::array{
        P{&J2::young, "E", "Pa", no_default, 0, unbounded, false, "Young's modulus"},
        P{&J2::poisson, "nu", "1", 0, 0, 0.499, true, "Poisson's ratio"},
        P{&J2::yield, "yield", "Pa", no_default, 0, unbounded, false, "yield stress in tension"},
        P{&J2::hardening, "hardening", "Pa", 0, 0, unbounded, true, "yield stress gained per plastic strain"},
        P{&J2::damping, "beta", "s", 0, 0, 1, true, "damping stress over elastic stress of strain rate"}};
  }

  /// sqrt(3 J2) minus the yield stress at the equivalent plastic strain `measure` [Pa].
  [[nodiscard]] double excess(const Stress& stress, double measure) const;
  [[nodiscard]] PointResponse respond(Plane plane, const PlaneVector& strain, const PlasticMemory& before) const;
};

}  // namespace trilith
