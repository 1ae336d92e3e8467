// Pushover: what a push takes against how far it has come, and when to end.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "run/stage.hpp"

namespace trilith {

/// What ends a pushover before its displacement is reached.
struct PushLimits {
  double drift = unbounded;  ///< of `drift` either way [m]
  double drop = 0;           ///< share of the peak to which the force must fall, below 1; 0: never
};

/// Samples, each the mean over an interval of time.
struct PushCurve {
  std::vector<double> time;          ///< [s]
  std::vector<double> displacement;  ///< of the pushed points along the push, since its begin [m]
  std::vector<double> force;         ///< that the push takes, along it [N]
  std::vector<double> drift;         ///< since its begin [m]

  /// Sample with the largest force, 0 where there is none.
  [[nodiscard]] std::size_t peak() const;
};

/// Follows the push `name` through a stage.
template <int D>
class PushoverRecorder {
 public:
  /// A sample each `interval` [s]; `drift` gives the drift now [m].
  PushoverRecorder(std::string name, double interval, const PushLimits& limits,
                   std::function<double(const Instant<D>&)> drift);

  /// After a step. True once a limit is reached.
  bool step(const Instant<D>& now);
  /// Takes the last, unfinished sample in.
  void finish();

  [[nodiscard]] const PushCurve& curve() const { return curve_; }
  /// "drift" or "drop"; "" while no limit is reached.
  [[nodiscard]] const std::string& limit() const { return limit_; }

 private:
  void take_sample();

  std::string name_;
  double interval_;
  PushLimits limits_;
  std::function<double(const Instant<D>&)> drift_;
  bool begun_ = false;
  double first_place_ = 0, first_drift_ = 0, next_ = 0;
  double time_ = 0, displacement_ = 0, force_ = 0, sway_ = 0, weight_ = 0;  // sums over the sample, times the step
  int low_ = 0;                                                             // samples in a row that were below the drop
  PushCurve curve_;
  std::string limit_;
};

}  // namespace trilith
