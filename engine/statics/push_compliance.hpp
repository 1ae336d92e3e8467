// Response of a structure to a push, for the control of quasi-static pushes.
#pragma once

#include <type_traits>

#include "load/push.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Displacement of the pushed points along the push per unit of its force, by the tangent at the present instant [m/N];
/// 0 if that is singular or there is no stiffness. The model must have no push.
template <int D>
double push_compliance(const Model<D>& model, const State<D>& state, const Push<D>& push);

/// Sum of all forces on the free degrees of freedom along `direction`, without dampings of nodes [N]. Forces between
/// bodies cancel, so this is the excess of pushes, loads and weight over the support forces. `work` must be evaluated
/// at the present instant.
template <int D>
double unsupported_force(const Model<D>& model, const Work<D>& work, const std::type_identity_t<Vec<D>>& direction);

/// Sum of the forces that press on supports along `direction`, such as the force on a foundation along gravity, without
/// weight and loads of supported bodies [N]. Supports that are pulled, or pressed the other way, do not count.
/// `work` as above.
template <int D>
double force_on_supports(const Model<D>& model, const State<D>& state, const Work<D>& work,
                         const std::type_identity_t<Vec<D>>& direction);

/// Power of all forces on the free degrees of freedom, without dampings of nodes: the rate of kinetic energy plus those
/// dampings [W].
template <int D>
double unbalanced_power(const Model<D>& model, const State<D>& state, const Work<D>& work);

}  // namespace trilith
