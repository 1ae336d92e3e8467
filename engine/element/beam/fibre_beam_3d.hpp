// A beam in space with fibre sections at stations along it: element/beam/fibre_beam.hpp with two planes of bending.
//
//     e = u/L + q_y + q_z,   k_y and k_z linear along it, each by the bends about its axis as in the plane
//     N = mean of N(x),   M_ai = L sum w [ N(x) dq_a/dtheta_ai + M_a(x) dk_a/dtheta_ai ],   T = GJ/L tau
//
// A fibre responds to the total strain, so bending about one axis reduces the capacity about the other, and the normal
// force reduces both. Torsion and shear stay elastic. With elastic fibres the beam equals the elastic beam to rounding.
#pragma once

#include "element/beam/beam_element_3d.hpp"
#include "element/beam/fibre_beam.hpp"
#include "element/section/fibre_section_3d.hpp"

namespace trilith {

struct FibreBeam3 {
  std::array<FibreBeam, 2> plane;  ///< bending about y and about z: equal length and stations
  double torsion = 0;              ///< GJ / L [N m]

  [[nodiscard]] int stations() const { return plane[0].stations; }
  [[nodiscard]] double length() const { return plane[0].length; }
  [[nodiscard]] int memory_size(const FibreSection3& section) const { return stations() * section.memory_size(); }
};

/// `shear_stiffness`: G A_s for bending about y and about z [N], 0 without shear; `torsion`: GJ [N m2]; otherwise as
/// make_fibre_beam. Throws InputError.
FibreBeam3 make_fibre_beam_in_space(const FibreSection3& section, double length, const std::array<bool, 2>& pinned,
                                    const std::array<double, 2>& shear_stiffness, double torsion,
                                    BeamRule rule = BeamRule::lobatto, int stations = 4);

/// An elastic beam at least as stiff in every mode as this beam can be, for the stability limit.
BeamStiffness3 stiffest_beam(const FibreBeam3& beam, const FibreSection3& section);

/// Strain of a station due to stretch and bends: axial strain, k_y, k_z.
struct StationStrain {
  Eigen::Vector3d strain;
  Eigen::Matrix<double, 3, 5> by;  ///< with respect to u, and the bends in the order of BeamStrain3
};
StationStrain station_strain(const FibreBeam3& beam, const BeamStrain3& d, int station);

struct FibreBeamResponse3 {
  BeamStress3 stress{};
  Eigen::Matrix<double, 6, 6> tangent = Eigen::Matrix<double, 6, 6>::Zero();
  double stored = 0;      ///< [J]
  double dissipated = 0;  ///< in this step [J]
  bool yielding = false;  ///< any fibre, in this step
};

/// `before` and `after` have memory_size(section) numbers for each station, in order.
FibreBeamResponse3 respond(const FibreBeam3& beam, const FibreSection3& section, const BeamStrain3& strain,
                           std::span<const double> before, std::span<double> after);

}  // namespace trilith
