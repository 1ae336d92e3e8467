// How a structure answers a push, as far as a quasi-static one has to know.
#pragma once

#include <type_traits>

#include "load/forces.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// How far a unit of the push's force moves its points along it, by the tangent at the present instant [m/N]; 0 where
/// that is singular or holds nothing. The model must have no push.
template <int D>
double push_compliance(const Model<D>& model, const State<D>& state, const Push<D>& push);

/// Sum of all forces on the free degrees of freedom along `direction`, dampings of nodes left out [N]. Forces between
/// bodies cancel in it, so that it is how much more the pushes, loads and weights are than the supports take up.
/// `work` must hold the evaluation of the present instant.
template <int D>
double unsupported_force(const Model<D>& model, const Work<D>& work, const std::type_identity_t<Vec<D>>& direction);

/// Power of all forces on the free degrees of freedom, dampings of nodes left out: what goes into the energy of motion
/// and into those dampings [W].
template <int D>
double unbalanced_power(const Model<D>& model, const State<D>& state, const Work<D>& work);

}  // namespace trilith
