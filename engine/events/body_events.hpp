// What happens to bodies in a step whatever their contacts are like: rest.
#pragma once

#include "model/event.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// An event of this instant.
template <int D>
Event event_now(const State<D>& state, EventType type, int body_a, int body_b);

/// Bodies that have come to rest: slower than still_speed for still_time. The fastest point counts: of a rigid body
/// |v| + |spin| times its radius.
template <int D>
void body_events(const Model<D>& model, State<D>& state, Work<D>& work);

}  // namespace trilith
