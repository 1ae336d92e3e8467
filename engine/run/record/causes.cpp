#include "run/record/causes.hpp"

#include <algorithm>

namespace trilith {
/// Numbers an event and names its cause: the latest event that touched one of its bodies and can cause others, else the
/// beginning of the stage. So each event hangs on one before it, and the whole is a tree.
void Causes::name(Event& event) {
  event.id = next_++;
  if (event.type == EventType::stage_begun) {
    stage_ = event.id;
    return;
  }
  // The last thing that happened to either body and can cause others; without, the stage.
  event.cause = stage_;
  for (const int body : {event.body_a, event.body_b})
    if (body >= 0) event.cause = std::max(event.cause, last_[body]);
  if (!has_trait(event.type, can_cause)) return;
  for (const int body : {event.body_a, event.body_b})
    if (body >= 0) last_[body] = event.id;
}

}  // namespace trilith
