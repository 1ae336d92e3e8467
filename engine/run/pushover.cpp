#include "run/pushover.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/pushes.hpp"
#include "statics/push_compliance.hpp"

namespace trilith {

namespace {
/// Number of samples for which the force must stay below the drop, because a sample may oscillate.
constexpr int samples_below = 3;
/// Forces of two steps that differ by less than this share are one peak.
constexpr double same_force = 1e-3;
}  // namespace

std::size_t PushCurve::peak() const {
  return static_cast<std::size_t>(std::max_element(force.begin(), force.end()) - force.begin());
}

double PushPeak::share_of_inertia() const {
  return force != 0 ? std::abs(force - carried) / std::abs(force) : 0;
}

PushCurve with_peak(PushCurve curve, const PushPeak& peak) {
  const auto at = std::upper_bound(curve.time.begin(), curve.time.end(), peak.time) - curve.time.begin();
  curve.time.insert(curve.time.begin() + at, peak.time);
  curve.displacement.insert(curve.displacement.begin() + at, peak.displacement);
  curve.force.insert(curve.force.begin() + at, peak.force);
  curve.drift.insert(curve.drift.begin() + at, peak.drift);
  return curve;
}

template <int D>
PushoverRecorder<D>::PushoverRecorder(std::string name, double interval, const PushLimits& limits,
                                      std::function<double(const Instant<D>&)> drift)
    : name_(std::move(name)), interval_(interval), limits_(limits), drift_(std::move(drift)) {}

/// Adds the step to the mean of the running sample. True if a limit is reached.
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
    last_place_ = place;
    next_ = now.state.time - now.state.last_dt + interval_;
  }
  take_work(now, place, now.work.push_force[index]);
  take_peak(now, *at, {now.state.time, place - first_place_, now.work.push_force[index], drift - first_drift_});
  // Time-weighted means over the interval: the force of a push oscillates with the contacts, so a single instant is not
  // representative.
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
void PushoverRecorder<D>::take_work(const Instant<D>& now, double place, double force) {
  push_work_ += force * (place - std::exchange(last_place_, place));
  unbalanced_work_ += unbalanced_power(now.model, now.state, now.work) * now.state.last_dt;
}

namespace {

/// Force that the supports carry across the push at rest, over the present one. It is below 1 while bodies are
/// accelerated upward; joints in friction or rocking then carry more along the push than at rest. It is 1 without
/// gravity across the push, and where no support is pressed.
template <int D>
double share_at_rest(const Model<D>& model, const State<D>& state, const Work<D>& work, const Vec<D>& direction) {
  const Vec<D> field = model.gravity.at(state.time), across = field - direction * field.dot(direction);
  const double gravity = across.norm();
  if (!(gravity > 0)) return 1;
  const Vec<D> down = across / gravity;
  const double carried = force_on_supports(model, state, work, down);
  if (!(carried > 0)) return 1;
  return std::clamp(1 + unsupported_force(model, work, down) / carried, 0.0, 2.0);
}

}  // namespace

/// `one`: values at this instant.
template <int D>
void PushoverRecorder<D>::take_peak(const Instant<D>& now, const Push<D>& push, const PushPeak& one) {
  if (has_peak_ && one.force <= peak_.force) return;
  PushPeak next = one;
  next.carried = one.force - unsupported_force(now.model, now.work, push.direction);
  const auto estimate = [&](double carried) {
    if (std::abs(one.force - carried) > std::abs(one.force - next.carried)) next.carried = carried;
  };
  estimate(one.force * share_at_rest(now.model, now.state, now.work, push.direction));
  // A structure that rotates or sways under the push may have inertia although all forces balance along the push. A
  // single step is not representative, and a break after the peak does not belong to it. Where motion slows down, as in
  // a landing, the energy does not come from the push.
  const double push_work = push_work_before_ + push_work_, unbalanced = unbalanced_work_before_ + unbalanced_work_;
  if (push_work != 0) estimate(one.force * std::clamp(1 - unbalanced / push_work, 0.0, 1.0));
  // In the step of a break the push still has its force, and the broken part has none.
  const bool at_break =
      has_peak_ && peak_.is_static() && !next.is_static() && one.force < (1 + same_force) * peak_.force;
  if (at_break) return;
  has_peak_ = true, peak_ = next;
}

template <int D>
void PushoverRecorder<D>::take_sample() {
  if (!(weight_ > 0)) return;
  push_work_before_ = std::exchange(push_work_, 0), unbalanced_work_before_ = std::exchange(unbalanced_work_, 0);
  curve_.time.push_back(time_ / weight_);
  curve_.displacement.push_back(displacement_ / weight_);
  curve_.force.push_back(force_ / weight_);
  curve_.drift.push_back(sway_ / weight_);
  time_ = displacement_ = force_ = sway_ = weight_ = 0;
  // A drop: the force stays below a share of the peak for several samples.
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
