// Damping ratios of a model for each of its modes, in its present state.
//
//     ratio = phi' C phi / (2 w),     C = -dF/dv about the state at rest,  phi' M phi = 1
//
// C phi follows from two evaluations with the velocities of the mode, in both senses, at a largest speed of 1 mm/s. For
// a nonlinear damper this gives the ratio at that speed. Sliding friction does not count as damping here, and numerical
// damping of implicit steps is not part of the model. Band damping (element/band_damping.hpp) depends on the mode's
// frequency. With U_b = s . K s of a beam's stretch and bends s in the mode,
//
//     ratio = sum loss_b(w) U_b / (2 [w^2 + sum (stiffness_b(w) - 1) U_b])
#pragma once

#include <vector>

#include "modal/modes.hpp"

namespace trilith {

/// Damping ratios [1] by source; 0 for a mode that does not vibrate.
struct ModeDamping {
  double contacts = 0, bearings = 0, elements = 0, bands = 0, mass = 0;
  [[nodiscard]] double total() const { return contacts + bearings + elements + bands + mass; }
};

/// One entry for each of the `modes`, which were found for this state.
template <int D>
std::vector<ModeDamping> mode_damping(const Model<D>& model, const State<D>& state,
                                      const std::vector<NaturalMode<D>>& modes);

}  // namespace trilith
