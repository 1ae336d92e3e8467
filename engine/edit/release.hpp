// Quiet release of supports without an impact, in the plane and in space.
#pragma once

#include <array>

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Frees the fixed or driven degrees of freedom `on` (translations, then rotations) of a body. The forces that keep its
/// nodes in their present motion remain as a load that fades smoothly within `fade` [s], so that the release causes no
/// vibration. These are the support forces and moments, minus the forces of contacts between constrained bodies, which
/// count only after one of them is free. Returns the number of freed degrees of freedom.
template <int D>
int release_supports(Model<D>& model, const State<D>& state, int body, const std::array<bool, Space<D>::dofs>& on,
                     double fade);

}  // namespace trilith
