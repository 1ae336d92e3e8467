// Plastic hinges at both ends of an elastic beam: normal force and end moments returned to what the hinges carry.
//
// Of the stretch u and the bends theta_i (element/beam/beam_element.hpp) the plastic stretch p_u and rotations p_i are
// taken off; the rest is that of the elastic beam with its bow. Where an end's moment would be beyond its law
// (element/beam/hinge_law.hpp) it flows so that all laws hold at the end of the step (return mapping; Simo and Hughes,
// "Computational Inelasticity", 1998, sec. 5.2; hinges with N and M: Powell and Chen, J. Struct. Eng. ASCE 112(4),
// 1986). The normal force is found as the root of one equation that rises with it, bracketed by what the hinges carry;
// within it the two moments, each solved exactly over the straight pieces of its law, in turns: it does not fail, but
// for a beam pressed beyond its own buckling load, of which `settled` tells. Beyond the tip of the surface (moments 0,
// N at yield) it stays at the tip. Given off is the mean moment and normal force on the flow, less what hardening
// stores more; a single step from one yield to the opposite one, of a law whose sides differ, may book less than
// nothing. Left out: yield of the beam between its ends; the length of a plastic zone.
#pragma once

#include <Eigen/Core>

#include "element/beam/beam_element.hpp"
#include "element/beam/hinge_law.hpp"

namespace trilith {

/// What the hinges of a beam remember; all 0 at first. Moments and rotations: above 0 where the bottom lengthens.
struct EndHingeMemory {
  double normal = 0;                   ///< of the last step, tension above 0 [N]
  double stretch = 0;                  ///< p_u [m]
  std::array<double, 2> moment{};      ///< of the last step [N m]
  std::array<double, 2> turned{};      ///< p_i [rad]
  std::array<double, 2> reach{};       ///< largest |p_i| so far [rad]
  std::array<double, 2> dissipated{};  ///< energy [J]
  std::array<double, 2> gone{};        ///< 1 where the hinge has lost its moment, 2 where the beam is removed
  static constexpr int size = 12;
};
static_assert(sizeof(EndHingeMemory) == EndHingeMemory::size * sizeof(double));

enum class HingeStatus : std::uint8_t { elastic, yielded, lost, removed };

struct EndHingeResponse {
  BeamStress stress{};
  EndHingeMemory memory;
  Eigen::Matrix3d tangent = Eigen::Matrix3d::Zero();  ///< d stress / d strain for what is remembered from before
  double stored = 0;                                  ///< in the beam and by hardening [J]
  double dissipated = 0;                              ///< in this step [J]
  bool yielding = false;                              ///< an end flows in this step
  bool settled = true;                                ///< false: the laws do not hold, see above
};

/// Of one end: 0 or 1.
HingeStatus status_of(const EndHingeMemory& memory, int end);

/// What a beam holds elastically by what is remembered: what it lets go of as it is removed [J].
double held_energy(const BeamStiffness& stiffness, const EndHingeMemory& memory);

/// One of which a hinge that `removes` has lost its moment carries nothing from the next step on; what it held is given
/// off. `law[i]` is that of end i. `stiffness` may have pinned ends, which never flow.
EndHingeResponse respond(const BeamStiffness& stiffness, const std::array<const HingeLaw*, 2>& law,
                         const BeamStrain& strain, const EndHingeMemory& before);

}  // namespace trilith
