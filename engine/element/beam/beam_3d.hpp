// Geometry and stiffness of a beam of a frame in space. element/beam/beam_element_3d.hpp computes its forces.
#pragma once

#include <array>

#include "base/space.hpp"
#include "element/beam/beam.hpp"

namespace trilith {

/// In the beam's axes: x along the chord, y to the top of the section, z across.
struct BeamStiffness3 {
  double axial = 0;                   ///< EA / L [N/m]
  double torsion = 0;                 ///< GJ / L [N m]
  std::array<BeamStiffness, 2> bend;  ///< about y and about z: the bending and bow terms of each
};

/// A beam between two nodes of a frame in space.
struct Beam3 {
  int body = -1;
  std::array<int, 2> node{-1, -1};
  std::array<UnitQuaternion, 2> axes{};  ///< rotation from the axes of a node to the initial axes of the beam
  std::array<Vec3, 2> arm{Vec3(0, 0, 0), Vec3(0, 0, 0)};  ///< rigid, from the node to the beam, in the node's axes [m]
  double length = 0;                                      ///< initial [m]
  BeamStiffness3 stiffness;
  double damping = 0;                  ///< stiffness-proportional damping [s]
  BeamYield yield = BeamYield::never;  ///< for a fibre beam `stiffness` is the largest one
  int yield_row = -1;                  ///< index into the rows of BeamYields3 for its kind
  int first_memory = -1;               ///< index into State::beam_memory, if it yields
  int band = -1;                       ///< index into Model::bands; -1: no damping over a band
  int first_branch = -1;               ///< index into State::beam_memory, for the band damping
  int inertia = -1;                    ///< index into Model::beam_inertias_3d; -1: lumped mass
};

}  // namespace trilith
