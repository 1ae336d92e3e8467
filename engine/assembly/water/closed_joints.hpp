// Closed parts of the faces that water reaches, from the contacts of an evaluation (load/water/closed_joints.hpp).
#pragma once

#include "model/model.hpp"
#include "model/work.hpp"

namespace trilith {

/// True if a load of the model is one of water.
template <int D>
bool has_water(const Model<D>& model);

/// Fills Work::closed_joints for the bodies with wet faces or uplift. Pairs, skin points or placed solids, and trial
/// memories of contacts must be up to date. A contact that a bearing replaces is not closed.
void find_closed_joints(const Model<2>& model, Work<2>& work);
void find_closed_joints(const Model<3>& model, Work<3>& work);

}  // namespace trilith
