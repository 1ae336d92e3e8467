// The beams of frames that yield: their rows of the model, and what each makes of how it is strained.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "element/beam/end_hinge.hpp"
#include "element/beam/fibre_beam.hpp"

namespace trilith {

struct FibreBeamRow {
  FibreBeam beam;
  int section = -1;  ///< of BeamYields::sections
};

/// Rows that Beam::yield_row means, by Beam::yield.
struct BeamYields {
  std::vector<FibreSection> sections;
  std::vector<FibreBeamRow> fibre_beams;
  std::vector<HingeLaw> hinge_laws;
  std::vector<std::array<int, 2>> hinged_beams;  ///< of hinge_laws, for either end
};

/// Numbers that a beam remembers: all 0 at first. Of fibres, the first one is 1 once any has yielded.
int memory_size(const BeamYields& yields, const Beam& beam);

/// What a beam that yields does to its ends.
struct BeamResponse {
  BeamStress stress{};
  BeamStress damping{};   ///< by Beam::damping, see below
  double stored = 0;      ///< [J]
  double dissipated = 0;  ///< by yielding, in this step [J]
};

/// `before` and `after` have memory_size numbers and do not overlap. Damping is that of the stiffness which is left: an
/// end whose hinge flows has none of it, and fibres have that of their tangent, without what of it softens. Dampings of
/// the elastic stiffness would add moments that no hinge carries (Charney, J. Struct. Eng. ASCE 134(4), 2008).
BeamResponse respond(const BeamYields& yields, const Beam& beam, const BeamNow& now, std::span<const double> before,
                     std::span<double> after);

/// How the stresses of a beam, one that yields or not, answer.
struct BeamTangent {
  BeamStress stress{}, damping{};                       ///< as they are
  Eigen::Matrix3d by_strain = Eigen::Matrix3d::Zero();  ///< of `stress`
  Eigen::Matrix3d by_rate = Eigen::Matrix3d::Zero();    ///< of `damping`, to the rate of strain
};
BeamTangent tangent_of(const BeamYields& yields, const Beam& beam, const BeamNow& now, std::span<const double> before);

/// False where the end of a beam with hinges has none: that end never yields.
bool has_hinge(const BeamYields& yields, const Beam& beam, int end);

/// K (end 0, across, end 1) [N m] where hinges let ends go: their bends follow without moment.
std::array<double, 3> bend_beside(const std::array<double, 3>& bend, const std::array<bool, 2>& flowing);

/// What the hinge at an end remembers. `memory`: that of a beam with hinges.
EndHingeMemory hinge_memory(std::span<const double> memory);

/// Of an end of a beam that yields; one of fibres is told of at end 0, for all of it.
HingeStatus yield_status(const Beam& beam, std::span<const double> memory, int end);

}  // namespace trilith
