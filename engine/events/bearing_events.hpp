// What becomes of bearings in a step: yielding, failing, and what follows a failed one.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// A bearing goes intact -> yielded -> failed, or -> changed where something follows it: another bearing that waited,
/// or contact of the two pieces under a law of its own. Appends to work.events, a change after the failure that led to
/// it, lets what follows begin, and books what a bearing that ends gives off.
template <int D>
void bearing_events(const Model<D>& model, const State<D>& state, Work<D>& work);

/// Displacement that its event tells of: in the direction that failed [m]; 0 of a turn.
double failed_displacement(const Vec2& displacement, std::uint32_t direction);
double failed_displacement(const Vec3& displacement, std::uint32_t direction);

}  // namespace trilith
