// Impacts in bearings that close and open (law/bearing/clearance.hpp); see integrate/explicit/impact_step.hpp.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Adds the impacts of live bearings to work.impacts.blows: one for each direction and sense that may close within `dt`
/// [s], is closed, or opens. Only bearings of bodies that count for impacts are included. Returns the energy stored in
/// them [J].
template <int D>
double list_bearing_impacts(const Model<D>& model, const State<D>& state, Work<D>& work, double dt);

}  // namespace trilith
