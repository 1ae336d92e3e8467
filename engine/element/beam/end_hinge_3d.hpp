// Plastic hinges at both ends of an elastic beam in space: element/beam/end_hinge.hpp with both axes of bending.
//
// With the moments m_y, m_z on an end, D, X = Hk p, r, Hi and the share c of element/beam/hinge_law.hpp the surface is
//
//   [ |m_y - D X_y|^a / W_y^a + |m_z - D X_z|^a / W_z^a ]^(1/a) <= D c(N),     a = contour
//   W_z = sagging or hogging + Hi r,   W_y = across + s Hi r,   X_y = s Hk p_y,   s = across / sagging
//   r = largest sqrt(p_z^2 + s p_y^2)
//
// the load contour of Bresler ("Design criteria for reinforced columns under axial load and biaxial bending", J. ACI
// 57, 1960, a 1.15 to 1.55); a = 2 is the circle, 1.7 within 2.1 % the full plastic rectangle and, without a normal
// force, within 5 % the I sections of Orbison, McGuire and Abel, Comput. Methods Appl. Mech. Eng. 33, 1982. Flow is
// normal to it: dp = l dg/dm, dp_u = -l dc/dN. Bent about z alone it is the hinge of the plane, about y alike with all
// strengths s times as large. The return is the implicit one of the plane: N by element/beam/hinge_normal.hpp, within
// it both ends at once by Newton's method in how far and which way they flow. Torsion is elastic and has no part in it.
#pragma once

#include <Eigen/Core>

#include "element/beam/beam_element_3d.hpp"
#include "element/beam/end_hinge.hpp"

namespace trilith {

/// What the hinges of a beam in space remember; all 0 at first. Moments and rotations of an end about y and z, above 0
/// where the side to z, and the bottom, lengthen.
struct EndHingeMemory3 {
  double normal = 0;                              ///< of the last step, tension above 0 [N]
  double stretch = 0;                             ///< p_u [m]
  std::array<std::array<double, 2>, 2> moment{};  ///< [end] of the last step [N m]
  std::array<std::array<double, 2>, 2> turned{};  ///< [end] p [rad]
  std::array<double, 2> reach{};                  ///< r so far [rad]
  std::array<double, 2> dissipated{};             ///< energy [J]
  std::array<double, 2> gone{};  ///< 1 where the hinge has lost its moment, 2 where the beam is removed
  static constexpr int size = 16;
};
static_assert(sizeof(EndHingeMemory3) == EndHingeMemory3::size * sizeof(double));

struct EndHingeResponse3 {
  BeamStress3 stress{};
  EndHingeMemory3 memory;
  Eigen::Matrix<double, 6, 6> tangent = Eigen::Matrix<double, 6, 6>::Zero();
  double stored = 0;              ///< in the beam and by hardening [J]
  double dissipated = 0;          ///< in this step [J]
  std::array<bool, 2> flowing{};  ///< an end flows in this step, or has no moment
  bool settled = true;            ///< false: the laws do not hold, see element/beam/end_hinge.hpp
};

/// Of one end: 0 or 1.
HingeStatus status_of(const EndHingeMemory3& memory, int end);

/// What a beam holds elastically in stretch and bending by what is remembered [J].
double held_energy(const BeamStiffness3& stiffness, const EndHingeMemory3& memory);

/// As in the plane; each law has `across` above 0, or never yields. A removed beam has no torsion either.
EndHingeResponse3 respond(const BeamStiffness3& stiffness, const std::array<const HingeLaw*, 2>& law,
                          const BeamStrain3& strain, const EndHingeMemory3& before);

/// How far the moments of an end are out on the surface beside N, over what the hinge can carry: 1 on it, 0 for one
/// that never yields. `worn`: D by energy.
double gauge_of(const HingeLaw& law, const EndHingeMemory3& memory, int end, double worn);

}  // namespace trilith
