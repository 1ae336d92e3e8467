// Plastic hinges at both ends of an elastic beam: normal force and end moments are returned to the yield surfaces of
// the hinges.
//
// The plastic stretch p_u and the plastic rotations p_i are subtracted from the stretch u and the bends theta_i
// (element/beam/beam_element.hpp). The rest acts on the elastic beam with its bow. Where an end's moment would exceed
// its law (element/beam/hinge_law.hpp), the end flows so that all laws hold at the end of the step (return mapping;
// Simo and Hughes, "Computational Inelasticity", 1998, sec. 5.2; hinges with N and M: Powell and Chen, J. Struct. Eng.
// ASCE 112(4), 1986).
//
// The normal force is the root of one monotonic equation, bracketed by the capacity of the hinges. For each trial N the
// two moments are solved in turn, each exactly over the linear pieces of its law. This fails only for a beam beyond its
// own buckling load, which `settled` reports. Beyond the apex of the surface (zero moments, N at yield) the state stays
// at the apex.
//
// The dissipated energy is the mean moment and normal force times the flow, minus the increase of the energy stored by
// hardening. A single step from one yield limit to the opposite one, for a law with different sides, may record a
// negative value. Not modelled: yielding between the ends; the length of a plastic zone.
#pragma once

#include <Eigen/Core>

#include "element/beam/beam_element.hpp"
#include "element/beam/hinge_law.hpp"

namespace trilith {

/// Memory of a beam's hinges; initially all 0. Moments and rotations are positive where the bottom lengthens.
struct EndHingeMemory {
  double normal = 0;                   ///< of the last step, tension positive [N]
  double stretch = 0;                  ///< p_u [m]
  std::array<double, 2> moment{};      ///< of the last step [N m]
  std::array<double, 2> turned{};      ///< p_i [rad]
  std::array<double, 2> reach{};       ///< largest |p_i| so far [rad]
  std::array<double, 2> dissipated{};  ///< energy [J]
  std::array<double, 2> gone{};        ///< 1: the hinge has lost its moment; 2: the beam is removed
  static constexpr int size = 12;
};
static_assert(sizeof(EndHingeMemory) == EndHingeMemory::size * sizeof(double));

enum class HingeStatus : std::uint8_t { elastic, yielded, lost, removed };

struct EndHingeResponse {
  BeamStress stress{};
  EndHingeMemory memory;
  Eigen::Matrix3d tangent = Eigen::Matrix3d::Zero();  ///< d stress / d strain at the given memory
  double stored = 0;                                  ///< in the beam and in hardening [J]
  double dissipated = 0;                              ///< in this step [J]
  bool yielding = false;                              ///< an end yields in this step
  bool settled = true;                                ///< false: the laws do not hold, see above
};

/// For one end: 0 or 1.
HingeStatus status_of(const EndHingeMemory& memory, int end);

/// Elastic energy of a beam with this memory, which its removal releases [J].
double held_energy(const BeamStiffness& stiffness, const EndHingeMemory& memory);

/// A beam with a hinge that `removes` and has lost its moment carries nothing from the next step on; its energy is
/// dissipated. `law[i]` is the law of end i. `stiffness` may have pinned ends, which never yield.
EndHingeResponse respond(const BeamStiffness& stiffness, const std::array<const HingeLaw*, 2>& law,
                         const BeamStrain& strain, const EndHingeMemory& before);

}  // namespace trilith
