// Presence of bodies over time: a model may change, and then a body has a first and a last time.
#pragma once

#include <vector>

#include "results/file/results.hpp"

namespace trilith::results {

/// From the events of a file: body.added, body.removed and body.left.
class Presence {
 public:
  Presence(const std::vector<EventRow>& events, std::size_t bodies);

  /// True if the body is in the model at that time [s]; at the time of a change, the state after it.
  [[nodiscard]] bool is_there(std::size_t body, double time) const;
  /// As above; bodies that left the bounds count as absent.
  [[nodiscard]] bool is_followed(std::size_t body, double time) const;
  /// True if some body is added late or removed.
  [[nodiscard]] bool changes() const { return changes_; }

 private:
  struct Change {
    double time;
    bool there;
  };
  std::vector<std::vector<Change>> of_;  // [body] sorted by time
  std::vector<double> left_;             // [body] time at which it left the bounds
  bool changes_ = false;
};

}  // namespace trilith::results
