// Pushover: force of a push over its displacement, peak force, and end criteria.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "run/stage.hpp"

namespace trilith {

/// Criteria that end a pushover before its displacement is reached.
struct PushLimits {
  double drift = unbounded;  ///< largest drift in either sense [m]
  double drop = 0;           ///< share of the peak to which the force must fall, below 1; 0: never
};

/// Samples, each the mean over an interval of time.
struct PushCurve {
  std::vector<double> time;          ///< [s]
  std::vector<double> displacement;  ///< mean displacement of the pushed points along the push, from its start [m]
  std::vector<double> force;         ///< force of the push, along it [N]
  std::vector<double> drift;         ///< from the start of the push [m]

  /// Sample with the largest force; 0 if there are no samples.
  [[nodiscard]] std::size_t peak() const;
};

/// The step with the largest force of a push.
struct PushPeak {
  double time = 0, displacement = 0, force = 0, drift = 0;  ///< as in PushCurve, at one instant
  double carried = 0;  ///< part of this force that the structure carries statically [N]. The rest is inertia and
                       ///< damping, the largest of three estimates: the balance along the push, the share of weight
                       ///< and loads that supports carry, and the power of the push. Power counts over one to two
                       ///< samples that end at the peak.

  /// Largest share of inertia and damping at which the force counts as a capacity.
  static constexpr double most_of_inertia = 0.02;
  [[nodiscard]] double share_of_inertia() const;
  /// True if the force is static within this share.
  [[nodiscard]] bool is_static() const { return share_of_inertia() <= most_of_inertia; }
};

/// The curve with the peak inserted as a further point, sorted by time.
PushCurve with_peak(PushCurve curve, const PushPeak& peak);

/// Records the push `name` during a stage.
template <int D>
class PushoverRecorder {
 public:
  /// A sample each `interval` [s]; `drift` gives the drift now [m].
  PushoverRecorder(std::string name, double interval, const PushLimits& limits,
                   std::function<double(const Instant<D>&)> drift);

  /// Call it after each step. Returns true when a limit is reached.
  bool step(const Instant<D>& now);
  /// Adds the last, unfinished sample.
  void finish();

  [[nodiscard]] const PushCurve& curve() const { return curve_; }
  /// Peak of all steps; zero before the first step.
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
  double last_place_ = 0;  // at the previous step [m]
  // Work of the push, and of all forces on free degrees of freedom: in the running sample up to now, and in the sample
  // before it [J].
  double push_work_ = 0, unbalanced_work_ = 0, push_work_before_ = 0, unbalanced_work_before_ = 0;
  double first_place_ = 0, first_drift_ = 0, next_ = 0;
  double time_ = 0, displacement_ = 0, force_ = 0, sway_ = 0, weight_ = 0;  // sums over the sample, times the step
  int low_ = 0;                                                             // consecutive samples below the drop
  PushCurve curve_;
  PushPeak peak_;
  std::string limit_;
};

}  // namespace trilith
