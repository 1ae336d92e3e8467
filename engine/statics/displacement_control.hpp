// Displacement control: the forces with which pushed points follow their motions, in the plane and in space.
#pragma once

#include "integrate/explicit/central_difference.hpp"

namespace trilith {

/// Finds the force of each of Model::pushes for the step of `options`. With it the weighted mean displacement of the
/// points follows its motion at the end of the step. Adds force and moment to Work::load; call it once after each
/// evaluation. The force acts like a rigid constraint, w_i lambda on point i along the push's direction d, with
///     lambda = (velocity wanted - velocity without) / (span * sum of (w_i^2 / m_i + l_j . J_j^-1 l_j)),
/// where l_j is the moment about node j per unit of force on the points that rotate with it, and J_j its inertia.
/// Dampings that depend on forces (RestDamping) use the force without residual; their effect is then compensated by
/// Work::correction, which is not part of the reported force.
template <int D>
void control_displacement(const Model<D>& model, const State<D>& state, Work<D>& work, const StepOptions& options);

}  // namespace trilith
