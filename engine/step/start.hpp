// The state a model starts from.
#pragma once

#include "world/state.hpp"

namespace trilith {

/// initial_state, with a bond wherever two faces of a bonding law meet: at a gap of at most `reach` times the smaller
/// body's size.
State<2> start_state(const Model<2>& model, double reach = 1e-5);

}  // namespace trilith
