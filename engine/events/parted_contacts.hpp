// Contacts that opened a moment ago: lost once they have stayed open for Model::apart_time, and never lost where they
// close before.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Of the contacts that parted a moment ago, forgets those that begin to touch in this step (State::parted), and notes
/// them for has_closed_again(). Joints of rubble and of rocking units chatter; telling each time would bury what
/// matters.
template <int D>
void take_back(State<D>& state, Work<D>& work);

/// True of a contact that begins to touch in this step and was not lost before. After take_back().
template <int D>
[[nodiscard]] bool has_closed_again(const Work<D>& work, ContactKey contact);

/// Tells which of the contacts that opened have now stayed open long enough to count as lost.
template <int D>
void parted_events(const Model<D>& model, State<D>& state, Work<D>& work);

}  // namespace trilith
