// Rest found by statics, as a stage of a run.
#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"
#include "base/flagged.hpp"
#include "run/load_way.hpp"
#include "run/simulation.hpp"
#include "run/stage_end.hpp"
#include "run/watch.hpp"
#include "step/equilibrium.hpp"

namespace trilith {

/// The state is another one meanwhile, and so are the loads that the path has scaled.
template <>
void Simulation<2>::tell_way(const LoadWay& way, const RunListener<2>& listener) {
  const State<2> end = state_;
  const std::vector<PointLoad<2>> loads = model_.point_loads;
  const StageOptions& options = stage_->options;
  for (const Waypoint& point : way.points) {
    auto unit = way.loads.begin();
    for (PointLoad<2>& load : model_.point_loads)
      if (unit != way.loads.end() && load.name == unit->name) load.force = point.factor * (unit++)->force;
    state_ = point.state;
    drop_work();
    refresh();
    const Instant<2> now = instant();
    if (options.frame_interval > 0 && listener.on_frame) listener.on_frame(now);
    if (options.history_interval > 0 && listener.on_history) listener.on_history(now);
  }
  model_.point_loads = loads;
  state_ = end;
  drop_work();
  refresh();
}

/// All of it lies between two looks at the same instant: what led to rest is told at the second one.
template <>
StageReport Simulation<2>::settle(const StageOptions& options, const EquilibriumOptions& how,
                                  const RunListener<2>& listener, const LoadWay* way) {
  begin_stage(options);
  StageReport& report = stage_->report;
  const Flagged running(running_);
  try {
    refresh();
    tell(stage_event(EventType::stage_begun, instant(), options.name), listener, instant());
    if (way != nullptr) tell_way(*way, listener);
    const Equilibrium found = find_equilibrium(model_, state_, how);
    watch_->reset();
    drop_work();
    refresh();
    const Instant<2> now = instant();
    for (const Event& e : found.events) tell(e, listener, now);
    if (listener.on_step) listener.on_step(now);
    report.steps = found.steps, report.ended = state_.time;
    report.speed = now.speed, report.ratio = found.left;
    report.end = found.converged ? StageEnd::rest : StageEnd::not_at_rest;
    if (!found.converged) report.reason = no_rest_reason(model_, found);
    tell_samples(listener, now, true);
    tell_end(listener, now);
  } catch (...) {
    stage_.reset();
    throw;
  }
  const StageReport out = std::move(report);
  stage_.reset();
  return out;
}

template <>
StageReport Simulation<3>::settle(const StageOptions& options, const EquilibriumOptions& /*how*/,
                                  const RunListener<3>& /*listener*/, const LoadWay* /*way*/) {
  throw InputError(fmt::format("stage '{}': models in space are not settled by statics yet; let it consolidate in time",
                               options.name));
}

}  // namespace trilith
