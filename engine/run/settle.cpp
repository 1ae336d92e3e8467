// Rest found by statics, as a stage of a run.
#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"
#include "base/flagged.hpp"
#include "run/simulation.hpp"
#include "run/stage_end.hpp"
#include "run/watch.hpp"
#include "step/equilibrium.hpp"

namespace trilith {

/// All of it lies between two looks at the same instant: what led to rest is told at the second one.
template <>
StageReport Simulation<2>::settle(const StageOptions& options, const EquilibriumOptions& how,
                                  const RunListener<2>& listener) {
  begin_stage(options);
  StageReport& report = stage_->report;
  const Flagged running(running_);
  try {
    refresh();
    tell(stage_event(EventType::stage_begun, instant(), options.name), listener, instant());
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
                                  const RunListener<3>& /*listener*/) {
  throw InputError(fmt::format("stage '{}': models in space are not settled by statics yet; let it consolidate in time",
                               options.name));
}

}  // namespace trilith
