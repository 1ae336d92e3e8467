#include "events/parted_contacts.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "assembly/contact/closing_contacts.hpp"
#include "events/body_events.hpp"

namespace trilith {
namespace {

/// Contacts that begin to touch in this step, by key.
template <int D>
void list_closing(const State<D>& state, Work<D>& work) {
  const Contacts<D>& before = contacts_before(state, work);
  for (const int row : work.changed_rows) {
    const auto r = static_cast<std::size_t>(row);
    const bool was = (before.memory[r].state & contact_touching) != 0,
               is = (work.contacts.memory[r].state & contact_touching) != 0;
    if (is && !was) work.closing.push_back(work.contacts.key[r]);
  }
  std::sort(work.closing.begin(), work.closing.end());
}

}  // namespace

/// Removes the contacts that close in this step (several hundred) from the list of opened contacts (about ten thousand
/// in a large wall). One pass: a flag excludes nearly all opened contacts, and only the others are searched for.
template <int D>
void take_back(State<D>& state, Work<D>& work) {
  work.closing.clear(), work.closed_again.clear();
  if (state.parted.empty()) return;
  list_closing(state, work);
  if (work.closing.empty()) return;
  assert(work.may_close.size() == closing_flags);
  for (const ContactKey contact : work.closing) work.may_close[closing_flag(contact)] = 1;
  std::erase_if(state.parted, [&](const Parted& p) {
    if (work.may_close[closing_flag(p.contact)] == 0) return false;
    if (!std::binary_search(work.closing.begin(), work.closing.end(), p.contact)) return false;
    work.closed_again.push_back(p.contact);
    return true;
  });
  for (const ContactKey contact : work.closing) work.may_close[closing_flag(contact)] = 0;
  std::sort(work.closed_again.begin(), work.closed_again.end());
}

template <int D>
bool has_closed_again(const Work<D>& work, ContactKey contact) {
  return std::binary_search(work.closed_again.begin(), work.closed_again.end(), contact);
}

/// Contacts that stayed open long enough become events, at the time at which this is certain.
template <int D>
void parted_events(const Model<D>& model, State<D>& state, Work<D>& work) {
  const auto lasting = [&](const Parted& p) { return state.time - p.time >= model.apart_time; };
  // The list is in the order of opening, so the contacts that have lasted are first.
  auto end = state.parted.begin();
  for (; end != state.parted.end() && lasting(*end); ++end)
    work.events.push_back(event_now(state, EventType::contact_lost, model.piece_body[first_piece(end->contact)],
                                    model.piece_body[second_piece(end->contact)]));
  state.parted.erase(state.parted.begin(), end);
}

template void take_back(State<2>&, Work<2>&);
template void take_back(State<3>&, Work<3>&);
template bool has_closed_again(const Work<2>&, ContactKey);
template bool has_closed_again(const Work<3>&, ContactKey);
template void parted_events(const Model<2>&, State<2>&, Work<2>&);
template void parted_events(const Model<3>&, State<3>&, Work<3>&);

}  // namespace trilith
