// A process with a clock of its own, such as a season of heating and cooling, as a stage: the structure is in static
// equilibrium after each step of the field.
#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "assembly/field/contact_links.hpp"
#include "assembly/tangent/tangent.hpp"
#include "base/error.hpp"
#include "base/flagged.hpp"
#include "field/field_step.hpp"
#include "model/field/heat.hpp"
#include "model/field/seepage.hpp"
#include "model/postpone.hpp"
#include "run/field/friction_heat.hpp"
#include "run/field/seepage_step.hpp"
#include "run/load_way.hpp"
#include "run/process_time.hpp"
#include "run/simulation.hpp"
#include "run/stage_end.hpp"
#include "run/watch.hpp"
#include "statics/equilibrium.hpp"

namespace trilith {
namespace {

constexpr std::int64_t most_process_steps = 10000000;

/// Number of steps of a process; the last one ends with it.
std::int64_t steps_of(const FieldProcess& process, const std::string& owner) {
  require_positive(process.duration, owner + ": duration", "s");
  require_positive(process.step, owner + ": step", "s");
  const double count = std::ceil(process.duration / process.step - 1e-9);
  if (!(count <= static_cast<double>(most_process_steps)))
    throw InputError(
        fmt::format("{}: step is {:g} s in a duration of {:g} s; that is more than {} steps; give a longer "
                    "step",
                    owner, process.step, process.duration, most_process_steps));
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(count));
}

/// Time of the model after `done` of the steps of a process [s].
double time_after(double begun, std::int64_t done, std::int64_t steps) {
  return begun + path_duration * static_cast<double>(done) / static_cast<double>(steps);
}

/// "12.5 d", "3600 s".
std::string clock_text(double seconds) {
  return seconds >= 86400 ? fmt::format("{:.6g} d", seconds / 86400) : fmt::format("{:.6g} s", seconds);
}

}  // namespace

template <int D>
void postpone_by_process(Model<D>& model, const FieldProcess& process, const StageReport& ended) {
  const std::int64_t steps = steps_of(process, "process");
  double time = ended.begun;
  for (std::int64_t i = 1; i <= ended.steps; ++i) {
    const double next = time_after(ended.begun, i, steps);
    postpone_courses(model, next - std::exchange(time, next));
  }
}
template void postpone_by_process(Model<2>&, const FieldProcess&, const StageReport&);
template void postpone_by_process(Model<3>&, const FieldProcess&, const StageReport&);

/// Changes the values of the fields at this instant, at fixed nodes. Bodies that expand take up elastic energy, which
/// is booked as `heat`. All that depends on positions alone remains valid.
template <int D>
void Simulation<D>::change_fields(const std::function<void(State<D>&)>& change) {
  state_.fields.resize(model_.fields.size());
  const std::shared_ptr<const Field> field = field_of(model_.fields, FieldKind::heat);
  if (!field || !field->expands()) {
    change(state_);
    evaluated_ = false;
    return;
  }
  refresh();
  const double before = work_.element_stored;
  change(state_);
  tangent_->forget();
  evaluated_ = false;
  refresh();
  state_.given[EnergyTerm::heat] += work_.element_stored - before;
  evaluated_ = false;
}

/// Takes a step of the fields, then finds equilibrium; with water in joints between bodies both at once. Without
/// equilibrium the state is as before the step.
template <int D>
Equilibrium Simulation<D>::process_step(const FieldProcess& process, double dt, FieldSolver& solver,
                                        const EquilibriumOptions& how) {
  Equilibrium found;
  found.converged = true, found.end = EquilibriumEnd::rests;
  const std::shared_ptr<const Field> heat = field_of(model_.fields, FieldKind::heat),
                                     water = field_of(model_.fields, FieldKind::seepage);
  if (!work_.valid || process.mechanics) refresh();
  std::optional<State<D>> before;
  if (process.mechanics) before = state_;
  if (heat) {
    const std::vector<FieldLink> links = contact_links(*heat, model_, work_);
    const auto row = static_cast<std::size_t>(row_of(model_.fields, FieldKind::heat));
    change_fields([&](State<D>& state) { solver.advance(heat, links, dt, state.fields[row]); });
  }
  if (water) {
    state_.fields.resize(model_.fields.size());
    found = seepage_step<D>({model_, *water, dt, process.mechanics, how}, solver.flow(), state_);
  } else if (process.mechanics) {
    found = find_equilibrium(model_, state_, how);
  }
  if (!found.converged && before) state_ = std::move(*before);
  if (process.mechanics || water) drop_work();
  return found;
}

/// The model's time increases by path_duration in all, as along a load path; all that depends on it is shifted, and
/// acts as before.
template <int D>
StageReport Simulation<D>::process(const StageOptions& options, const EquilibriumOptions& how,
                                   const RunListener<D>& listener) {
  const FieldProcess& process = *options.process;
  const std::string owner = fmt::format("process '{}'", options.name);
  const std::int64_t steps = steps_of(process, owner);
  if (model_.fields.empty())
    throw InputError(owner +
                     ": no body has thermal properties, and no joint has seepage; declare m:heat or m:seepage "
                     "first");
  StageOptions asked = options;
  asked.must_rest = false;
  begin_stage(asked);
  StageReport& report = stage_->report;
  const Flagged running(running_);
  stop_ = false;
  FieldSolver solver;
  Equilibrium found;
  found.converged = true, found.end = EquilibriumEnd::rests;
  std::optional<Divergence> diverged;
  try {
    refresh();
    tell(stage_event(EventType::stage_begun, instant(), options.name), listener, instant());
    const double begun = state_.time;
    for (std::int64_t i = 1; i <= steps && found.converged && !diverged; ++i) {
      const double from = static_cast<double>(i - 1) * process.step,
                   dt = std::min(process.step, process.duration - from);
      const std::vector<bool> flooded = flooded_joints(model_, state_);
      const double dissipated = state_.given[EnergyTerm::contact_friction];
      found = process_step(process, dt, solver, how);
      if (!found.converged) break;
      add_flow_events(model_, state_, flooded, found.events);
      const double time = time_after(begun, i, steps);
      postpone_courses(model_, time - state_.time);
      kept_model_.reset();
      state_.time = time, state_.last_dt = 0;
      evaluated_ = false;
      if (process.mechanics) {
        refresh();
        if (const Field* const heated = friction_heated(model_)) {
          const double energy = state_.given[EnergyTerm::contact_friction] - dissipated;
          const auto friction = friction_deposits(*heated, model_, state_, work_, energy);
          if (!friction.empty()) change_fields([&](State<D>& state) { add_deposits(model_, friction, state.fields); });
          refresh();
        }
        watch_->reset();
        diverged = watch_->look_at_strains(instant(), "after " + clock_text(state_.fields.front().clock));
      } else if (!work_.valid) {
        refresh();  // a step of water discards Work, and recorders read joints from it
      }
      ++report.steps;
      tell_process_step(found, listener, i == steps);
      if (process.mechanics && !diverged && cracks_now(listener))
        diverged = find_rest(how, listener, "after " + clock_text(state_.fields.front().clock), found);
      if (stop_.load(std::memory_order_relaxed)) break;
    }
    const Instant<D> now = instant();
    end_process(found, how, diverged);
    tell_end(listener, now);
    if (listener.change_model && listener.change_model(model_)) unscale_masses(), edited();
  } catch (...) {
    stage_.reset();
    throw;
  }
  const StageReport out = std::move(report);
  stage_.reset();
  return out;
}

/// Reports events, histories after each step, and frames at their interval.
template <int D>
void Simulation<D>::tell_process_step(const Equilibrium& found, const RunListener<D>& listener, bool last) {
  const Instant<D> now = instant();
  StageProgress& stage = *stage_;
  for (Event e : found.events) {
    e.time = state_.time;
    tell(std::move(e), listener, now);
  }
  if (stage.options.frame_interval > 0 && listener.on_frame && (last || stage.frames.due(state_.time, 0)))
    listener.on_frame(now);
  if (stage.options.history_interval > 0 && listener.on_history) listener.on_history(now);
  if (stage.options.energy_interval > 0 && listener.on_energy && (last || stage.energies.due(state_.time, 0)))
    listener.on_energy(now, energy());
  if (listener.on_step) listener.on_step(now);
}

/// Sets the end of the stage and its reason.
template <int D>
void Simulation<D>::end_process(const Equilibrium& found, const EquilibriumOptions& how,
                                const std::optional<Divergence>& diverged) {
  StageReport& report = stage_->report;
  refresh();
  const Instant<D> now = instant();
  const bool stopped = stop_.load(std::memory_order_relaxed) || found.end == EquilibriumEnd::stopped;
  const StageEnd end = stopped                                 ? StageEnd::stopped
                       : found.end == EquilibriumEnd::unstable ? StageEnd::unstable
                       : found.converged                       ? StageEnd::rest
                                                               : StageEnd::not_at_rest;
  if (diverged && diverged->event) report.found = diverged->found;
  report.speed = now.speed, report.ratio = found.left;
  set_end(report, now, diverged, end);
  const std::string when = "after " + clock_text(state_.fields.empty() ? 0 : state_.fields.front().clock) + ": ";
  if (report.end == StageEnd::not_at_rest) report.reason = when + no_rest_reason(model_, found);
  if (report.end == StageEnd::unstable) {
    set_unstable(report, model_, found.travel, how.within);
    report.reason = when + report.reason;
  }
}

#define TRILITH_PROCESS(D)                                                           \
  template void Simulation<D>::change_fields(const std::function<void(State<D>&)>&); \
  template StageReport Simulation<D>::process(const StageOptions&, const EquilibriumOptions&, const RunListener<D>&);
TRILITH_PROCESS(2)
TRILITH_PROCESS(3)
#undef TRILITH_PROCESS

}  // namespace trilith
