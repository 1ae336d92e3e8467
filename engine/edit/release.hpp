// Quiet release: supports let go without a jolt, in the plane and in space.
#pragma once

#include <array>

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Frees the degrees of freedom `on` (along the axes, then turns) of a body that are held or driven. What keeps each of
/// its nodes in its present motion stays as a load that fades smoothly within `fade` [s], so that nothing is set off:
/// the force and moment that the supports gave, less what contacts between held bodies give, which count only once one
/// of them is free. Gives how many degrees of freedom were freed.
template <int D>
int release_supports(Model<D>& model, const State<D>& state, int body, const std::array<bool, Space<D>::dofs>& on,
                     double fade);

}  // namespace trilith
