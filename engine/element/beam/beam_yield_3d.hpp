// Yielding beams of frames in space, with fibres or hinges: their rows in the model, and their response to strain.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "element/beam/end_hinge_3d.hpp"
#include "element/beam/fibre_beam_3d.hpp"

namespace trilith {

struct FibreBeamRow3 {
  FibreBeam3 beam;
  int section = -1;  ///< index into BeamYields3::sections
};

/// Rows to which Beam3::yield_row refers, depending on Beam3::yield.
struct BeamYields3 {
  std::vector<FibreSection3> sections;
  std::vector<FibreBeamRow3> fibre_beams;
  std::vector<HingeLaw> hinge_laws;
  std::vector<std::array<int, 2>> hinged_beams;  ///< indices into hinge_laws, for either end
};

/// Size of a beam's memory, as in the plane (element/beam/beam_yield.hpp).
int memory_size(const BeamYields3& yields, const Beam3& beam);

/// Actions of a beam on its ends and their tangents, elastic or not. Damping is proportional to the stiffness: for
/// fibres to their tangent at the start of the step without its softening part; a yielding end has no damping, see
/// element/beam/beam_yield.hpp.
struct BeamAnswer3 {
  BeamStress3 stress{}, damping{};
  Eigen::Matrix<double, 6, 6> by_strain = Eigen::Matrix<double, 6, 6>::Zero();  ///< of `stress`
  Eigen::Matrix<double, 6, 6> by_rate = Eigen::Matrix<double, 6, 6>::Zero();    ///< of `damping`, by the rate of strain
  double stored = 0;                                                            ///< [J]
  double dissipated = 0;                                                        ///< by yielding, in this step [J]
};

/// For a yielding beam. `before` and `after` have memory_size numbers and do not overlap.
BeamAnswer3 respond(const BeamYields3& yields, const Beam3& beam, const BeamStrain3& strain, const BeamStrain3& rate,
                    std::span<const double> before, std::span<double> after);

/// False where the end of a beam with hinges has none: that end never yields.
bool has_hinge(const BeamYields3& yields, const Beam3& beam, int end);

/// Memory of the hinges. `memory`: the memory of a beam with hinges.
EndHingeMemory3 space_hinge_memory(std::span<const double> memory);

/// Status of an end of a yielding beam. A fibre beam has one status, which is reported at end 0.
HingeStatus yield_status(const Beam3& beam, std::span<const double> memory, int end);

}  // namespace trilith
