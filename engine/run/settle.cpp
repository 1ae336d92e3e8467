// Rest found by statics, as a stage of a run.
#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/flagged.hpp"
#include "run/load_way.hpp"
#include "run/simulation.hpp"
#include "run/stage_end.hpp"
#include "run/watch.hpp"
#include "step/equilibrium.hpp"

namespace trilith {
namespace {

/// Under which loads a stage without time has come to its end.
template <int D>
std::string loads_text(const LoadWay<D>* way) {
  if (way == nullptr || way->points.empty() || way->loads.empty()) return "under all loads (load factor 1)";
  return fmt::format("as the load factor of '{}' came to {:.4g}", way->loads.front().name, way->points.back().factor);
}

StageEnd rest_end(const Equilibrium& found) {
  if (found.end == EquilibriumEnd::stopped) return StageEnd::stopped;
  return found.converged ? StageEnd::rest : StageEnd::not_at_rest;
}

}  // namespace

/// The state is another one meanwhile, and so are the loads that the path has scaled. What is strained beyond its limit
/// is not told, as in a stage that diverges.
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
    if (is_overstrained(model_, state_)) break;
    if (options.frame_interval > 0 && listener.on_frame) listener.on_frame(now);
    if (options.history_interval > 0 && listener.on_history) listener.on_history(now);
  }
  model_.point_loads = loads;
  state_ = end;
  drop_work();
  refresh();
}

/// All of it lies between two looks at the same instant: what led to rest is told at the second one. What is strained
/// beyond its limit as it begins, as at the end of a way, is not settled.
template <int D>
StageReport Simulation<D>::settle(const StageOptions& options, const EquilibriumOptions& how,
                                  const RunListener<D>& listener, const LoadWay<D>* way) {
  StageOptions asked = options;
  asked.must_rest = false;  // what finds no rest leaves the state as it was, and spoils nothing
  begin_stage(asked);
  StageReport& report = stage_->report;
  const Flagged running(running_);
  try {
    refresh();
    tell(stage_event(EventType::stage_begun, instant(), options.name), listener, instant());
    if (way != nullptr) tell_way(*way, listener);
    std::optional<Divergence> diverged =
        watch_->look_at_strains(instant(), way != nullptr ? loads_text(way) : "as the stage began");
    Equilibrium found;
    if (!diverged) {
      found = find_equilibrium(model_, state_, how);
      watch_->reset();
      drop_work();
      refresh();
      diverged = watch_->look_at_strains(instant(), loads_text(way));
    }
    const Instant<D> now = instant();
    for (const Event& e : found.events) tell(e, listener, now);
    if (listener.on_step) listener.on_step(now);
    if (diverged && diverged->event) tell(*diverged->event, listener, now);
    report.steps = found.steps;
    report.speed = now.speed, report.ratio = found.left;
    set_end(report, now, diverged, rest_end(found));
    if (report.end == StageEnd::not_at_rest) report.reason = no_rest_reason(model_, found);
    if (!diverged) tell_samples(listener, now, true);
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
