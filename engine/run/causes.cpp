#include "run/causes.hpp"

#include <algorithm>

namespace trilith {
namespace {

bool can_cause(EventType type) {
  switch (type) {
    case EventType::bond_cracked:
    case EventType::bond_broken:
    case EventType::joint_crushed:
    case EventType::bearing_failed:
    case EventType::bearing_changed:
    case EventType::seat_lost:
    case EventType::impact:
    case EventType::body_left:
    case EventType::body_passed:
    case EventType::element_overstrained:
      return true;
    default:
      return false;
  }
}

}  // namespace

void Causes::name(Event& event) {
  event.id = next_++;
  if (event.type == EventType::stage_begun) {
    stage_ = event.id;
    return;
  }
  event.cause = stage_;
  for (const int body : {event.body_a, event.body_b})
    if (body >= 0) event.cause = std::max(event.cause, last_[body]);
  if (!can_cause(event.type)) return;
  for (const int body : {event.body_a, event.body_b})
    if (body >= 0) last_[body] = event.id;
}

}  // namespace trilith
