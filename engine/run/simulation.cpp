#include "run/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <utility>

#include "assembly/evaluate.hpp"
#include "assembly/field/joint_water.hpp"
#include "assembly/start.hpp"
#include "assembly/tangent/tangent.hpp"
#include "assembly/water/water_mass.hpp"
#include "base/error.hpp"
#include "base/flagged.hpp"
#include "edit/deactivate.hpp"
#include "events/commit.hpp"
#include "integrate/explicit/bond_step.hpp"
#include "integrate/explicit/deep_penetration.hpp"
#include "integrate/explicit/impact_step.hpp"
#include "integrate/explicit/skipped_bonds.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "run/field/friction_heat.hpp"
#include "run/field/seepage_step.hpp"
#include "run/stage_end.hpp"
#include "run/watch.hpp"
#include "statics/displacement_control.hpp"

namespace trilith {
namespace {

/// A step is too short below this length [s], or below this share of its stage: time would not advance.
constexpr double shortest_step = 1e-12, shortest_share = 1e-9;
/// With fewer steps, the kinetic energy at the middle of a leapfrog step is not a measure of its energy error.
constexpr std::int64_t least_told_steps = 20;
/// A stage of at least this duration [s] is expected to end by rest, by a number of steps, or by the user.
constexpr double open_ended = 1e8;

}  // namespace

template <int D>
Simulation<D>::Simulation(Model<D> model)
    : model_(std::move(model)),
      state_(start_state(model_)),
      causes_(static_cast<int>(model_.bodies.size())),
      watch_(std::make_unique<Watch>()),
      tangent_(std::make_unique<Tangent<D>>()) {}

template <int D>
Simulation<D>::Simulation(Model<D> model, State<D> state)
    : model_(std::move(model)),
      state_(std::move(state)),
      causes_(static_cast<int>(model_.bodies.size())),
      watch_(std::make_unique<Watch>()),
      tangent_(std::make_unique<Tangent<D>>()) {
  assert(state_.position.size() == model_.mass.size());
  all_left_ = hold_left(model_, state_);
}

template <int D>
Simulation<D>::~Simulation() = default;

template <int D>
Model<D>& Simulation<D>::edit_model() {
  assert(!running_ || at_border_);
  unscale_masses();
  edited();
  return model_;
}

/// Resets all derived data after a change of the model.
template <int D>
void Simulation<D>::edited() {
  work_.valid = evaluated_ = false;
  tangent_->forget();
  watch_->invalidate();
  kept_model_.reset();
}

template <int D>
void Simulation<D>::edit(const std::function<void(Model<D>&)>& change) {
  const int before = model_.free_dofs();
  change(edit_model());
  if (model_.free_dofs() > before) drop_step();
}

/// Bonds are part of State; pairs and their rows are rebuilt afterwards.
template <int D>
void Simulation<D>::lift_bonds() {
  assert(!running_);
  trilith::lift_bonds(model_, state_);
  drop_work();
}
template <int D>
void Simulation<D>::set_bonds(double reach) {
  assert(!running_);
  trilith::set_bonds(model_, state_, reach);
  drop_work();
}

/// Evaluates, then finds the length of the next step, then the forces of displacement control, which depend on it.
template <int D>
void Simulation<D>::refresh() {
  if (evaluated_) return;
  if (!work_.valid) all_left_ = hold_left(model_, state_), watch_->bonds().reset();
  evaluate(model_, state_, work_, state_.last_dt, times_);
  StepClock clock(times_);
  next_ = choose_step();
  swept_ = tunnelling_limit(model_, state_, work_, whole_step(), next_.safety > 0 ? depth_per_step : deepest_per_step);
  if (const double accuracy = impact_accuracy(); accuracy > 0)
    swept_.dt = impact_step(model_, state_, work_, swept_.dt, {accuracy, next_.safety});
  // A given step is kept, even if a bond breaks within it without part of its work: skipped_bonds reports it.
  if (!state_.implicit()) {
    const double dt = bond_step(model_, state_, work_, swept_.dt, watch_->bonds());
    if (next_.safety > 0) swept_.dt = dt;
  }
  clock.mark(StepPart::estimate);
  if (next_.dt > 0) control_displacement(model_, state_, work_, {swept_.dt, rest_});
  add_water_inertia(model_, state_, work_, {swept_.dt, rest_});
  add_inertia(model_, state_, work_, {swept_.dt, rest_});
  if (!state_.added_share.empty()) clock.mark(StepPart::advance);
  evaluated_ = true;
}

template <int D>
void Simulation<D>::drop_work() {
  work_.drop();
  evaluated_ = false;
}

/// The next step ends with the stage at the latest.
template <int D>
double Simulation<D>::whole_step() const {
  if (!stage_ || state_.time >= stage_->end - 1e-9 * stage_->options.duration) return next_.dt;
  return std::min(next_.dt, stage_->end - state_.time);
}

/// Accuracy of impacts where the step length is free; 0 if impacts are ignored. Rest damping dissipates more than such
/// errors.
template <int D>
double Simulation<D>::impact_accuracy() const {
  if (!stage_ || rest_.share > 0 || !(next_.safety > 0)) return 0;
  return stage_->options.impact_accuracy;
}

/// Throws InputError if the next step is longer than the stable step, or so short that no stage would end.
template <int D>
void Simulation<D>::require_step(const StageOptions& options) const {
  if (bound_of(integrator()) == StepBound::accuracy) return;
  const double asked = given_step(options);
  if (asked > 0 && swept_.piece_a >= 0)
    throw InputError(
        fmt::format("stage '{}': dt is {:g} s, must be at most {:.2g} s at t = {:.4g} s, or one body could pass "
                    "through another undetected: {}; leave dt out, and the step is shortened where needed",
                    options.name, options.dt, swept_.needed(), state_.time, explain_tunnelling_limit(model_, swept_)));
  if (next_.longest == 0 && next_.dt > 0) return;  // reused from an earlier estimate
  if (asked > 0 && asked > next_.longest)
    throw InputError(fmt::format(
        "stage '{}': dt is {:g} s, the longest stable step is {:.4g} s at t = {:.4g} s; leave dt out, or: {}",
        options.name, options.dt, next_.longest, state_.time, explain_step(model_, state_, work_)));
  const double share = options.duration < open_ended ? shortest_share : 0;
  const double shortest = std::max(shortest_step, share * options.duration);
  if (next_.dt < shortest)
    throw InputError(fmt::format(
        "stage '{}': the step is {:.3g} s at t = {:.4g} s, must be at least {:.3g} s ({:g} s, and {:g} of the "
        "stage's {:g} s), or it would take too many steps. Check the unit of the stiffness that governs the step: {}",
        options.name, next_.dt, state_.time, shortest, shortest_step, shortest_share, options.duration,
        explain_step(model_, state_, work_)));
}

template <int D>
Energy Simulation<D>::energy() const {
  return energy_now(model_, state_, work_, {swept_.dt, rest_});
}

template <int D>
void Simulation<D>::begin_stage(const StageOptions& options) {
  require_valid(options);
  assert(!running_);
  if (verdict_.has(EventType::stage_diverged))
    throw InputError(
        fmt::format("stage '{}': cannot begin, because the run {}; go back to an earlier time, or build a new model",
                    options.name, verdict_.fault(EventType::stage_diverged).first));
  stage_.emplace(options, state_.time);
  keep_places(options);
  rest_ = {options.rest_share};
  evaluated_ = false;
  watch_->reset();
}

template <int D>
StageReport Simulation<D>::run(const StageOptions& options, const RunListener<D>& listener) {
  begin_stage(options);
  if (!options.mass_scaling) unscale_masses();
  if (const VelocityTimes wanted = wanted_velocities(); wanted != velocity_times(state_)) change_velocities(wanted);
  return go_on(listener);
}

template <int D>
StageReport Simulation<D>::resume(const RunListener<D>& listener) {
  assert(stage_ && !running_);
  return go_on(listener);
}

/// Steps until the stage ends. An exception of a handler ends the stage; the state is then at the last instant.
template <int D>
StageReport Simulation<D>::go_on(const RunListener<D>& listener) {
  const Flagged running(running_);
  stop_ = false;
  try {
    while (!stage_->over) pass(listener);
  } catch (...) {
    unscale_masses();
    stage_.reset();
    throw;
  }
  unscale_masses();
  const StageReport report = std::move(stage_->report);
  stage_.reset();
  return report;
}

/// Called from a handler at the step border: takes further steps, then returns to the handler.
template <int D>
void Simulation<D>::run_on(const RunListener<D>& listener, const RunLimit& limit) {
  assert(running_ && at_border_ && stage_);
  at_border_ = false;
  struct Border {
    bool& flag;
    ~Border() { flag = true; }
  } border{at_border_};
  const std::int64_t begun = state_.step;
  while (!stage_->over) {
    if (limit.steps > 0 && state_.step - begun >= limit.steps) return;
    if (state_.time >= limit.time - 1e-9 * state_.dt) return;
    if (limit.leave && limit.leave()) return;
    pass(listener);
  }
}

/// Copies all data that the run depends on. The model is copied only after it has changed.
template <int D>
Snapshot<D> Simulation<D>::snapshot() {
  if (!kept_model_) kept_model_ = std::make_shared<const Model<D>>(model_);
  return {state_, kept_model_, causes_, stage_, rest_, verdict_, seal_, leaving_, cracking_};
}

template <int D>
void Simulation<D>::restore(const Snapshot<D>& snapshot) {
  assert(!running_ || (at_border_ && snapshot.stage));
  state_ = snapshot.state;
  if (kept_model_ != snapshot.model) model_ = *snapshot.model;
  kept_model_ = snapshot.model;
  causes_ = snapshot.causes;
  verdict_ = snapshot.verdict;
  seal_ = snapshot.seal;
  all_left_ = hold_left(model_, state_);
  watch_->reset();
  tangent_->forget();
  stage_ = snapshot.stage;
  rest_ = snapshot.rest;
  leaving_ = snapshot.untold;
  cracking_ = snapshot.cracking;
  drop_work();
}

/// Deactivates bodies that have left the bounds.
template <int D>
void Simulation<D>::see_off() {
  const std::vector<int> bodies = watch_->leaving(model_, state_, work_);
  if (bodies.empty()) return;
  const bool is_scaled = !state_.added_share.empty();
  if (is_scaled) unscale_masses(), refresh();
  const std::vector<Event> events = deactivate(model_, state_, work_, {swept_.dt, rest_}, bodies);
  leaving_.insert(leaving_.end(), events.begin(), events.end());
  all_left_ = hold_left(model_, state_);
  tangent_->forget();
  kept_model_.reset();
  if (!is_scaled) return;
  evaluated_ = false;
  scale_masses();
  refresh();
}

/// True if the stage ends at this instant; sets the report.
template <int D>
bool Simulation<D>::ends(const RunListener<D>& listener, const Instant<D>& now) {
  StageProgress& stage = *stage_;
  const StageOptions& options = stage.options;
  const bool last = state_.time >= stage.end - 1e-9 * options.duration;
  const bool calm = now.speed <= options.still_speed && now.ratio <= options.still_ratio;
  if (!calm || state_.time < stage.report.begun + options.still_from) stage.still_since = state_.time;
  const bool rests = options.until_rest && state_.time - stage.still_since >= options.still_hold && !stage.first;
  const bool stopped = stop_.load(std::memory_order_relaxed), ending = last || rests || stopped || all_left_;
  const std::optional<Divergence> diverged = watch_->look(now, ending);
  if (!ending && !diverged) return false;
  if (diverged && diverged->event) tell(*diverged->event, listener, now);
  if (!diverged && stage.report.steps >= least_told_steps) stage.report.found = watch_->ledger_text();
  StageEnd end = rests                ? StageEnd::rest
                 : stopped            ? StageEnd::stopped
                 : all_left_          ? StageEnd::all_left
                 : options.until_rest ? StageEnd::not_at_rest
                                      : StageEnd::time;
  const bool found = end == StageEnd::rest || end == StageEnd::all_left;
  if (found && watch_->look_at_places(now).body >= 0) end = StageEnd::unstable;
  set_end(stage.report, now, diverged, end);
  if (end == StageEnd::unstable && !diverged) set_unstable(stage.report, model_, watch_->displaced(), options.within);
  return true;
}

/// Ends the stage if no step was found or the step was stopped; the state is at the last complete step.
template <int D>
void Simulation<D>::fail_stage(const RunListener<D>& listener) {
  refresh();
  const Instant<D> now = instant();
  set_end(stage_->report, now, std::nullopt, stuck_.empty() ? StageEnd::stopped : StageEnd::not_converged);
  stage_->report.reason = std::exchange(stuck_, {});
  stage_->over = true;
  tell_end(listener, now);
}

/// Takes one step with a constant number of threads, which is timed while the number is still open. False if no step
/// was found.
template <int D>
bool Simulation<D>::step_in_time(double dt, const RunListener<D>& listener) {
  using Clock = std::chrono::steady_clock;
  work_.threads = threads_.threads();
  const Clock::time_point began = threads_.is_open() ? Clock::now() : Clock::time_point{};
  const Energy before = state_.implicit() ? energy() : Energy{};
  const bool is_given = next_.safety == 0;
  const bool may_skip = watch_->bonds().near && !state_.implicit();
  const std::vector<HeatDeposit> friction = friction_of_step(model_, state_, work_);
  commit(model_, state_, work_, times_);
  if (!take_step(dt, before, listener)) return false;
  if (!friction.empty()) change_fields([&](State<D>& state) { add_deposits(model_, friction, state.fields); });
  const bool in_time = !model_.fields.empty() && rest_.share == 0;  // local damping has no time of its own
  if (in_time && flows_in_motion(model_, !state_.implicit()))
    flow_after_step(model_, state_.last_dt, watch_->flow(), state_, leaving_);
  refresh();
  if (may_skip) add_skipped_bonds(model_, state_, work_, is_given);
  if (threads_.is_open()) threads_.took(std::chrono::duration<double>(Clock::now() - began).count());
  return true;
}

template <int D>
void Simulation<D>::choose_threads(const ThreadChoice& choice) {
  if (!choice.asks_as(threads_)) threads_ = choice;
  work_.threads = threads_.threads();
}

/// From one step border to the next, or to the end of the stage.
template <int D>
void Simulation<D>::pass(const RunListener<D>& listener) {
  StageProgress& stage = *stage_;
  StageReport& report = stage.report;
  if (stage.options.may_change && !stage.first) choose_integrator();
  scale_masses();
  refresh();
  require_step(stage.options);
  std::vector<Event> passed = report_deep_penetration(model_, state_, work_);  // before bodies that left are
                                                                               // deactivated
  see_off();
  StepClock clock(times_);
  const Instant<D> now = instant();
  report.speed = now.speed;
  report.ratio = now.ratio;
  if (stage.first) tell(stage_event(EventType::stage_begun, now, stage.options.name), listener, now);
  if (!changed_.empty()) tell(integrator_event(now, std::exchange(changed_, {})), listener, now);
  for (Event& e : passed) tell(std::move(e), listener, now);
  for (Event& e : std::exchange(leaving_, {})) tell(std::move(e), listener, now);
  const bool over = ends(listener, now);
  stage.first = false;
  if (!over || report.end != StageEnd::diverged) tell_samples(listener, now, over);
  clock.mark(StepPart::record);
  if (over) {
    stage.over = true;
    tell_end(listener, now);
    return;
  }
  report.shortest_dt = report.steps == 0 ? now.dt : std::min(report.shortest_dt, now.dt);
  report.longest_dt = std::max(report.longest_dt, now.dt);
  ++report.steps;
  state_.dt = next_.dt;
  state_.safety = next_.safety;
  evaluated_ = false;
  if (!step_in_time(now.dt, listener)) return fail_stage(listener);
  tell_step(listener);
  if (times_ != nullptr) ++times_->steps;
  if (!listener.at_border) return;
  const Flagged border(at_border_);
  listener.at_border();
}

template class Simulation<2>;
template class Simulation<3>;

}  // namespace trilith
