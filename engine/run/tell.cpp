// Notification of the listeners of a run at an instant: events, samples, the end of a stage.
#include <fmt/format.h>

#include <utility>

#include "assembly/step_times.hpp"
#include "model/event/event_text.hpp"
#include "run/simulation.hpp"
#include "run/stage_end.hpp"
#include "run/watch.hpp"

namespace trilith {
namespace {

/// In shorter stages the kinetic energy within a leapfrog step is not a measure of the energy error.
constexpr std::int64_t least_sealed_steps = 20;

}  // namespace

template <int D>
Instant<D> Simulation<D>::instant() const {
  const double ratio = work_.carried > 0 ? work_.unbalanced / work_.carried : 0;
  return {model_, state_, work_, stage_->options, stage_->report.begun, swept_.dt, work_.fastest_moving, ratio};
}

/// All events of a run pass through this function.
template <int D>
void Simulation<D>::tell(Event event, const RunListener<D>& listener, const Instant<D>& now) {
  causes_.name(event);
  if (Verdict::counts(event.type)) verdict_.add(event.type, event.time, event.value, event_text(event, model_));
  if (listener.on_event) listener.on_event(event, now);
}

/// Reports the end of the stage, after the reason for which its result is not reliable, if any.
template <int D>
void Simulation<D>::tell_end(const RunListener<D>& listener, const Instant<D>& now) {
  StageReport& report = stage_->report;
  report.threads = threads_.chosen(), report.thread_gain = threads_.gain();
  if (report.end == StageEnd::diverged) tell(diverged_event(now, report), listener, now);
  if (report.end == StageEnd::not_at_rest && now.stage.must_rest) tell(unsettled_event(now), listener, now);
  if (report.end == StageEnd::unstable && now.stage.must_rest)
    tell(unstable_event(now, report, watch_->displaced()), listener, now);
  if (report.end != StageEnd::diverged) end_seal(now);
  tell(stage_event(EventType::stage_ended, now, fmt::format("{}: {}", now.stage.name, name_of(report.end))), listener,
       now);
}

template <int D>
void Simulation<D>::end_seal(const Instant<D>& now) {
  seal_.sample(now, energy(), stage_->report.steps >= least_sealed_steps);
  const bool sought = seeks_rest(now.stage);
  const Travel farthest = sought ? watch_->farthest(now) : Travel{};
  const std::string body = farthest.body < 0 ? "" : model_.bodies[static_cast<std::size_t>(farthest.body)].name;
  seal_.end_stage(stage_->report, sought, farthest, body, verdict_);
}

template <int D>
void Simulation<D>::tell_samples(const RunListener<D>& listener, const Instant<D>& now, bool ends) {
  StageProgress& stage = *stage_;
  const StageOptions& options = stage.options;
  if ((stage.frames.due(state_.time, now.dt) || (ends && options.frame_interval > 0)) && listener.on_frame)
    listener.on_frame(now);
  if ((stage.histories.due(state_.time, now.dt) || (ends && options.history_interval > 0)) && listener.on_history)
    listener.on_history(now);
  if ((stage.energies.due(state_.time, now.dt) || (ends && options.energy_interval > 0)) && listener.on_energy)
    listener.on_energy(now, energy());
  if (ends) return;  // end_seal() follows
  if (Seal::due(state_.step, state_.implicit()))
    seal_.sample(now, energy(), false);
  else if (state_.step % depth_interval == 0)
    seal_.sample_depth(model_, work_);
}

/// Reports the events of a step, with the new state evaluated. All data that handlers read refer to the instant of the
/// state. Their changes take effect from the next step on, which is then estimated again.
template <int D>
void Simulation<D>::tell_step(const RunListener<D>& listener) {
  StepClock clock(times_);
  const Instant<D> now = instant();
  for (const Event& e : work_.events) tell(e, listener, now);
  if (listener.on_step) listener.on_step(now);
  if (listener.change_model && listener.change_model(model_)) unscale_masses(), edited();
  clock.mark(StepPart::listen);
}

template Instant<2> Simulation<2>::instant() const;
template void Simulation<2>::tell(Event, const RunListener<2>&, const Instant<2>&);
template void Simulation<2>::tell_end(const RunListener<2>&, const Instant<2>&);
template void Simulation<2>::end_seal(const Instant<2>&);
template void Simulation<3>::end_seal(const Instant<3>&);
template void Simulation<2>::tell_samples(const RunListener<2>&, const Instant<2>&, bool);
template void Simulation<2>::tell_step(const RunListener<2>&);
template Instant<3> Simulation<3>::instant() const;
template void Simulation<3>::tell(Event, const RunListener<3>&, const Instant<3>&);
template void Simulation<3>::tell_end(const RunListener<3>&, const Instant<3>&);
template void Simulation<3>::tell_samples(const RunListener<3>&, const Instant<3>&, bool);
template void Simulation<3>::tell_step(const RunListener<3>&);

}  // namespace trilith
