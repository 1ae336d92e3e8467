// Data of a model that move from a body that has split to its parts: motion, bearings, seats and loads.
#pragma once

#include "edit/split_contacts.hpp"
#include "model/state.hpp"

namespace trilith {

/// Sets the motion of both parts to the rigid motion of their body, and deactivates the body at the present time.
void place_parts(const Model<2>& model, State<2>& state, const SplitBody& split);

/// Attaches bearings, seats, loads and displacement controls of the body to the part that holds their point. A face
/// load that spans the plane becomes two.
void hand_over_links(Model<2>& model, const SplitBody& split, const CrackSection<2>& section);

}  // namespace trilith
