// Events of bodies that do not depend on their contacts: rest.
#pragma once

#include "model/event/event.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// An event of this instant.
template <int D>
Event event_now(const State<D>& state, EventType type, int body_a, int body_b);

/// Adds an event for each body that has come to rest: slower than still_speed for still_time at its fastest point. For
/// a rigid body this is |v| + |spin| times its radius.
template <int D>
void body_events(const Model<D>& model, State<D>& state, Work<D>& work);

}  // namespace trilith
