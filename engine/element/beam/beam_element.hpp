// A straight beam between two rotating ends: large displacements, small strains, co-rotational with its chord.
//
//              theta_1                    e  along the chord from end 0 to end 1, n = left of e
//          ___/          \ ___            u        = l - L                          stretch
//     0 o--   - - chord - -   --o 1      theta_i  = rotation_i - rotation of chord   bend of end i to the chord
//
//     N = EA/L (u + L q),   q = (2 theta_0^2 - theta_0 theta_1 + 2 theta_1^2) / 30
//     M = K (theta_0, theta_1) + N L dq/dtheta,   K = EI / ((1 + phi) L) [4 + phi, 2 - phi; 2 - phi, 4 + phi]
//
// The term q is the mean stretch due to the bow of a cubic between the ends. With it a member buckles at its critical
// load, including its own bow. The shear parameter phi = 12 EI / (G A_s L^2) is 0 without shear deformation (Euler and
// Bernoulli); otherwise the beam is Timoshenko's. A pinned end carries no moment: its rotation is condensed from K, and
// from q with phi = 0. Forces on the ends are the exact derivatives of N (u + L q) / 2 + theta K theta / 2. So energy,
// momentum and angular momentum are conserved for any size of motion.
//
// Crisfield, "Non-linear finite element analysis of solids and structures", vol. 1, 1991, ch. 7 (corotational beams,
// shallow-arch strain); Przemieniecki, "Theory of matrix structural analysis", 1968, sec. 5.6 (shear).
#pragma once

#include <array>

#include "base/space.hpp"
#include "element/beam/beam.hpp"
#include "element/section/section.hpp"

namespace trilith {

/// Material of a beam: with `shear` modulus 0 there is no shear deformation.
struct BeamMaterial {
  double young = 0;  ///< [Pa]
  double shear = 0;  ///< [Pa]
};

/// `length` [m] above 0.
BeamStiffness beam_stiffness(const BeamMaterial& material, const Section& section, double length,
                             const std::array<bool, 2>& pinned);

/// Motion of an end of the flexible part.
struct BeamEnd {
  Vec2 place;       ///< [m]
  double rotation;  ///< from the initial state [rad]
  Vec2 velocity;    ///< [m/s]
  double spin;      ///< [rad/s]
};

/// Stretch [m] and bends of the ends [rad], or their rates.
using BeamStrain = std::array<double, 3>;
/// Normal force, tension positive [N]; moments on the ends, counter-clockwise [N m].
using BeamStress = std::array<double, 3>;

/// Present configuration of a beam.
struct BeamNow {
  double length;  ///< of its chord [m]
  Vec2 along;     ///< unit vector of its chord
  BeamStrain strain, rate;

  /// `length_0` [m] and `angle_0` [rad]: of the initial axis.
  BeamNow(const BeamEnd& from, const BeamEnd& to, double length_0, double angle_0);

  /// Force of the beam on its end 0 for `stress`; the other end has the opposite force [N].
  [[nodiscard]] Vec2 force_on_start(const BeamStress& stress) const {
    return stress[0] * along - (stress[1] + stress[2]) / length * left_of(along);
  }
};

/// K times the strain or its rate, without the bow.
inline BeamStress linear_stress(const BeamStiffness& k, const BeamStrain& d) {
  return {k.axial * d[0], k.bend[0] * d[1] + k.bend[1] * d[2], k.bend[1] * d[1] + k.bend[2] * d[2]};
}

/// Stretch including the bow [m].
inline double bowed_stretch(const BeamStiffness& k, const BeamStrain& d) {
  return d[0] + k.bow[0] * d[1] * d[1] + k.bow[1] * d[1] * d[2] + k.bow[2] * d[2] * d[2];
}

inline BeamStress stress_of(const BeamStiffness& k, const BeamStrain& d) {
  BeamStress s = linear_stress(k, d);
  s[0] = k.axial * bowed_stretch(k, d);
  s[1] += s[0] * (2 * k.bow[0] * d[1] + k.bow[1] * d[2]);
  s[2] += s[0] * (2 * k.bow[2] * d[2] + k.bow[1] * d[1]);
  return s;
}

/// Elastic energy [J].
inline double stored_in(const BeamStiffness& k, const BeamStrain& d) {
  const double stretch = bowed_stretch(k, d);
  return 0.5 * (k.axial * stretch * stretch + k.bend[0] * d[1] * d[1] + k.bend[2] * d[2] * d[2]) +
         k.bend[1] * d[1] * d[2];
}

/// An upper bound of the highest squared frequency of the free beam with the masses and inertias of its ends [1/s2].
/// `arm`: rigid parts from the nodes to the ends, in the beam's axes [m].
double beam_frequency2(const BeamStiffness& stiffness, double length, const std::array<Vec2, 2>& arm,
                       const std::array<double, 2>& mass, const std::array<double, 2>& inertia);

}  // namespace trilith
