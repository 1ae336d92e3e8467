// What happens to bodies in a step whatever their contacts are like: contacts lost for good, rest.
#pragma once

#include "world/event.hpp"
#include "world/model.hpp"
#include "world/state.hpp"
#include "world/work.hpp"

namespace trilith {

/// An event of this instant.
template <int D>
Event event_now(const State<D>& state, EventType type, int body_a, int body_b);

/// A contact that opened a moment ago and closes again was never lost: true if it was one, which is then forgotten.
/// Joints of rubble and of rocking units chatter; telling each time would bury what matters.
template <int D>
bool take_back(State<D>& state, ContactKey contact);

/// Tells which of the contacts that opened have now stayed open long enough to count as lost.
template <int D>
void parted_events(const Model<D>& model, State<D>& state, Work<D>& work);

/// Bodies that have come to rest: slower than still_speed for still_time. The fastest point counts: of a rigid body
/// |v| + |spin| times its radius.
template <int D>
void body_events(const Model<D>& model, State<D>& state, Work<D>& work);

}  // namespace trilith
