// Causes of events: ids, and the last event of each body.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/event/event.hpp"

namespace trilith {

/// Numbers events and sets their causes. A cause is the latest event that loaded or loosened one of the bodies: failure
/// or change of a bearing, lost seat, impact, broken bond. Without such an event it is the stage. Contacts made and
/// lost, and rest, are not causes.
class Causes {
 public:
  explicit Causes(int bodies) : last_(static_cast<std::size_t>(bodies), -1) {}

  /// Sets the number of bodies, which must not decrease.
  void grow(std::size_t bodies) { last_.resize(bodies, -1); }
  /// Sets `id` and `cause` of `event`.
  void name(Event& event);
  /// Calls each(member) for all members.
  template <class Each>
  void each_number(Each&& each) {
    each(last_), each(stage_), each(next_);
  }

 private:
  std::vector<std::int64_t> last_;  // [body] id of the last event that can be a cause, or -1
  std::int64_t stage_ = -1;
  std::int64_t next_ = 0;
};

}  // namespace trilith
