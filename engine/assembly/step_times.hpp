// Run times of the parts of a step, for profiles. Without a request nothing is measured; the cost is one branch for
// each part.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <vector>

namespace trilith {

/// Parts of a step, in their order.
enum class StepPart : int {
  place,
  find,
  faces,
  general,
  bearings,
  resist,
  sum,
  estimate,
  record,
  events,
  advance,
  tangent,
  factorise,
  solve,
  search,
  listen
};
inline constexpr int step_parts = 16;
inline constexpr std::array<const char*, step_parts> step_part_names{"place",
                                                                     "find",
                                                                     "respond: faces",
                                                                     "respond: other shapes",
                                                                     "respond: bearings",
                                                                     "resist",
                                                                     "sum",
                                                                     "length of the step",
                                                                     "record",
                                                                     "events",
                                                                     "advance",
                                                                     "implicit: tangent",
                                                                     "implicit: factors of it",
                                                                     "implicit: solving with them",
                                                                     "implicit: shorter tries",
                                                                     "handlers and listeners"};

/// Wall-clock time of each part [s].
struct StepTimes {
  std::array<double, step_parts> part{};
  std::vector<double> law;  ///< of face contacts, by contact law
  std::int64_t steps = 0;
  double all = 0;  ///< of whole stages
};

/// Adds the time after the last mark to a part. Does nothing if `times` is nullptr.
class StepClock {
 public:
  explicit StepClock(StepTimes* times) : times_(times) {
    if (times_ != nullptr) last_ = Clock::now();
  }
  void mark(StepPart part) {
    if (times_ != nullptr) times_->part[static_cast<std::size_t>(part)] += lap();
  }
  /// Adds it to the faces of one law.
  void mark_law(int law) {
    if (times_ == nullptr) return;
    const auto row = static_cast<std::size_t>(law);
    if (row >= times_->law.size()) times_->law.resize(row + 1);
    const double took = lap();
    times_->law[row] += took;
    times_->part[static_cast<std::size_t>(StepPart::faces)] += took;
  }
  /// Ignores the time after the last mark, which another clock measures.
  void skip() {
    if (times_ != nullptr) last_ = Clock::now();
  }

 private:
  using Clock = std::chrono::steady_clock;
  double lap() {
    const Clock::time_point now = Clock::now();
    const double took = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return took;
  }
  StepTimes* times_;
  Clock::time_point last_;
};

}  // namespace trilith
