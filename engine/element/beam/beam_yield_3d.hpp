// The beams of frames in space that yield, in fibres or at hinges: their rows of the model, and what each makes of how
// it is strained.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "element/beam/end_hinge_3d.hpp"
#include "element/beam/fibre_beam_3d.hpp"

namespace trilith {

struct FibreBeamRow3 {
  FibreBeam3 beam;
  int section = -1;  ///< of BeamYields3::sections
};

/// Rows that Beam3::yield_row means, by Beam3::yield.
struct BeamYields3 {
  std::vector<FibreSection3> sections;
  std::vector<FibreBeamRow3> fibre_beams;
  std::vector<HingeLaw> hinge_laws;
  std::vector<std::array<int, 2>> hinged_beams;  ///< of hinge_laws, for either end
};

/// Numbers that a beam remembers: all 0 at first. Of fibres, the first one is 1 once any has yielded.
int memory_size(const BeamYields3& yields, const Beam3& beam);

/// What a beam does to its ends and how that answers, elastic or not. Damping is that of the stiffness: of fibres of
/// their tangent, without what of it softens; an end whose hinge flows has none, see element/beam/beam_yield.hpp.
struct BeamAnswer3 {
  BeamStress3 stress{}, damping{};
  Eigen::Matrix<double, 6, 6> by_strain = Eigen::Matrix<double, 6, 6>::Zero();  ///< of `stress`
  Eigen::Matrix<double, 6, 6> by_rate = Eigen::Matrix<double, 6, 6>::Zero();    ///< of `damping`, to the rate of strain
  double stored = 0;                                                            ///< [J]
  double dissipated = 0;                                                        ///< by yielding, in this step [J]
};

/// Of a beam that yields. `before` and `after` have memory_size numbers and do not overlap.
BeamAnswer3 respond(const BeamYields3& yields, const Beam3& beam, const BeamStrain3& strain, const BeamStrain3& rate,
                    std::span<const double> before, std::span<double> after);

/// False where the end of a beam with hinges has none: that end never yields.
bool has_hinge(const BeamYields3& yields, const Beam3& beam, int end);

/// What the hinges remember. `memory`: that of a beam with hinges.
EndHingeMemory3 space_hinge_memory(std::span<const double> memory);

/// Of an end of a beam that yields; one of fibres is told of at end 0, for all of it.
HingeStatus yield_status(const Beam3& beam, std::span<const double> memory, int end);

}  // namespace trilith
