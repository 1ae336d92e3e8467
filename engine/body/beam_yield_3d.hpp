// The beams of frames in space that yield, in fibres: their rows of the model, and what each makes of how it is
// strained.
#pragma once

#include <span>
#include <vector>

#include "body/fibre_beam_3d.hpp"

namespace trilith {

struct FibreBeamRow3 {
  FibreBeam3 beam;
  int section = -1;  ///< of BeamYields3::sections
};

/// Rows that Beam3::fibre_row means.
struct BeamYields3 {
  std::vector<FibreSection3> sections;
  std::vector<FibreBeamRow3> fibre_beams;
};

/// Numbers that a beam remembers: all 0 at first; the first one is 1 once any fibre has yielded.
int memory_size(const BeamYields3& yields, const Beam3& beam);

/// What a beam does to its ends and how that answers, elastic or not. Damping is that of the stiffness: of fibres of
/// their tangent, without what of it softens, see body/beam_yield.hpp.
struct BeamAnswer3 {
  BeamStress3 stress{}, damping{};
  Eigen::Matrix<double, 6, 6> by_strain = Eigen::Matrix<double, 6, 6>::Zero();  ///< of `stress`
  Eigen::Matrix<double, 6, 6> by_rate = Eigen::Matrix<double, 6, 6>::Zero();    ///< of `damping`, to the rate of strain
  double stored = 0;                                                            ///< [J]
  double dissipated = 0;                                                        ///< by yielding, in this step [J]
};

/// Of a beam of fibres. `before` and `after` have memory_size numbers and do not overlap.
BeamAnswer3 respond(const BeamYields3& yields, const Beam3& beam, const BeamStrain3& strain, const BeamStrain3& rate,
                    std::span<const double> before, std::span<double> after);

}  // namespace trilith
