// Bearings that close and open (law/bearing/clearance.hpp), as blows: see integrate/explicit/impact_step.hpp.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Adds to work.impacts.blows what each live bearing of a body that counts there asks for, one for each direction and
/// way that may close within `dt` [s], is closed or opens. Returns the energy that these have stored [J].
template <int D>
double list_bearing_impacts(const Model<D>& model, const State<D>& state, Work<D>& work, double dt);

}  // namespace trilith
