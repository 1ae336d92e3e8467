// The schemes of time integration: one row each, see integrate/integrator.hpp.
#pragma once

#include "base/schema.hpp"
#include "integrate/explicit/central_difference.hpp"
#include "integrate/implicit/alpha_method.hpp"

namespace trilith {

using Integrators = TypeList<CentralDifference, AlphaMethod>;
using AnyIntegrator = Integrators::Variant;

static_assert(Integrators::all([]<class I>() { return Integrator<I>; }));

inline std::string_view name_of(const AnyIntegrator& scheme) {
  return std::visit([]<class I>(const I&) { return std::string_view(I::name); }, scheme);
}
inline VelocityTimes velocities_of(const AnyIntegrator& scheme) {
  return std::visit([]<class I>(const I&) { return I::velocities; }, scheme);
}
inline StepBound bound_of(const AnyIntegrator& scheme) {
  return std::visit([]<class I>(const I&) { return I::bound; }, scheme);
}

}  // namespace trilith
