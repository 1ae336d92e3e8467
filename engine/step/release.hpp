// Quiet release: supports let go without a jolt.
#pragma once

#include <array>

#include "world/model.hpp"
#include "world/state.hpp"

namespace trilith {

/// Frees the directions `on` (x, y, rotation) of a body that are held or driven. What keeps each of its nodes in its
/// present motion stays as a load that fades smoothly within `fade` [s], so that nothing is set off: the force and
/// moment that the supports gave, less what contacts between held bodies give, which count only once one of them is
/// free. Gives how many degrees of freedom were freed.
int release_supports(Model<2>& model, const State<2>& state, int body, const std::array<bool, 3>& on, double fade);

}  // namespace trilith
