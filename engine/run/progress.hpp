// Text output of a running simulation: one status line, and events with their causes. Plain text without a terminal.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/event/event_list.hpp"
#include "run/stage.hpp"

namespace trilith {

/// Speed of a stage from the last seconds of wall-clock time.
class Pace {
 public:
  /// Simulated time and wall clock, both rising [s].
  void add(double time, double wall);
  /// Clears the samples at the start of a stage.
  void reset() { samples_.clear(); }
  /// Simulated seconds per second of wall clock; 0 where not yet known.
  [[nodiscard]] double speed() const;
  /// Wall clock until `end` is reached [s]; none if not yet known.
  [[nodiscard]] std::optional<double> left(double end) const;

 private:
  struct Sample {
    double time, wall;
  };
  std::deque<Sample> samples_;
};

/// Kinetic energy of all nodes [J].
template <int D>
double kinetic_energy(const Model<D>& model, const State<D>& state);

/// "shaking t 12.431 s step 124310 dt 0.1 ms 12.3 x real time kinetic 1.23 MJ unbalanced 3.2e-05 0:45 left". `zero`:
/// run time at which t is 0 [s].
template <int D>
std::string status_text(const Instant<D>& now, const Pace& pace, double zero = 0);

/// "0:45", "2:03:10": a duration in wall clock [s].
std::string duration_text(double seconds);

/// "shaking ended (rest) after 12.4 s in 124,310 steps of 0.1 to 0.2 ms, 8.1 s of wall clock (1.53 x real time), 2
/// threads: 1.6 times one".
std::string stage_text(const StageReport& report, double wall);

enum class EventShow { none, important, all };

/// Formats events as lines. Unless all are requested, contacts made and lost, bodies at rest and slow impacts are
/// omitted, and groups of impacts and broken bonds are counted.
class EventLines {
 public:
  /// `least_impact`: slower impacts are omitted [m/s]. `since`: times count from the start of the stage of this name,
  /// or from the first event of this type; "": from the start of the run.
  explicit EventLines(EventShow show = EventShow::important, double least_impact = slow_impact, std::string since = "")
      : show_(show), least_impact_(least_impact), since_(std::move(since)) {}

  /// Lines for `event`, usually one or none: " 12.430 s seat lost S3 lost its seat on P3 (right) (because at 11.020 s:
  /// bearing S3.left failed at 51 mm)".
  template <int D>
  std::vector<std::string> tell(const Event& event, const Model<D>& model);
  /// Lines still outstanding at the end of a stage.
  std::vector<std::string> rest();
  /// Present zero of the displayed times [s of the run].
  [[nodiscard]] double zero() const { return zero_; }
  /// True until the named stage or event occurs.
  [[nodiscard]] bool waits() const { return !since_.empty(); }

 private:
  struct Crowd {
    double since = 0, last = 0;  ///< times of the first event and of the last hidden one [s]
    int shown = 0, hidden = 0;
  };
  [[nodiscard]] bool leaves_out(const Event& event) const;
  bool thins_out(const Event& event, std::vector<std::string>& lines);
  /// "     4.860 s  ... and 164 more: bond broken", with the time of the last one.
  [[nodiscard]] std::string crowd_line(const Crowd& crowd, EventType type) const;
  /// Resets the zero of times when the named stage or event occurs, and reports it.
  void count_from(const Event& event, std::vector<std::string>& lines);

  EventShow show_;
  double least_impact_;
  std::string since_;  // "" after it has occurred
  double zero_ = 0;
  struct Cause {
    double time;
    std::string text;
  };
  std::map<const void*, std::map<std::int64_t, Cause>> causes_;  // [model][id]
  std::array<Crowd, event_types> crowd_{};
};

}  // namespace trilith
