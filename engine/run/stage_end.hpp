// Messages of a stage that does not end as requested.
#pragma once

#include <optional>
#include <string>

#include "run/stage.hpp"
#include "run/watch.hpp"

namespace trilith {

struct Equilibrium;

/// Event of the stage as a whole.
template <int D>
Event stage_event(EventType type, const Instant<D>& now, const std::string& text);

/// Event of a change to the other integrator, with the reason.
template <int D>
Event integrator_event(const Instant<D>& now, const std::string& text);

/// Sets the end of the stage: diverged, or `end`; with the reason in words if it is not the requested one.
template <int D>
void set_end(StageReport& report, const Instant<D>& now, const std::optional<Divergence>& diverged, StageEnd end);

/// Event of a stage that diverges, with the text of StageReport::found.
template <int D>
Event diverged_event(const Instant<D>& now, const StageReport& report);

/// Reason without rest: the worst body, its unbalanced force, and advice.
template <int D>
std::string unsettled_reason(const Instant<D>& now);
/// Reason of a static stage without rest: the part that moves away, or the largest residual, and advice.
template <int D>
std::string no_rest_reason(const Model<D>& model, const Equilibrium& found);
/// Marks an unstable stage: the body that has left its place by more than `within`, and advice.
template <int D>
void set_unstable(StageReport& report, const Model<D>& model, const Travel& travel, double within);
/// Event of an unstable stage, without advice.
template <int D>
Event unstable_event(const Instant<D>& now, const StageReport& report, const Travel& travel);
/// Event of a stage without rest, without advice.
template <int D>
Event unsettled_event(const Instant<D>& now);

}  // namespace trilith
