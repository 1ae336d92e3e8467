#include "run/record/causes.hpp"

#include <algorithm>

#include "model/event/event_list.hpp"

namespace trilith {
/// Numbers an event and sets its cause: the latest event of one of its bodies that can be a cause, otherwise the start
/// of the stage. The events of a run form a tree.
void Causes::name(Event& event) {
  event.id = next_++;
  if (event.type == EventType::stage_begun) {
    stage_ = event.id;
    return;
  }
  // Latest event of either body that can be a cause; otherwise the stage.
  event.cause = stage_;
  for (const int body : {event.body_a, event.body_b})
    if (body >= 0) event.cause = std::max(event.cause, last_[body]);
  if (!has_trait(event.type, can_cause)) return;
  for (const int body : {event.body_a, event.body_b})
    if (body >= 0) last_[body] = event.id;
  // Both parts of a cracked body, of which the event names the first.
  if (event.type == EventType::unit_cracked) last_[event.body_b + 1] = event.id;
}

}  // namespace trilith
