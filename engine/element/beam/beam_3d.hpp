// A beam of a frame in space: where it is and how stiff. Its forces are those of element/beam/beam_element_3d.hpp.
#pragma once

#include <array>

#include "base/space.hpp"
#include "element/beam/beam.hpp"

namespace trilith {

/// In its own axes: x along the chord, y to the top of the section, z across.
struct BeamStiffness3 {
  double axial = 0;                   ///< EA / L [N/m]
  double torsion = 0;                 ///< GJ / L [N m]
  std::array<BeamStiffness, 2> bend;  ///< about y and about z; of each the rows of bending and bow
};

/// Between two nodes of a frame in space.
struct Beam3 {
  int body = -1;
  std::array<int, 2> node{-1, -1};
  std::array<UnitQuaternion, 2> axes{};                   ///< from the axes of a node to those of the beam at the start
  std::array<Vec3, 2> arm{Vec3(0, 0, 0), Vec3(0, 0, 0)};  ///< rigid: from the node to where the beam begins, in the
                                                          ///< node's axes [m]
  double length = 0;                                      ///< at the start [m]
  BeamStiffness3 stiffness;
  double damping = 0;                  ///< damping over elastic force, of strain rate [s]
  BeamYield yield = BeamYield::never;  ///< of fibres `stiffness` is the stiffest it can be
  int yield_row = -1;                  ///< of BeamYields3, by its kind
  int first_memory = -1;               ///< of State::beam_memory, where it yields
  int band = -1;                       ///< of Model::bands; -1: no damping over a band
  int first_branch = -1;               ///< of State::beam_memory, for that
  int inertia = -1;                    ///< of Model::beam_inertias_3d; -1: its mass is lumped at its nodes
};

}  // namespace trilith
