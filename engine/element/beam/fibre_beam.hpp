// A beam with fibre sections at stations along it: normal force and end moments including plasticity.
//
// The formulation is displacement based: it assumes deformations, not forces, along the beam. The fields are those in
// element/beam/beam_element.hpp, with its stretch u and bends theta_0, theta_1: a constant axial strain including the
// bow, and a linear curvature.
//
//     e = u/L + q,   k = (theta_1 - theta_0)/L + (theta_0 + theta_1)(6 x/L - 3)/((1 + phi) L)
//     N = mean of N(x),   M_i = L sum w [ N(x) dq/dtheta_i + M(x) dk/dtheta_i ]
//
// Points and weights follow Gauss-Lobatto, which includes the ends, where plasticity begins, or Gauss. With elastic
// fibres the beam equals the elastic beam to rounding. The elastic section defines a constant phi: shear is elastic. A
// pinned end is treated as in the elastic beam: its bend follows the other one by the elastic ratio.
//
// Because the curvature is linear in each beam, plastic zones at ends need short beams, about as long as the zone.
// Spacone, Filippou and Taucer, Earthquake Eng. Struct. Dyn. 25, 1996, compare with force-based beams.
#pragma once

#include "element/beam/beam_element.hpp"
#include "element/section/fibre_section.hpp"

namespace trilith {

/// Quadrature rule for the stations along a beam.
enum class BeamRule : std::uint8_t { lobatto, gauss };

/// A member of fibres, with stations along each of its beams.
struct MemberFibres {
  FibreSpec spec;
  BeamRule rule = BeamRule::lobatto;
  int stations = 4;
};

struct FibreStation {
  double weight = 0;                  ///< share of the length; the sum is 1
  std::array<double, 2> curvature{};  ///< curvature per unit of each bend [1/m]
};

struct FibreBeam {
  double length = 0;              ///< [m]
  std::array<double, 3> bow{};    ///< as in BeamStiffness [m]
  double shear = 0;               ///< moment due to elastic shear, per sum of the bends [N m]
  std::array<double, 2> slant{};  ///< weight of each bend in that sum [1]
  int stations = 0;
  std::array<FibreStation, 6> station{};

  [[nodiscard]] int memory_size(const FibreSection& section) const { return stations * section.memory_size(); }
};

/// `stations`: 3 to 6 (lobatto) or 2 to 5 (gauss); `shear_stiffness` is G A_s [N], 0 without shear. Throws InputError.
FibreBeam make_fibre_beam(const FibreSection& section, double length, const std::array<bool, 2>& pinned,
                          double shear_stiffness = 0, BeamRule rule = BeamRule::lobatto, int stations = 4);

/// For one plane of bending, with the elastic bending stiffness EI [N m2].
FibreBeam fibre_beam_of(double bending, double length, const std::array<bool, 2>& pinned, double shear_stiffness,
                        BeamRule rule, int stations);

/// L q of the bow in one plane [m], and its derivatives by both bends [m].
struct FibreBow {
  double stretch;
  std::array<double, 2> by;

  FibreBow(const FibreBeam& beam, double bend_0, double bend_1)
      : stretch((beam.bow[0] * bend_0 + beam.bow[1] * bend_1) * bend_0 + beam.bow[2] * bend_1 * bend_1),
        by{2 * beam.bow[0] * bend_0 + beam.bow[1] * bend_1, 2 * beam.bow[2] * bend_1 + beam.bow[1] * bend_0} {}
};

/// Bending of an elastic beam at least as stiff: EI at all stations and the shear [N m].
std::array<double, 3> stiffest_bend(const FibreBeam& beam, double bending);

/// An elastic beam at least as stiff in every mode as this beam can be, without the bow's part in bending: for the
/// stability limit (beam_frequency2).
BeamStiffness stiffest_beam(const FibreBeam& beam, const FibreSection& section);

struct FibreBeamResponse {
  BeamStress stress{};
  Eigen::Matrix3d tangent = Eigen::Matrix3d::Zero();
  double stored = 0;      ///< [J]
  double dissipated = 0;  ///< in this step [J]
  bool yielding = false;  ///< any fibre, in this step
};

/// `before` and `after` have memory_size(section) numbers for each station, in order.
FibreBeamResponse respond(const FibreBeam& beam, const FibreSection& section, const BeamStrain& strain,
                          std::span<const double> before, std::span<double> after);

}  // namespace trilith
