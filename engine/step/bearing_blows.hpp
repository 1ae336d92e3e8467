// Bearings that close and open (bearing/clearance.hpp), as blows: see step/impact_step.hpp.
#pragma once

#include "world/model.hpp"
#include "world/state.hpp"
#include "world/work.hpp"

namespace trilith {

/// Adds to work.impacts.blows what each live bearing of a body that counts there asks for, one for each direction and
/// way that may close within `dt` [s], is closed or opens. Returns the energy that these have stored [J].
template <int D>
double list_bearing_blows(const Model<D>& model, const State<D>& state, Work<D>& work, double dt);

}  // namespace trilith
