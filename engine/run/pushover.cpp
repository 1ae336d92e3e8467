#include "run/pushover.hpp"

#include <algorithm>
#include <cmath>

#include "world/pushes.hpp"

namespace trilith {

namespace {
/// The force must stay below the drop for so many samples, as one may swing.
constexpr int samples_below = 3;
}  // namespace

std::size_t PushCurve::peak() const {
  return static_cast<std::size_t>(std::max_element(force.begin(), force.end()) - force.begin());
}

template <int D>
PushoverRecorder<D>::PushoverRecorder(std::string name, double interval, const PushLimits& limits,
                                      std::function<double(const Instant<D>&)> drift)
    : name_(std::move(name)), interval_(interval), limits_(limits), drift_(std::move(drift)) {}

/// Adds the step to the mean of the running sample. True where a limit is reached.
template <int D>
bool PushoverRecorder<D>::step(const Instant<D>& now) {
  const auto& pushes = now.model.pushes;
  const auto at = std::find_if(pushes.begin(), pushes.end(), [&](const Push<D>& p) { return p.name == name_; });
  const auto index = static_cast<std::size_t>(at - pushes.begin());
  if (at == pushes.end() || index >= now.work.push_force.size()) return false;
  const double place = push_place(now.state, *at), drift = drift_(now);
  if (!begun_) {
    begun_ = true;
    first_place_ = at->origin + at->motion->displacement(0);
    first_drift_ = drift;
    next_ = now.state.time - now.state.last_dt + interval_;
  }
  // Means over the interval, weighed by the steps: the force of a push rings with the contacts, and a single instant of
  // it says little.
  const double dt = now.dt;
  time_ += dt * now.state.time, displacement_ += dt * (place - first_place_), force_ += dt * now.work.push_force[index];
  sway_ += dt * (drift - first_drift_), weight_ += dt;
  if (now.state.time >= next_ - 0.5 * dt) {
    take_sample();
    next_ += interval_;
  }
  if (limit_.empty() && std::abs(drift - first_drift_) >= limits_.drift) limit_ = "drift";
  return !limit_.empty();
}

template <int D>
void PushoverRecorder<D>::take_sample() {
  if (!(weight_ > 0)) return;
  curve_.time.push_back(time_ / weight_);
  curve_.displacement.push_back(displacement_ / weight_);
  curve_.force.push_back(force_ / weight_);
  curve_.drift.push_back(sway_ / weight_);
  time_ = displacement_ = force_ = sway_ = weight_ = 0;
  // Below a share of the peak so far, sample after sample: it has dropped.
  const double peak = curve_.force[curve_.peak()];
  low_ = peak > 0 && curve_.force.back() < limits_.drop * peak ? low_ + 1 : 0;
  if (limit_.empty() && low_ >= samples_below) limit_ = "drop";
}

template <int D>
void PushoverRecorder<D>::finish() {
  take_sample();
}

template class PushoverRecorder<2>;
template class PushoverRecorder<3>;

}  // namespace trilith
