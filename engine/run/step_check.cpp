#include "run/step_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/quantity_text.hpp"

namespace trilith {
namespace {

/// Length of the window where none is given [s].
constexpr double usual_window = 1;

/// True if a motion moves a support after this time [s].
template <int D>
bool shakes(const Model<D>& model, double time) {
  return std::any_of(model.drives.begin(), model.drives.end(),
                     [&](const Drive& drive) { return drive.start + drive.motion->end_time() > time; });
}

/// Largest distance of any node between two states [m].
template <int D>
double farthest_apart(const State<D>& a, const State<D>& b) {
  double most = 0;
  for (std::size_t n = 0; n < std::min(a.position.size(), b.position.size()); ++n)
    most = std::max(most, (a.position[n] - b.position[n]).norm());
  return most;
}

/// The same stage with half the step, to the given time.
template <int D>
void halve_step(Snapshot<D>& at, double until, double mean_step) {
  StageProgress& stage = *at.stage;
  StageOptions& options = stage.options;
  options.until_rest = options.must_rest = false;
  options.frame_interval = options.history_interval = options.energy_interval = 0;
  stage.frames.interval = stage.histories.interval = stage.energies.interval = 0;
  stage.end = until;
  if (bound_of(options.integrator) == StepBound::accuracy)
    options.dt = 0.5 * mean_step;
  else if (options.dt > 0)
    options.dt *= 0.5;
  else
    options.safety *= 0.5;
}

}  // namespace

template <int D>
StepCheck<D>::StepCheck(const StepWindow& asked, const StageOptions& options, const Simulation<D>& at)
    : from_(unbounded), to_(unbounded) {
  const double begun = at.state().time, end = options.end_time > begun ? options.end_time : begun + options.duration;
  if (asked.given()) {
    if (asked.from >= begun && asked.from < end) from_ = asked.from, to_ = std::min(asked.to, end);
  } else if (shakes(at.model(), begun)) {
    from_ = std::max(begun, end - usual_window), to_ = end;
  }
}

template <int D>
void StepCheck<D>::look(Simulation<D>& now) {
  const double time = now.state().time;
  if (!begin_ && now.stage() != nullptr && time >= from_ - 1e-9) begin_ = now.snapshot();
  if (begin_ && !end_ && time >= to_ - 1e-9) end_ = now.state();
}

template <int D>
std::optional<SealRow> StepCheck<D>::repeat(Simulation<D>& ended) {
  if (!begin_ || !begin_->stage) return std::nullopt;
  const State<D>& last = end_ ? *end_ : ended.state();
  const double from = begin_->state.time, until = last.time;
  if (!(until > from)) return std::nullopt;
  const std::int64_t steps = std::max<std::int64_t>(1, last.step - begin_->state.step);
  halve_step(*begin_, until, (until - from) / static_cast<double>(steps));
  Simulation<D> again(*begin_->model, begin_->state);
  again.restore(*begin_);
  const StageReport report = again.resume();
  const double moved = farthest_apart(begin_->state, last), off = farthest_apart(again.state(), last);
  const double share = moved > 0 ? off / moved : 0;
  const bool same = report.end == StageEnd::time && share <= step_check_limit;
  return SealRow{"half the step",
                 same ? "passed" : "failed",
                 share,
                 step_check_limit,
                 "1",
                 fmt::format("of the motion of {} from {:.4g} to {:.4g} s: {} apart", quantity_text(moved, "m"), from,
                             until, quantity_text(off, "m")),
                 from};
}

template class StepCheck<2>;
template class StepCheck<3>;

}  // namespace trilith
