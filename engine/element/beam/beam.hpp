// Geometry and stiffness of a frame's beam. element/beam/beam_element.hpp computes its forces.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "base/space.hpp"

namespace trilith {

/// In the beam's axes.
struct BeamStiffness {
  double axial = 0;              ///< EA / L [N/m]
  std::array<double, 3> bend{};  ///< K: end 0, across, end 1 [N m]
  std::array<double, 3> bow{};   ///< L q = bow[0] theta_0^2 + bow[1] theta_0 theta_1 + bow[2] theta_1^2 [m]
};

/// Whether a beam yields, and by which model; see element/beam/beam_yield.hpp.
enum class BeamYield : std::uint8_t { never, in_fibres, at_hinges };

/// A beam between two nodes of a frame.
struct Beam {
  int body = -1;
  std::array<int, 2> node{-1, -1};
  std::array<Vec2, 2> arm{Vec2(0, 0), Vec2(0, 0)};  ///< rigid: from the node to the start of the beam, in its axes [m]
  double length = 0;                                ///< initial [m]
  double angle = 0;                                 ///< initial angle of its axis [rad]
  BeamStiffness stiffness;                          ///< elastic; for a fibre beam the largest stiffness
  double damping = 0;                               ///< stiffness-proportional damping [s]
  BeamYield yield = BeamYield::never;
  int yield_row = -1;     ///< index into the rows of Model::yields for its kind
  int first_memory = -1;  ///< index into State::beam_memory
  int band = -1;          ///< index into Model::bands; -1: no damping over a band
  int first_branch = -1;  ///< index into State::beam_memory, for the band damping
  int inertia = -1;       ///< index into Model::beam_inertias; -1: lumped mass
};

/// A straight member of a frame, divided into beams.
struct Member {
  std::string name;
  int body = -1;
  int first_beam = 0, beams = 0;
  std::array<std::string, 2> joint;  ///< names of the joints at its start and end
  double strain_limit = 0;           ///< validity limit of its material along the axis, of either sign [1]
};

}  // namespace trilith
