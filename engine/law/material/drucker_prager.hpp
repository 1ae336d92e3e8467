// Drucker-Prager plasticity: a circular cone with a cut-off of the mean tension, perfectly plastic.
//
// Yield conditions: sqrt(J2) + eta p <= xi cohesion and p <= tension, p the mean stress, tension positive. With eta and
// xi the cone gives the collapse loads of Mohr-Coulomb in plane strain (de Souza Neto, Peric and Owen, "Computational
// Methods for Plasticity", 2008, sec. 6.4.4 and 8.3). Without a cut-off the cone ends at its apex. In plane stress the
// out-of-plane strain is found such that the out-of-plane stress vanishes.
#pragma once

#include "law/material/mohr_coulomb.hpp"

namespace trilith {

struct DruckerPrager {
  double young = 0;             ///< [Pa]
  double poisson = 0;           ///< [1]
  double cohesion = 0;          ///< [Pa]
  double friction = 0;          ///< [rad]
  double dilation = 0;          ///< [rad]
  double tension = no_cut_off;  ///< [Pa]
  double damping = 0;           ///< [s]

  static constexpr std::string_view name = "drucker_prager";
  static constexpr std::string_view sentence = "friction and cohesion on a round cone with a cut-off of mean tension";
  static constexpr bool is_elastic = false;
  static constexpr bool acts_across = true;  ///< see law/material/tensor_form.hpp
  static constexpr auto parameters() {
    using P = Parameter<DruckerPrager>;
    return std::array{
        P{&DruckerPrager::young, "E", "Pa", no_default, 0, unbounded, false, "Young's modulus"},
        P{&DruckerPrager::poisson, "nu", "1", 0, 0, 0.499, true, "Poisson's ratio"},
        P{&DruckerPrager::cohesion, "cohesion", "Pa", no_default, 0, unbounded, true, "shear strength at no stress"},
        P{&DruckerPrager::friction, "friction_angle", "rad", no_default, 0, 1.5, true, "angle of friction"},
        P{&DruckerPrager::dilation, "dilation_angle", "rad", 0, 0, 1.5, true,
          "angle of dilation, at most the angle of friction"},
        P{&DruckerPrager::tension, "tension", "Pa", no_cut_off, 0, unbounded, true,
          "largest mean tension; 1e12: no cut-off"},
        P{&DruckerPrager::damping, "beta", "s", 0, 0, 1, true, "damping stress over elastic stress of strain rate"}};
  }

  /// Throws InputError where the dilation exceeds the friction, or the strength is 0.
  void check() const;
  /// The larger excess over the two yield limits [Pa].
  [[nodiscard]] double excess(const Stress& stress) const;
  [[nodiscard]] PointResponse respond(Plane plane, const PlaneVector& strain, const PlasticMemory& before) const;
};

}  // namespace trilith
