// Reliability of a run, from its events over all stages. Equal for a run and for its results file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/event/event.hpp"

namespace trilith {

/// All events of one type that make a run invalid.
struct FaultCount {
  std::int64_t count = 0;
  double time = 0;    ///< time until which the run is reliable, from the first of them [s]
  std::string first;  ///< the first, as text
};

/// A check of the seal that failed.
struct FailedCheck {
  double time = 0;  ///< time until which the run is reliable [s]
  std::string text;
};

class Verdict {
 public:
  /// Whether `add` counts events of this type: the invalid ones, and bodies that leave the bounds.
  [[nodiscard]] static bool counts(EventType type);
  /// Counts an event. `value`: Event::value, or the first figure of a results file; `text`: as from event_text. A run
  /// in which bodies leave the bounds is still reliable.
  void add(EventType type, double time, double value, const std::string& text);

  /// Adds a failed check of the seal: its text, and the time until which the run is reliable [s].
  void fail(double time, const std::string& text) { failed_.push_back({time, text}); }

  [[nodiscard]] const FaultCount& fault(EventType type) const { return fault_[static_cast<std::size_t>(type)]; }
  [[nodiscard]] bool has(EventType type) const { return fault(type).count > 0; }
  [[nodiscard]] bool sound() const;
  /// Time until which the run is reliable [s]; 0 if it is reliable throughout.
  [[nodiscard]] double sound_until() const;
  /// "not reliable after 3.2 s: element 1 of q was squeezed by 51 %"; "" if it is reliable. `zero`: origin of time
  /// [s].
  [[nodiscard]] std::string text(double zero = 0) const;
  /// Number of bodies that left the bounds.
  [[nodiscard]] std::int64_t left() const { return left_; }
  /// Calls each(member) for all members.
  template <class Each>
  void each_number(Each&& each) {
    each(fault_), each(left_), each(failed_);
  }

 private:
  std::vector<FaultCount> fault_ = std::vector<FaultCount>(event_types);
  std::int64_t left_ = 0;
  std::vector<FailedCheck> failed_;
};

}  // namespace trilith
