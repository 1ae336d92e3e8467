// The state a model starts from, and the bonds of its joints.
#pragma once

#include "model/state.hpp"

namespace trilith {

/// initial_state, with a bond wherever two faces of a bonding law meet: see set_bonds.
State<2> start_state(const Model<2>& model, double reach = 1e-5);
State<3> start_state(const Model<3>& model, double reach = 1e-5);

/// Mortar sets: a whole, undamaged bond wherever two faces of a bonding law meet, at a gap of at most `reach` times
/// the smaller body's size. The mortar fills the gap: where faces stand apart the bond begins without stress; where
/// they are pressed together, and along them, the stress stays as it is. The ledger has what elastic energy that adds.
/// Joints of bodies before `first_body` with one another are left as they are.
void set_bonds(const Model<2>& model, State<2>& state, double reach, int first_body = 0);
void set_bonds(const Model<3>& model, State<3>& state, double reach, int first_body = 0);

/// Takes every bond away, as of mortar still fresh: joints press and rub.
void lift_bonds(const Model<2>& model, State<2>& state);
void lift_bonds(const Model<3>& model, State<3>& state);

}  // namespace trilith
