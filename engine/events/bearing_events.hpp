// Changes of bearings in a step: yielding, failure, and the start of a successor.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// A bearing changes from intact to yielded to failed. With a successor it becomes "changed" instead: the successor is
/// a waiting bearing, or contact of the two pieces under a separate law. Appends to work.events, with a change after
/// the failure that caused it. Starts successors, and books the energy that an ending bearing dissipates.
template <int D>
void bearing_events(const Model<D>& model, const State<D>& state, Work<D>& work);

/// Displacement in its event: in the direction that failed [m]; 0 for a rotation.
double failed_displacement(const Vec2& displacement, std::uint32_t direction);
double failed_displacement(const Vec3& displacement, std::uint32_t direction);

}  // namespace trilith
