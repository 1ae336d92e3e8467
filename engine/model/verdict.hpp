// Whether a run may be trusted: what its events say of it, over all its stages. The same from a run and from its file.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/event.hpp"

namespace trilith {

/// What makes a run one not to be trusted.
enum class Fault { diverged, not_at_rest, passed };
inline constexpr int fault_types = 3;

/// All faults of one type.
struct FaultCount {
  std::int64_t count = 0;
  double time = 0;    ///< until which the run is sound, by the first of them [s]
  std::string first;  ///< in words: the first
};

class Verdict {
 public:
  /// Takes note of an event, where it says anything of this. `value`: Event::value, or the first figure of a results
  /// file; `text`: as event_text has it. A run in which bodies leave the bounds is sound all the same.
  void add(EventType type, double time, double value, const std::string& text);

  [[nodiscard]] const FaultCount& fault(Fault type) const { return fault_[static_cast<std::size_t>(type)]; }
  [[nodiscard]] bool has(Fault type) const { return fault(type).count > 0; }
  [[nodiscard]] bool sound() const;
  /// Until when the run may be trusted [s]; 0 where it is sound throughout.
  [[nodiscard]] double sound_until() const;
  /// "not to be trusted after 3.2 s: element 1 of q was squeezed by 51 %"; "" where it is sound. `zero`: from when
  /// times are counted [s].
  [[nodiscard]] std::string text(double zero = 0) const;
  /// Bodies that left the bounds.
  [[nodiscard]] std::int64_t left() const { return left_; }

 private:
  std::vector<FaultCount> fault_ = std::vector<FaultCount>(fault_types);
  std::int64_t left_ = 0;
};

}  // namespace trilith
