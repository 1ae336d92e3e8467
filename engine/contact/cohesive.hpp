// Mortar that cracks by and by: cohesion and tension soften with their fracture energies, friction remains.
//
// Peak strengths are those of the bonded Coulomb law; both soften together and linearly, see contact/face_bond.hpp for
// equations and sources. Each half of a face softens for itself. Unloading: to the origin where open, with ks in
// shear. Dilation (off unless given): sliding opens the joint by tan(angle) times the slip, up to a slip from which on
// the asperities are worn (limit as in Lourenco and Rots 1997); it ends where the faces part. Compressive cap (off
// unless given): see contact/face_crush.hpp; the depth crushed stays while the two bodies are near each other.
#pragma once

#include <array>

#include "base/schema.hpp"
#include "contact/face_law.hpp"

namespace trilith {

struct Cohesive {
  double kn = 0;                 ///< [Pa/m]
  double ks = 0;                 ///< [Pa/m]
  double mu = 0;                 ///< tan of the friction angle
  double beta = 0;               ///< [s]
  double cohesion = 0;           ///< [Pa]
  double tension = 0;            ///< [Pa]
  double energy_tension = 0;     ///< fracture energy of mode I [J/m2]
  double energy_shear = 0;       ///< fracture energy of mode II, beside friction [J/m2]
  double dilation = 0;           ///< tan of the dilatancy angle
  double dilation_slip = 0;      ///< [m]
  double compression = 0;        ///< [Pa]; 0: it does not crush
  double crushing_depth = 2e-3;  ///< [m]

  static constexpr std::string_view name = "cohesive";
  static constexpr std::string_view sentence = "mortar that softens in tension and shear by its fracture energies";
  static constexpr Bond bond = Bond::softening;
  static constexpr auto parameters() {
    using P = Parameter<Cohesive>;
    return std::array{
        P{&Cohesive::kn, "kn", "Pa/m", no_default, 0, unbounded, false, "normal stiffness, stress per overlap"},
        P{&Cohesive::ks, "ks", "Pa/m", no_default, 0, unbounded, false, "shear stiffness, stress per elastic slip"},
        P{&Cohesive::mu, "mu", "1", no_default, 0, 100, true, "friction coefficient, tan of the friction angle"},
        P{&Cohesive::beta, "beta", "s", 0, 0, 1, true, "damping stress per stiffness and velocity"},
        P{&Cohesive::cohesion, "cohesion", "Pa", no_default, 0, unbounded, false, "shear strength at no normal stress"},
        P{&Cohesive::tension, "tension", "Pa", no_default, 0, unbounded, false, "tensile strength of the bond"},
        P{&Cohesive::energy_tension, "energy_tension", "J/m2", no_default, 0, unbounded, false,
          "fracture energy in tension (mode I)"},
        P{&Cohesive::energy_shear, "energy_shear", "J/m2", no_default, 0, unbounded, false,
          "fracture energy in shear (mode II), what friction takes not counted"},
        P{&Cohesive::dilation, "dilation", "1", 0, 0, 10, true, "opening per slip, tan of the dilatancy angle"},
        P{&Cohesive::dilation_slip, "dilation_slip", "m", 0, 0, unbounded, true, "slip up to which the joint dilates"},
        P{&Cohesive::compression, "compression", "Pa", 0, 0, unbounded, true,
          "compressive strength, at which the mortar crushes; 0: it does not"},
        P{&Cohesive::crushing_depth, "crushing_depth", "m", 2e-3, 0, unbounded, false,
          "depth by which it can crush before it is as stiff as ever, a share of the joint's thickness"}};
  }

  /// What the ranges above leave: an energy that the elastic energy at the peak already exceeds cannot soften.
  /// Throws InputError.
  void check() const {
    const auto require = [](double energy, double strength, double stiffness, const char* of, const char* strength_name,
                            const char* k) {
      const double least = 0.5 * strength / stiffness * strength;
      if (energy > least) return;
      throw InputError(fmt::format(
          "cohesive: energy_{0} is {1:g} J/m2, must be above {4}^2/(2 {2}) = {3:g}, what the joint stores at its "
          "strength; give more energy, or a stiffer joint, or use the bonded law",
          of, energy, k, least, strength_name));
    };
    require(energy_tension, tension, kn, "tension", "tension", "kn");
    require(energy_shear, cohesion, ks, "shear", "cohesion", "ks");
  }
};

}  // namespace trilith
