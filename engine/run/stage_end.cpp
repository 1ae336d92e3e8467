#include "run/stage_end.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "integrate/implicit/implicit_step.hpp"
#include "model/pose.hpp"
#include "run/record/body_forces.hpp"
#include "statics/equilibrium.hpp"

namespace trilith {
namespace {

/// "pier is worst, with 3.1e-03 of the largest force unbalanced (1e-05 is required)"
template <int D>
std::string unbalanced_text(const Instant<D>& now, const WorstBodies& worst) {
  return fmt::format("{} is worst, with an out-of-balance ratio of {:.2g} ({:g} is required)",
                     now.model.bodies[worst.unbalanced].name, now.ratio, now.stage.still_ratio);
}

template <int D>
std::string moving_text(const Instant<D>& now, const WorstBodies& worst) {
  return fmt::format("{} is fastest, at {:.2g} m/s ({:g} m/s is required)", now.model.bodies[worst.fastest].name,
                     worst.speed, now.stage.still_speed);
}

template <int D>
std::string unsettled_text(const Instant<D>& now, const WorstBodies& worst) {
  const bool pulled = now.ratio > now.stage.still_ratio && worst.unbalanced >= 0;
  const bool moves = worst.speed > now.stage.still_speed && worst.fastest >= 0;
  if (pulled && moves) return unbalanced_text(now, worst) + "; " + moving_text(now, worst);
  if (pulled) return unbalanced_text(now, worst);
  if (moves) return moving_text(now, worst);
  return fmt::format("at rest for less than the required {:g} s", now.stage.still_hold);
}

}  // namespace

/// Events of a stage have no bodies and no place; the text contains the message.
template <int D>
Event stage_event(EventType type, const Instant<D>& now, const std::string& text) {
  Event e;
  e.type = type;
  e.time = now.state.time;
  e.step = now.state.step;
  e.text = text;
  return e;
}

template <int D>
Event integrator_event(const Instant<D>& now, const std::string& text) {
  Event e = stage_event(EventType::integrator_changed, now, text);
  e.value = now.dt;
  return e;
}

/// Divergence takes precedence over all other ends: the finding, its time, and advice.
template <int D>
void set_end(StageReport& report, const Instant<D>& now, const std::optional<Divergence>& diverged, StageEnd end) {
  report.end = diverged ? StageEnd::diverged : end;
  report.ended = now.state.time;
  if (diverged) {
    report.found = diverged->found;
    report.sound_until = diverged->sound_until;
    report.reason = diverged->found + "; " + diverged->advice;
  } else if (end == StageEnd::not_at_rest) {
    report.reason = unsettled_reason(now);
  } else if (end == StageEnd::all_left) {
    report.reason =
        "all bodies that were free to move have left the bounds or were removed; to follow them farther, give wider "
        "bounds";
  }
}

/// "unstable: top moved by 0.21 m and rotated by 0.6 rad, 0.4 of its size; ..."
template <int D>
void set_unstable(StageReport& report, const Model<D>& model, const Travel& travel, double within) {
  report.found = fmt::format("unstable: {} {}", model.bodies[travel.body].name, travel_text(travel));
  const double needed = std::max({1.1 * travel.share, 1.1 * travel.fallen, 2 * within});
  report.reason = fmt::format(
      "{}, but equilibrium is sought within {:g} of a body's size from its start. Support it, or change the geometry, "
      "friction or bonds there; within = {:.2g} allows larger motions",
      report.found, within, needed);
}

template <int D>
Event unstable_event(const Instant<D>& now, const StageReport& report, const Travel& travel) {
  Event e = stage_event(EventType::stage_unsettled, now, report.found);
  e.body_a = travel.body;
  e.value = now.ratio;
  return e;
}

template <int D>
Event diverged_event(const Instant<D>& now, const StageReport& report) {
  Event e = stage_event(EventType::stage_diverged, now, report.found);
  e.value = report.sound_until;
  return e;
}

template <int D>
std::string unsettled_reason(const Instant<D>& now) {
  const std::string what = unsettled_text(now, worst_bodies(now.model, now.work));
  return what +
         "; give a longer duration. If it vibrates, it lacks damping: give a contact `beta` or a bearing `damping`. If "
         "it "
         "moves farther away, it may be unstable";
}

/// Reason for which no step was found at any length: time, progress, and the body with the largest residual, or the two
/// bodies that would pass through each other.
/// A static residual below this share of the largest force may count as rest.
constexpr double little_left = 1e-4;

/// Either a part is not supported at all, which no number of iterations changes, or the last forces do not vanish.
template <int D>
std::string no_rest_reason(const Model<D>& model, const Equilibrium& found) {
  const std::string where = found.worst < 0 ? "nothing" : model.bodies[body_of_node(model, found.worst)].name;
  if (found.end == EquilibriumEnd::goes_off)
    return fmt::format(
        "{} has no support, or yields or bends so far that it moves farther than its own size. Support it, apply the "
        "loads in more shares, or let it move: integrator = \"explicit\"",
        where);
  const std::string left = fmt::format("the residual is {:.2g} of the largest force after {} steps, most of it on {}",
                                       found.left, found.steps, where);
  if (found.left < little_left)
    return fmt::format("{}; tolerance = {:.0e} accepts that as rest, integrator = \"explicit\" shows how it moves",
                       left, 2 * found.left);
  // A part that slides or falls does so under each share of the weight too.
  const std::string slower =
      found.end == EquilibriumEnd::stuck ? ", shares = 10 applies the weight in smaller increments" : "";
  return fmt::format("{}; integrator = \"explicit\" shows how it moves{}", left, slower);
}

template <int D>
Event unsettled_event(const Instant<D>& now) {
  const WorstBodies worst = worst_bodies(now.model, now.work);
  Event e = stage_event(EventType::stage_unsettled, now, unsettled_text(now, worst));
  e.body_a = now.ratio > now.stage.still_ratio ? worst.unbalanced : worst.fastest;
  e.value = now.ratio;
  return e;
}

template std::string no_rest_reason(const Model<2>&, const Equilibrium&);
template std::string no_rest_reason(const Model<3>&, const Equilibrium&);
template void set_unstable(StageReport&, const Model<2>&, const Travel&, double);
template void set_unstable(StageReport&, const Model<3>&, const Travel&, double);
template Event unstable_event(const Instant<2>&, const StageReport&, const Travel&);
template Event unstable_event(const Instant<3>&, const StageReport&, const Travel&);
template Event stage_event(EventType, const Instant<2>&, const std::string&);
template Event integrator_event(const Instant<2>&, const std::string&);
template void set_end(StageReport&, const Instant<2>&, const std::optional<Divergence>&, StageEnd);
template Event diverged_event(const Instant<2>&, const StageReport&);
template std::string unsettled_reason(const Instant<2>&);
template Event unsettled_event(const Instant<2>&);
template Event stage_event(EventType, const Instant<3>&, const std::string&);
template Event integrator_event(const Instant<3>&, const std::string&);
template void set_end(StageReport&, const Instant<3>&, const std::optional<Divergence>&, StageEnd);
template Event diverged_event(const Instant<3>&, const StageReport&);
template std::string unsettled_reason(const Instant<3>&);
template Event unsettled_event(const Instant<3>&);

}  // namespace trilith
