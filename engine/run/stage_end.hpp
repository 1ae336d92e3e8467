// How a stage ends where it does not end well: what is told of it.
#pragma once

#include <optional>
#include <string>

#include "run/stage.hpp"
#include "run/watch.hpp"

namespace trilith {

struct Equilibrium;
struct ImplicitStep;

/// An event of the stage as a whole.
template <int D>
Event stage_event(EventType type, const Instant<D>& now, const std::string& text);

/// That the stage goes on by the other integrator, and why.
template <int D>
Event integrator_event(const Instant<D>& now, const std::string& text);

/// How the stage ends: as diverged, or as `end`; and the reason in words where that is not as asked.
template <int D>
void set_end(StageReport& report, const Instant<D>& now, const std::optional<Divergence>& diverged, StageEnd end);

/// For a stage that diverges: what happened, as StageReport::found says it.
template <int D>
Event diverged_event(const Instant<D>& now, const StageReport& report);

/// Where rest was not reached: which body is worst, by how much, and what to try.
template <int D>
std::string unsettled_reason(const Instant<D>& now);
/// Where an implicit step did not converge: where the most is left over, and what to try.
template <int D>
std::string stuck_reason(const Model<D>& model, const State<D>& state, const ImplicitStep& step);
/// Where statics found no rest: what goes off, or where the most is left over, and what to try.
template <int D>
std::string no_rest_reason(const Model<D>& model, const Equilibrium& found);
/// For a stage that is unstable: which body has left its place, farther than `within`, and what to try.
template <int D>
void set_unstable(StageReport& report, const Model<D>& model, const Travel& travel, double within);
/// The same as an event without advice.
template <int D>
Event unstable_event(const Instant<D>& now, const StageReport& report, const Travel& travel);
/// Why rest was not reached, as an event without advice.
template <int D>
Event unsettled_event(const Instant<D>& now);

}  // namespace trilith
