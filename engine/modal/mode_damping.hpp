// How much of critical the dampings of a model are for each of its modes, as it stands.
//
//   ratio = phi' C phi / (2 w),     C = -dF/dv about the state at rest,  phi' M phi = 1
//
// C phi is found by two evaluations with the velocities of the mode, to either side of rest, at a largest speed of
// 1 mm/s: of a damper that is no straight line it is what it does at that speed. Friction that slides is no damping
// here, and numerical damping of implicit steps is none of the model's. Damping over a band (element/band_damping.hpp)
// goes by the mode's frequency: with U_b = s . K s of a beam's stretch and bends s in the mode,
//
//   ratio = sum loss_b(w) U_b / (2 [w^2 + sum (stiffness_b(w) - 1) U_b])
#pragma once

#include <vector>

#include "modal/modes.hpp"

namespace trilith {

/// Ratios to critical damping [1], by what gives them. 0 where the mode does not swing.
struct ModeDamping {
  double contacts = 0, bearings = 0, elements = 0, bands = 0, mass = 0;
  [[nodiscard]] double total() const { return contacts + bearings + elements + bands + mass; }
};

/// Of modes that were found of this state, one for each.
template <int D>
std::vector<ModeDamping> mode_damping(const Model<D>& model, const State<D>& state,
                                      const std::vector<NaturalMode<D>>& modes);

}  // namespace trilith
