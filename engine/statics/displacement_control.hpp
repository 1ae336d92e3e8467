// Displacement control: the forces that make pushed points follow their motions, in the plane and in space.
#pragma once

#include "integrate/explicit/central_difference.hpp"

namespace trilith {

/// Finds the force of each of Model::pushes for the step that `options` describe, so that the weighed mean displacement
/// of its points is on its motion at the step's end, and adds them to Work::load, force and moment; once after each
/// evaluation. The force is that of a rigid constraint, w_i lambda on point i along the push's direction d, with
///   lambda = (velocity wanted - velocity without) / (span * sum of (w_i^2 / m_i + l_j . J_j^-1 l_j)),
/// where l_j is the moment about node j of a unit of force on the points that turn with it, and J_j its inertia.
/// Dampings that answer forces (RestDamping) see the force that leaves no unbalance, and what they take is then added
/// (Work::correction); it is no part of the force that is reported.
template <int D>
void control_displacement(const Model<D>& model, const State<D>& state, Work<D>& work, const StepOptions& options);

}  // namespace trilith
