// When bodies are there: a model may change, and then a body has a first and a last time.
#pragma once

#include <vector>

#include "results/file/results.hpp"

namespace trilith::results {

/// By the events of a file: body.added, body.removed and body.left.
class Presence {
 public:
  Presence(const std::vector<EventRow>& events, std::size_t bodies);

  /// Whether the body is in the model at that time [s]; at the very time of a change, whether it is afterwards.
  [[nodiscard]] bool is_there(std::size_t body, double time) const;
  /// The same, but what left the bounds counts as gone.
  [[nodiscard]] bool is_followed(std::size_t body, double time) const;
  /// True where some body comes late or is removed.
  [[nodiscard]] bool changes() const { return changes_; }

 private:
  struct Change {
    double time;
    bool there;
  };
  std::vector<std::vector<Change>> of_;  // [body] in time
  std::vector<double> left_;             // [body] when it left the bounds
  bool changes_ = false;
};

}  // namespace trilith::results
