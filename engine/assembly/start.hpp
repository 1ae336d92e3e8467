// Initial state of a model, and the bonds of its joints.
#pragma once

#include "model/state.hpp"

namespace trilith {

/// initial_state, with a bond at all pairs of faces that meet under a bonding law: see set_bonds.
State<2> start_state(const Model<2>& model, double reach = 1e-5);
State<3> start_state(const Model<3>& model, double reach = 1e-5);

/// Creates a whole, undamaged bond at all pairs of faces that meet under a bonding law, with a gap of at most `reach`
/// times the smaller body's size. The mortar fills the gap: if faces are apart the bond starts without stress; if they
/// are pressed together, normal and shear stress remain. The ledger receives the added elastic energy. Joints between
/// bodies before `first_body` remain unchanged.
void set_bonds(const Model<2>& model, State<2>& state, double reach, int first_body = 0);
void set_bonds(const Model<3>& model, State<3>& state, double reach, int first_body = 0);

/// Removes every bond, as of fresh mortar: joints have pressure and friction only.
void lift_bonds(const Model<2>& model, State<2>& state);
void lift_bonds(const Model<3>& model, State<3>& state);

}  // namespace trilith
