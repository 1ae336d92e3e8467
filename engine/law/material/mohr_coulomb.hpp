// Mohr-Coulomb plasticity (friction and cohesion) with a tension cut-off, perfectly plastic.
//
// Yield conditions: (s1 - s3) + (s1 + s3) sin(friction) <= 2 cohesion cos(friction) and s1 <= tension, for principal
// stresses s1 >= s2 >= s3, tension positive. The flow of the first uses the dilation angle; the cut-off is associated.
// Return mapping: law/material/principal_return.hpp (de Souza Neto, Peric and Owen, "Computational Methods for
// Plasticity", 2008, sec. 8.2; in plane stress one principal stress stays 0).
#pragma once

#include <array>

#include "base/schema.hpp"
#include "law/material/point.hpp"

namespace trilith {

/// Above any strength: no cut-off [Pa].
inline constexpr double no_cut_off = 1e12;

struct MohrCoulomb {
  double young = 0;             ///< [Pa]
  double poisson = 0;           ///< [1]
  double cohesion = 0;          ///< [Pa]
  double friction = 0;          ///< [rad]
  double dilation = 0;          ///< [rad]
  double tension = no_cut_off;  ///< [Pa]
  double damping = 0;           ///< [s]

  static constexpr std::string_view name = "mohr_coulomb";
  static constexpr std::string_view sentence = "friction and cohesion with a tension cut-off";
  static constexpr bool is_elastic = false;
  static constexpr bool acts_across = true;  ///< see law/material/tensor_form.hpp
  static constexpr auto parameters() {
    using P = Parameter<MohrCoulomb>;
    return std::array{
        P{&MohrCoulomb::young, "E", "Pa", no_default, 0, unbounded, false, "Young's modulus"},
        P{&MohrCoulomb::poisson, "nu", "1", 0, 0, 0.499, true, "Poisson's ratio"},
        P{&MohrCoulomb::cohesion, "cohesion", "Pa", no_default, 0, unbounded, true, "shear strength at no stress"},
        P{&MohrCoulomb::friction, "friction_angle", "rad", no_default, 0, 1.5, true, "angle of friction"},
        P{&MohrCoulomb::dilation, "dilation_angle", "rad", 0, 0, 1.5, true,
          "angle of dilation, at most the angle of friction"},
        P{&MohrCoulomb::tension, "tension", "Pa", no_cut_off, 0, unbounded, true, "largest tension; 1e12: no cut-off"},
        P{&MohrCoulomb::damping, "beta", "s", 0, 0, 1, true, "damping stress over elastic stress of strain rate"}};
  }

  /// Throws InputError where the dilation exceeds the friction, or the strength is 0.
  void check() const;
  /// The larger excess over the two yield limits [Pa].
  [[nodiscard]] double excess(const Stress& stress) const;
  [[nodiscard]] PointResponse respond(Plane plane, const PlaneVector& strain, const PlasticMemory& before) const;
};

}  // namespace trilith
