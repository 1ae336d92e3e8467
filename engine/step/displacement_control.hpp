// Displacement control: the forces that make pushed points follow their motions.
#pragma once

#include "step/central_difference.hpp"

namespace trilith {

/// Finds the force of each of Model::pushes for the step that `options` describe, so that the weighed mean displacement
/// of its points is on its motion at the step's end, and adds them to Work::load, force and moment; once after each
/// evaluation. The force is that of a rigid constraint, w_i lambda on point i, with
///   lambda = (velocity wanted - velocity without) / (span * sum of w_i^2 / m_i).
/// Dampings that answer forces (RestDamping) see the force that leaves no unbalance, and what they take is then added
/// (Work::correction); it is no part of the force that is reported.
void control_displacement(const Model<2>& model, const State<2>& state, Work<2>& work, const StepOptions& options);

}  // namespace trilith
