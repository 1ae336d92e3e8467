// Contacts that opened recently. They are lost after they have stayed open for Model::apart_time, and not lost if they
// close earlier.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Removes the contacts that begin to touch in this step from the recently opened ones (State::parted), and stores them
/// for has_closed_again(). Joints of rubble and of rocking units chatter; an event for each opening would hide the
/// relevant ones.
template <int D>
void take_back(State<D>& state, Work<D>& work);

/// True for a contact that begins to touch in this step and was not lost before. Call it after take_back().
template <int D>
[[nodiscard]] bool has_closed_again(const Work<D>& work, ContactKey contact);

/// Reports the opened contacts that have stayed open long enough to count as lost.
template <int D>
void parted_events(const Model<D>& model, State<D>& state, Work<D>& work);

}  // namespace trilith
