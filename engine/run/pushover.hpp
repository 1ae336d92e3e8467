// Pushover: the force of a push over its displacement, its largest force, and when to end.
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

/// The step in which a push took most.
struct PushPeak {
  double time = 0, displacement = 0, force = 0, drift = 0;  ///< as in PushCurve, of one instant
  double carried = 0;  ///< part of this force that the structure carries in statics [N]. Inertia and damping carry the
                       ///< rest: by the balance along the push, its power, or the weight that supports carry at this
                       ///< instant, whichever differs most

  /// Inertia and damping may have this share of the force where it is to be a capacity.
  static constexpr double most_of_inertia = 0.05;
  [[nodiscard]] double share_of_inertia() const;
  /// Whether the force is one of statics to that share.
  [[nodiscard]] bool is_static() const { return share_of_inertia() <= most_of_inertia; }
};

/// The curve with the peak as a further point of it, in its place by time.
PushCurve with_peak(PushCurve curve, const PushPeak& peak);

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
  /// Of all steps; all 0 before the first.
  [[nodiscard]] const PushPeak& peak() const { return peak_; }
  /// "drift" or "drop"; "" while no limit is reached.
  [[nodiscard]] const std::string& limit() const { return limit_; }

 private:
  void take_sample();
  void take_work(const Instant<D>& now, double place, double force);
  void take_peak(const Instant<D>& now, const Push<D>& push, const PushPeak& one);

  std::string name_;
  double interval_;
  PushLimits limits_;
  std::function<double(const Instant<D>&)> drift_;
  bool begun_ = false, has_peak_ = false;
  bool peak_in_sample_ = false;                 // the running one
  double last_place_ = 0;                       // a step ago [m]
  double push_work_ = 0, unbalanced_work_ = 0;  // in the running sample [J]
  double first_place_ = 0, first_drift_ = 0, next_ = 0;
  double time_ = 0, displacement_ = 0, force_ = 0, sway_ = 0, weight_ = 0;  // sums over the sample, times the step
  int low_ = 0;                                                             // samples in a row that were below the drop
  PushCurve curve_;
  PushPeak peak_;
  std::string limit_;
};

}  // namespace trilith
