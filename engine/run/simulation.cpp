#include "run/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/error.hpp"
#include "step/central_difference.hpp"
#include "step/evaluate.hpp"
#include "step/stable_step.hpp"
#include "step/start.hpp"

namespace trilith {
namespace {

/// The step is looked at anew every so many steps.
constexpr std::int64_t steps_between_estimates = 32;

void check(const StageOptions& o) {
  const std::string owner = fmt::format("stage '{}'", o.name);
  require_positive(o.duration, owner + ": duration", "s");
  require_not_negative(o.dt, owner + ": dt", "s");
  if (!(o.safety > 0 && o.safety <= 1))
    throw InputError(fmt::format("{}: safety is {:g}, must be above 0 and at most 1", owner, o.safety));
  if (!(o.rest_share >= 0 && o.rest_share < 1))
    throw InputError(fmt::format("{}: damping share is {:g}, must be at least 0 and below 1", owner, o.rest_share));
  for (const double v : {o.frame_interval, o.history_interval, o.energy_interval})
    require_not_negative(v, owner + ": interval", "s");
  if (o.until_rest) {
    require_positive(o.still_speed, owner + ": speed at rest", "m/s");
    require_positive(o.still_ratio, owner + ": unbalanced ratio at rest", "1");
    require_not_negative(o.still_hold, owner + ": hold", "s");
  }
}

/// Samples at even times after the start of the stage, counted, so that no rounding adds up.
struct Clock {
  double begun, interval;
  std::int64_t next = 0;
  bool due(double time, double dt) {
    if (interval <= 0 || time < begun + static_cast<double>(next) * interval - 0.5 * dt) return false;
    next = static_cast<std::int64_t>((time + 0.5 * dt - begun) / interval) + 1;
    return true;
  }
};

}  // namespace

Simulation::Simulation(Model<2> model)
    : model_(std::move(model)), state_(start_state(model_)), causes_(static_cast<int>(model_.bodies.size())) {}

Simulation::Simulation(Model<2> model, State<2> state)
    : model_(std::move(model)), state_(std::move(state)), causes_(static_cast<int>(model_.bodies.size())) {
  assert(state_.position.size() == model_.mass.size());
}

Model<2>& Simulation::edit_model() {
  assert(!running_);
  work_.valid = false;
  return model_;
}

void Simulation::lift_bonds() {
  assert(!running_);
  trilith::lift_bonds(model_, state_);
  drop_work();
}
void Simulation::set_bonds(double reach) {
  assert(!running_);
  trilith::set_bonds(model_, state_, reach);
  drop_work();
}

void Simulation::refresh() {
  evaluate(model_, state_, work_, state_.last_dt);
}
void Simulation::drop_work() {
  work_ = Work<2>{};
}

void Simulation::choose_step(const StageOptions& options) {
  // A stage that asks for another step than the one before is heard at once.
  const double safety = options.dt > 0 ? 0 : options.safety;
  const bool other = state_.safety != safety || (options.dt > 0 && state_.dt != options.dt);
  if (!other && state_.dt != 0 && state_.step % steps_between_estimates != 0) return;
  const StableStep s = stable_step(model_, state_, work_);
  if (options.dt > s.dt)
    throw InputError(fmt::format(
        "stage '{}': dt is {:g} s, the longest stable step is {:.4g} s at t = {:.4g} s; leave dt out, or: {}",
        options.name, options.dt, s.dt, state_.time, explain_step(model_, state_, work_)));
  state_.dt = options.dt > 0 ? options.dt : settled_step(s.dt, options.safety);
  state_.safety = safety;
}

void Simulation::tell(EventType type, const std::string& text, const RunListener& listener, const Instant& now) {
  Event e;
  e.type = type;
  e.time = state_.time;
  e.step = state_.step;
  e.text = text;
  causes_.name(e);
  if (listener.on_event) listener.on_event(e, now);
}

void Simulation::tell_events(const RunListener& listener, const Instant& now) {
  for (Event& e : work_.events) {
    causes_.name(e);
    if (listener.on_event) listener.on_event(e, now);
  }
}

StageReport Simulation::run(const StageOptions& options, const RunListener& listener) {
  check(options);
  struct Running {
    bool& flag;
    explicit Running(bool& f) : flag(f) { flag = true; }
    ~Running() { flag = false; }
  } running(running_);
  stop_ = false;
  StageReport report;
  report.name = options.name;
  report.begun = state_.time;
  const double end = state_.time + options.duration;
  Clock frames{state_.time, options.frame_interval}, histories{state_.time, options.history_interval},
      energies{state_.time, options.energy_interval};
  double still_since = state_.time;
  bool first = true;
  for (;; first = false) {
    evaluate(model_, state_, work_, state_.last_dt);
    choose_step(options);
    const bool last = state_.time >= end - 1e-9 * options.duration;
    const double dt = last ? state_.dt : std::min(state_.dt, end - state_.time);
    const Instant now{model_,
                      state_,
                      work_,
                      options,
                      report.begun,
                      dt,
                      work_.fastest_moving,
                      work_.carried > 0 ? work_.unbalanced / work_.carried : 0};
    report.speed = now.speed;
    report.ratio = now.ratio;
    if (first) tell(EventType::stage_begun, options.name, listener, now);
    const bool calm = now.speed <= options.still_speed && now.ratio <= options.still_ratio;
    if (!calm || state_.time < report.begun + options.still_from) still_since = state_.time;
    const bool rests = options.until_rest && state_.time - still_since >= options.still_hold && !first;
    const bool stopped = stop_.load(std::memory_order_relaxed);
    const bool broken = !std::isfinite(now.speed) || !std::isfinite(work_.unbalanced);
    const bool ends = last || rests || stopped || broken;
    if (!broken) {
      if ((frames.due(state_.time, dt) || (ends && options.frame_interval > 0)) && listener.on_frame)
        listener.on_frame(now);
      if ((histories.due(state_.time, dt) || (ends && options.history_interval > 0)) && listener.on_history)
        listener.on_history(now);
      if ((energies.due(state_.time, dt) || (ends && options.energy_interval > 0)) && listener.on_energy)
        listener.on_energy(now, energy_now(model_, state_, work_, {dt, {options.rest_share}}));
    }
    if (ends) {
      report.end = broken               ? StageEnd::diverged
                   : rests              ? StageEnd::rest
                   : stopped            ? StageEnd::stopped
                   : options.until_rest ? StageEnd::not_at_rest
                                        : StageEnd::time;
      report.ended = state_.time;
      tell(EventType::stage_ended, fmt::format("{}: {}", options.name, name_of(report.end)), listener, now);
      return report;
    }
    report.shortest_dt = report.steps == 0 ? dt : std::min(report.shortest_dt, dt);
    report.longest_dt = std::max(report.longest_dt, dt);
    ++report.steps;
    advance(model_, state_, work_, {dt, {options.rest_share}});
    if (!work_.events.empty()) tell_events(listener, now);
    if (listener.on_step) listener.on_step(now);
    if (listener.change_model && listener.change_model(model_)) work_.valid = false;
  }
}

}  // namespace trilith
