// Yielding beams of frames: their rows in the model, and their response to strain.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "element/beam/end_hinge.hpp"
#include "element/beam/fibre_beam.hpp"

namespace trilith {

struct FibreBeamRow {
  FibreBeam beam;
  int section = -1;  ///< index into BeamYields::sections
};

/// Rows to which Beam::yield_row refers, depending on Beam::yield.
struct BeamYields {
  std::vector<FibreSection> sections;
  std::vector<FibreBeamRow> fibre_beams;
  std::vector<HingeLaw> hinge_laws;
  std::vector<std::array<int, 2>> hinged_beams;  ///< indices into hinge_laws, for either end
};

/// Size of a beam's memory; initially all 0. The first number of a fibre beam is 1 once any fibre has yielded. The
/// memory of its fibres follows, then the memory of its damping if Beam::damping is above 0
/// (element/beam/fibre_damping.hpp).
int memory_size(const BeamYields& yields, const Beam& beam);

/// Actions of a yielding beam on its ends.
struct BeamResponse {
  BeamStress stress{};
  BeamStress damping{};   ///< due to Beam::damping, see below
  double stored = 0;      ///< [J]
  double dissipated = 0;  ///< by yielding, in this step [J]
};

/// `before` and `after` have memory_size numbers and do not overlap. Damping is proportional to the remaining
/// stiffness. An end with a yielding hinge has no damping. Fibres are damped by their tangent at the start of the step,
/// without its softening part. Damping proportional to the elastic stiffness would add moments that no hinge carries
/// (Charney, J. Struct. Eng. ASCE 134(4), 2008).
BeamResponse respond(const BeamYields& yields, const Beam& beam, const BeamNow& now, std::span<const double> before,
                     std::span<double> after);

/// Stresses of a beam, yielding or not, and their tangents.
struct BeamTangent {
  BeamStress stress{}, damping{};                       ///< the present values
  Eigen::Matrix3d by_strain = Eigen::Matrix3d::Zero();  ///< of `stress`
  Eigen::Matrix3d by_rate = Eigen::Matrix3d::Zero();    ///< of `damping`, with respect to the rate of strain
};
BeamTangent tangent_of(const BeamYields& yields, const Beam& beam, const BeamNow& now, std::span<const double> before);

/// False where the end of a beam with hinges has none: that end never yields.
bool has_hinge(const BeamYields& yields, const Beam& beam, int end);

/// K (end 0, across, end 1) [N m] with yielding ends released: their bends follow without moment.
std::array<double, 3> bend_beside(const std::array<double, 3>& bend, const std::array<bool, 2>& flowing);

/// Memory of the hinges. `memory`: the memory of a beam with hinges.
EndHingeMemory hinge_memory(std::span<const double> memory);

/// Status of an end of a yielding beam. A fibre beam has one status, which is reported at end 0.
HingeStatus yield_status(const Beam& beam, std::span<const double> memory, int end);

}  // namespace trilith
