// Plastic hinges at both ends of an elastic beam in space: element/beam/end_hinge.hpp with both axes of bending.
//
// The yield surface uses the moments m_y, m_z on an end and D, X = Hk p, r, Hi and the share c from
// element/beam/hinge_law.hpp.
//
//     [ |m_y - D X_y|^a / W_y^a + |m_z - D X_z|^a / W_z^a ]^(1/a) <= D c(N),     a = contour
//     W_z = sagging or hogging + Hi r,   W_y = across + s Hi r,   X_y = s Hk p_y,   s = across / sagging
//     r = largest sqrt(p_z^2 + s p_y^2).
//
// It is the load contour of Bresler ("Design criteria for reinforced columns under axial load and biaxial bending", J.
// ACI 57, 1960, a 1.15 to 1.55). The exponent a = 2 is the circle. For a = 1.7 it matches the fully plastic rectangle
// within 2.1 %. It then also matches, without a normal force, the I sections of Orbison, McGuire and Abel within 5 %
// (Comput. Methods Appl. Mech. Eng. 33, 1982). Flow is normal to it: dp = l dg/dm, dp_u = -l dc/dN.
//
// Bent about z alone it equals the plane hinge; about y it is the same with all strengths s times as large. The return
// mapping is implicit as in the plane: N by element/beam/hinge_normal.hpp, and for each N both ends at once by Newton's
// method for amount and direction of their flow. Torsion is elastic and independent.
#pragma once

#include <Eigen/Core>

#include "element/beam/beam_element_3d.hpp"
#include "element/beam/end_hinge.hpp"

namespace trilith {

/// Memory of the hinges of a beam in space; initially all 0. Moments and rotations of an end are about y and z,
/// positive where the side to z, and the bottom, lengthen.
struct EndHingeMemory3 {
  double normal = 0;                              ///< of the last step, tension positive [N]
  double stretch = 0;                             ///< p_u [m]
  std::array<std::array<double, 2>, 2> moment{};  ///< [end] of the last step [N m]
  std::array<std::array<double, 2>, 2> turned{};  ///< [end] p [rad]
  std::array<double, 2> reach{};                  ///< largest r so far [rad]
  std::array<double, 2> dissipated{};             ///< energy [J]
  std::array<double, 2> gone{};                   ///< 1: the hinge has lost its moment; 2: the beam is removed
  static constexpr int size = 16;
};
static_assert(sizeof(EndHingeMemory3) == EndHingeMemory3::size * sizeof(double));

struct EndHingeResponse3 {
  BeamStress3 stress{};
  EndHingeMemory3 memory;
  Eigen::Matrix<double, 6, 6> tangent = Eigen::Matrix<double, 6, 6>::Zero();
  double stored = 0;              ///< in the beam and in hardening [J]
  double dissipated = 0;          ///< in this step [J]
  std::array<bool, 2> flowing{};  ///< an end yields in this step, or has lost its moment
  bool settled = true;            ///< false: the laws do not hold, see element/beam/end_hinge.hpp
};

/// For one end: 0 or 1.
HingeStatus status_of(const EndHingeMemory3& memory, int end);

/// Elastic energy of a beam with this memory in stretch and bending [J].
double held_energy(const BeamStiffness3& stiffness, const EndHingeMemory3& memory);

/// As in the plane; each law has `across` above 0, or never yields. A removed beam has no torsion either.
EndHingeResponse3 respond(const BeamStiffness3& stiffness, const std::array<const HingeLaw*, 2>& law,
                          const BeamStrain3& strain, const EndHingeMemory3& before);

/// Distance of an end's moments from the centre of the surface at N, relative to the capacity: 1 on the surface, 0 for
/// an end that never yields. `worn`: D due to energy.
double gauge_of(const HingeLaw& law, const EndHingeMemory3& memory, int end, double worn);

}  // namespace trilith
