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
template <int D>
void Simulation<D>::tell_way(const LoadWay<D>& way, const RunListener<D>& listener) {
  const State<D> end = state_;
  const std::vector<PointLoad<D>> loads = model_.point_loads;
  const StageOptions& options = stage_->options;
  for (const Waypoint<D>& point : way.points) {
    auto unit = way.loads.begin();
    for (PointLoad<D>& load : model_.point_loads)
      if (unit != way.loads.end() && load.name == unit->name) load.force = point.factor * (unit++)->force;
    state_ = point.state;
    drop_work();
    refresh();
    const Instant<D> now = instant();
    if (options.frame_interval > 0 && listener.on_frame) listener.on_frame(now);
    if (options.history_interval > 0 && listener.on_history) listener.on_history(now);
  }
  model_.point_loads = loads;
  state_ = end;
  drop_work();
  refresh();
}

/// All of it lies between two looks at the same instant: what led to rest is told at the second one.
template <int D>
StageReport Simulation<D>::settle(const StageOptions& options, const EquilibriumOptions& how,
                                  const RunListener<D>& listener, const LoadWay<D>* way) {
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
    const Instant<D> now = instant();
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

template StageReport Simulation<2>::settle(const StageOptions&, const EquilibriumOptions&, const RunListener<2>&,
                                           const LoadWay<2>*);
template StageReport Simulation<3>::settle(const StageOptions&, const EquilibriumOptions&, const RunListener<3>&,
                                           const LoadWay<3>*);

}  // namespace trilith
