#include "results/file/presence.hpp"

#include <limits>

namespace trilith::results {

Presence::Presence(const std::vector<EventRow>& events, std::size_t bodies)
    : of_(bodies), left_(bodies, std::numeric_limits<double>::infinity()) {
  for (const EventRow& e : events) {
    if (e.body_a < 0 || static_cast<std::size_t>(e.body_a) >= bodies) continue;
    const auto body = static_cast<std::size_t>(e.body_a);
    if (e.type == "body.left") left_[body] = e.time;
    if (e.type != "body.added" && e.type != "body.removed") continue;
    of_[body].push_back({e.time, e.type == "body.added"});
    changes_ = true;
  }
}

/// A body that is added first was absent before.
bool Presence::is_there(std::size_t body, double time) const {
  const std::vector<Change>& changes = of_[body];
  bool there = changes.empty() || !changes.front().there;
  for (const Change& c : changes)
    if (c.time <= time) there = c.there;
  return there;
}

bool Presence::is_followed(std::size_t body, double time) const {
  return time < left_[body] && is_there(body, time);
}

}  // namespace trilith::results
