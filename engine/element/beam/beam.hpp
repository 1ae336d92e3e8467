// A beam of a frame: where it is and how stiff. Its forces are those of element/beam/beam_element.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "base/space.hpp"

namespace trilith {

/// In its own axes.
struct BeamStiffness {
  double axial = 0;              ///< EA / L [N/m]
  std::array<double, 3> bend{};  ///< K: end 0, across, end 1 [N m]
  std::array<double, 3> bow{};   ///< L q = bow[0] theta_0^2 + bow[1] theta_0 theta_1 + bow[2] theta_1^2 [m]
};

/// Whether a beam yields, and how that is followed; see element/beam/beam_yield.hpp.
enum class BeamYield : std::uint8_t { never, in_fibres, at_hinges };

/// Between two nodes of a frame.
struct Beam {
  int body = -1;
  std::array<int, 2> node{-1, -1};
  std::array<Vec2, 2> arm{Vec2(0, 0), Vec2(0, 0)};  ///< rigid: from the node to where the beam begins, in its axes [m]
  double length = 0;                                ///< at the start [m]
  double angle = 0;                                 ///< of its axis at the start [rad]
  BeamStiffness stiffness;                          ///< elastic; of one of fibres, the stiffest it can be
  double damping = 0;                               ///< damping over elastic force, of strain rate [s]
  BeamYield yield = BeamYield::never;
  int yield_row = -1;     ///< of Model::yields, by its kind
  int first_memory = -1;  ///< of State::beam_memory
  int band = -1;          ///< of Model::bands; -1: no damping over a band
  int first_branch = -1;  ///< of State::beam_memory, for that
  int inertia = -1;       ///< of Model::beam_inertias; -1: its mass is lumped at its nodes
};

/// A straight member of a frame: beams one after the other.
struct Member {
  std::string name;
  int body = -1;
  int first_beam = 0, beams = 0;
  std::array<std::string, 2> joint;  ///< names of those it leads from and to
  double strain_limit = 0;           ///< what its material is made for along the axis, of either sign [1]
};

}  // namespace trilith
