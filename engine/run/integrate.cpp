// Choice of the integrator for the next step of a stage, its step length, and the step itself.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "assembly/evaluate.hpp"
#include "assembly/field/joint_water.hpp"
#include "base/error.hpp"
#include "events/commit.hpp"
#include "integrate/explicit/central_difference.hpp"
#include "integrate/explicit/followed_step.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "integrate/implicit/implicit_step.hpp"
#include "run/field/friction_heat.hpp"
#include "run/field/water_step.hpp"
#include "run/simulation.hpp"
#include "run/stage_end.hpp"

namespace trilith {
namespace {

/// Number of steps between two estimates of the explicit step.
constexpr std::int64_t steps_between_estimates = 32;
/// Energy errors shorten no step below this share of the longest step.
constexpr double shortest_for_energy = 1.0 / 16384;
/// Cost of an implicit step in explicit steps. Implicit steps are used only if they are longer by at least this factor.
constexpr double least_gain = 20;
/// After a change to explicit steps, implicit ones are tried again after this number of longest steps.
constexpr double tries_after = 40;

/// Longest step of a scheme that controls its error.
double longest_controlled_step(const StageOptions& o) {
  return o.dt > 0 ? o.dt : usual_longest_step;
}

/// True if the longest stable step permits the target step of mass scaling.
bool is_as_asked(double longest, const StageOptions& options) {
  return options.mass_scaling && options.safety * longest >= (1 - 1e-9) * options.mass_scaling->step;
}

/// True if a multiple of `interval` lies within the last step.
bool passes_multiple(double time, double last_dt, double interval) {
  return std::floor(time / interval) != std::floor((time - last_dt) / interval);
}

}  // namespace

/// Velocities at the start of a stage. A stage that leaves the integrator open continues with the scheme of the state,
/// and starts implicitly at the very start.
template <int D>
VelocityTimes Simulation<D>::wanted_velocities() const {
  const StageOptions& o = stage_->options;
  const bool own = !o.may_change || state_.implicit() || (state_.last_dt == 0 && model_.pushes.empty());
  return own ? velocities_of(o.integrator) : CentralDifference::velocities;
}

/// The scheme of the next step.
template <int D>
const AnyIntegrator& Simulation<D>::integrator() const {
  static const AnyIntegrator otherwise = CentralDifference{};
  const StageOptions& o = stage_->options;
  return !o.may_change || velocity_times(state_) == velocities_of(o.integrator) ? o.integrator : otherwise;
}

/// The step found last, unless the stage requests another one or the next estimate is due.
template <int D>
NextStep Simulation<D>::choose_step() const {
  if (!stage_) return {state_.dt, state_.safety, 0};
  const StageOptions& options = stage_->options;
  if (bound_of(integrator()) == StepBound::accuracy) {
    const double longest = longest_controlled_step(options);
    const double stable =
        options.may_change ? step_with_water(model_, state_, stable_step(model_, state_, work_).dt) : 0;
    return {state_.dt > 0 ? std::min(state_.dt, longest) : longest, 0, stable};
  }
  // A stage with another step option takes effect at once.
  const double given = given_step(options), safety = given > 0 ? 0 : options.safety;
  const bool other = state_.safety != safety || (given > 0 && state_.dt != given);
  if (!other && state_.dt != 0 && state_.step % steps_between_estimates != 0) return {state_.dt, state_.safety, 0};
  const double longest = step_with_water(model_, state_, stable_step(model_, state_, work_).dt);
  // With mass scaling the step is the requested one while all bodies have sufficient added mass for it.
  const double turning = std::min(longest, turning_step(model_, state_));
  const double own = settled_step(turning, options.safety);
  const double usual = followed_step(model_, state_, own, (steps_between_estimates + 1) * own);
  const double dt = is_as_asked(longest, options) ? options.mass_scaling->step : usual;
  return {given > 0 ? given : dt, safety, longest};
}

/// With mass scaling, increases the shares of bodies to the requested step whenever the estimate is due. A restarted
/// run does so at the same steps.
template <int D>
void Simulation<D>::scale_masses() {
  if (!stage_->options.mass_scaling) return;
  if (!model_.pushes.empty())
    throw InputError(fmt::format("stage '{}': push '{}' controls a displacement, which excludes mass_scaling; keep one",
                                 stage_->options.name, model_.pushes.front().name));
  if (!model_.fields.empty() && flows_in_motion(model_, true) && has_joint_water(model_))
    throw InputError(fmt::format(
        "stage '{}': water flows in joints between bodies, which excludes mass_scaling: the added mass would "
        "not follow the stiffness of the water; leave mass_scaling out, or: m:seepage_motion {{ flows = "
        "false }}",
        stage_->options.name));
  refresh();
  const bool due = state_.added_share.empty() || state_.dt == 0 || state_.step % steps_between_estimates == 0;
  if (!due) return;
  if (!stage_->report.scaled) stage_->report.scaled.emplace();
  // The shares are sufficient if the longest stable step permits the requested one.
  if (!state_.added_share.empty() && state_.dt != 0 && is_as_asked(next_.longest, stage_->options))
    return measure_scaled(model_, state_, *stage_->report.scaled);
  const bool changed = trilith::scale_masses(model_, state_, work_, *stage_->options.mass_scaling,
                                             stage_->options.safety, stage_->first, *stage_->report.scaled);
  if (!changed) return;
  state_.dt = 0;
  evaluated_ = false;
}

/// Removes all added mass.
template <int D>
void Simulation<D>::unscale_masses() {
  if (state_.added_share.empty()) return;
  trilith::unscale_masses(model_, state_);
  state_.dt = 0;
  evaluated_ = false;
}

/// Chooses between explicit and implicit steps in a stage that leaves it open. The choice depends on the state alone,
/// so that a restarted run makes the same choice.
template <int D>
void Simulation<D>::choose_integrator() {
  const StageOptions& options = stage_->options;
  const double longest = longest_controlled_step(options);
  refresh();
  if (state_.implicit()) {
    if (next_.dt >= least_gain * options.safety * next_.longest) return;
    changed_ =
        fmt::format("continues with explicit steps, because implicit steps became as short as {:.2g} s", next_.dt);
    change_velocities(VelocityTimes::staggered);
  } else if (model_.pushes.empty() && longest >= least_gain * next_.dt &&
             passes_multiple(state_.time, state_.last_dt, tries_after * longest)) {
    changed_ = "tries implicit steps again";
    change_velocities(velocities_of(options.integrator));
  }
}

/// Commits the last step under the scheme that took it, then prepares the state for the other scheme.
template <int D>
void Simulation<D>::change_velocities(VelocityTimes to) {
  const bool collocated = to == VelocityTimes::collocated;
  if (collocated && !model_.pushes.empty())
    throw InputError(
        fmt::format("stage '{}': push '{}' controls a displacement, which needs explicit steps; release it, or use "
                    "integrator = \"explicit\"",
                    stage_->options.name, model_.pushes.front().name));
  refresh();
  const std::vector<HeatDeposit> friction = friction_of_step(model_, state_, work_);
  commit(model_, state_, work_, times_);
  leaving_.insert(leaving_.end(), work_.events.begin(), work_.events.end());
  if (collocated)
    begin_implicit(model_, state_, work_);
  else
    begin_explicit(model_, state_, work_);
  state_.dt = state_.safety = 0;
  evaluated_ = false;
  if (!friction.empty()) change_fields([&](State<D>& state) { add_deposits(model_, friction, state.fields); });
}

/// Prepares for central differences after a step failed at a committed instant. The state is unchanged, with no step
/// outstanding since the commit.
template <int D>
void Simulation<D>::leave_failed_step() {
  std::vector<Vec<D>> position = std::exchange(state_.position_before, state_.position);
  std::vector<Rotation<D>> rotation = std::exchange(state_.rotation_before, state_.rotation);
  evaluate(model_, state_, work_, state_.last_dt, times_);
  state_.position_before.swap(position), state_.rotation_before.swap(rotation);  // the ledger needs the last step
  begin_explicit(model_, state_, work_);
  state_.dt = state_.safety = 0;
  evaluated_ = false;
  refresh();
  state_.dt = next_.dt, state_.safety = next_.safety;
}

/// Steps from a committed instant to the next one. False if no step was found, or if it was stopped.
template <int D>
bool Simulation<D>::take_step(double dt, const Energy& energy, const RunListener<D>& listener) {
  const StageOptions& options = stage_->options;
  const StepControl control{options.tolerance, options.accuracy, shortest_for_energy * longest_controlled_step(options),
                            options.may_change ? least_gain * options.safety * next_.longest : 0, &listener.is_stopped};
  const StepInput<D> input{model_, state_, work_, *tangent_, energy, dt, rest_, control, times_};
  const StepResult step = std::visit([&](const auto& scheme) { return scheme.step(input); }, integrator());
  stage_->report.shortest_dt = std::min(stage_->report.shortest_dt, step.dt);
  if (step.done) return true;
  if (!options.may_change || step.reason.empty()) {
    stuck_ = step.reason;
    return false;
  }
  changed_ = fmt::format("continues with explicit steps, because no implicit step of {:.2g} s or more converges",
                         std::min(dt, control.give_up));
  leave_failed_step();
  advance(model_, state_, work_, {swept_.dt, rest_}, times_);
  evaluated_ = false;  // Work was evaluated at a trial state
  return true;
}

template void Simulation<2>::scale_masses();
template void Simulation<2>::unscale_masses();
template void Simulation<3>::scale_masses();
template void Simulation<3>::unscale_masses();
template VelocityTimes Simulation<2>::wanted_velocities() const;
template const AnyIntegrator& Simulation<2>::integrator() const;
template NextStep Simulation<2>::choose_step() const;
template void Simulation<2>::choose_integrator();
template void Simulation<2>::change_velocities(VelocityTimes);
template bool Simulation<2>::take_step(double, const Energy&, const RunListener<2>&);
template VelocityTimes Simulation<3>::wanted_velocities() const;
template const AnyIntegrator& Simulation<3>::integrator() const;
template NextStep Simulation<3>::choose_step() const;
template void Simulation<3>::choose_integrator();
template void Simulation<3>::change_velocities(VelocityTimes);
template bool Simulation<3>::take_step(double, const Energy&, const RunListener<3>&);
template void Simulation<2>::leave_failed_step();
template void Simulation<3>::leave_failed_step();

}  // namespace trilith
