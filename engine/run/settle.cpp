// Static equilibrium as a stage of a run.
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/flagged.hpp"
#include "model/postpone.hpp"
#include "run/load_way.hpp"
#include "run/simulation.hpp"
#include "run/stage_end.hpp"
#include "run/watch.hpp"
#include "statics/equilibrium.hpp"

namespace trilith {
namespace {

/// Text: the loads at the end of a stage without time.
template <int D>
std::string loads_text(const LoadWay<D>* way) {
  if (way == nullptr || way->points.empty() || way->loads.empty()) return "under all loads (load factor 1)";
  return fmt::format("when the load factor of '{}' reached {:.4g}", way->loads.front().name, way->points.back().factor);
}

StageEnd rest_end(const Equilibrium& found) {
  if (found.end == EquilibriumEnd::stopped) return StageEnd::stopped;
  if (found.end == EquilibriumEnd::unstable) return StageEnd::unstable;
  return found.converged ? StageEnd::rest : StageEnd::not_at_rest;
}

/// True for a point that is strained beyond its limit, at which a path ends. Points before the last crack have fewer
/// nodes than the model, and are none.
template <int D>
bool is_beyond(const Model<D>& model, const Waypoint<D>& point) {
  return point.state.position.size() == model.mass.size() && is_overstrained(model, point.state);
}

/// Number of the points of a path that are reported: all up to the first one that is strained beyond its limit.
template <int D>
std::size_t reported_points(const Model<D>& model, const LoadWay<D>& way) {
  std::size_t count = 0;
  while (count < way.points.size() && !is_beyond(model, way.points[count])) ++count;
  return count;
}

template <int D>
bool cracks_from(const LoadWay<D>& way, std::size_t point) {
  return std::any_of(way.points.begin() + static_cast<std::ptrdiff_t>(point), way.points.end(),
                     [](const Waypoint<D>& p) { return !p.cracks.empty(); });
}

/// Sets the loads that a path scales. `unit`: at factor 1.
template <int D>
void set_scaled_loads(Model<D>& model, const std::vector<PointLoad<D>>& unit, double factor) {
  auto one = unit.begin();
  for (PointLoad<D>& load : loads_of<PointLoad<D>>(model))
    if (one != unit.end() && load.name == one->name) load.force = factor * (one++)->force;
}

}  // namespace

template <int D>
void postpone_by_way(Model<D>& model, const LoadWay<D>& way) {
  const std::size_t reported = reported_points(model, way);
  double told = 0;
  for (std::size_t i = 0; i < reported; ++i)
    postpone_courses(model, way.time_of(i) - std::exchange(told, way.time_of(i)));
  postpone_courses(model, way.duration() - told);
  if (!way.end) return;  // the loads have stayed as they were at the end of the path
  const std::vector<PointLoad<D>>* loads = &way.loads;
  for (std::size_t i = 0; i < reported; ++i)
    if (!way.points[i].cracks.empty()) loads = &way.points[i].loads;
  set_scaled_loads(model, *loads, way.points.back().factor);
}

/// Reports the events of a change at this instant, and returns them.
template <int D>
std::vector<Event> Simulation<D>::tell_change(const RunListener<D>& listener) {
  unscale_masses(), edited();
  std::vector<Event> told = std::exchange(leaving_, {});
  refresh();
  for (const Event& e : told) tell(e, listener, instant());
  return told;
}

/// Sets state and scaled loads to each point of the path in turn and reports it, and divides the bodies that crack
/// there. Time increases from point to point; motions and load curves are shifted by the same time.
template <int D>
void Simulation<D>::tell_way(const LoadWay<D>& way, const RunListener<D>& listener) {
  const State<D> end = way.end ? *way.end : state_;
  std::vector<PointLoad<D>> loads = way.loads;
  double told = 0;  // time since the stage began [s]
  const double begun = state_.time;
  std::size_t at = 0;
  const auto go_to = [&](const Waypoint<D>& point, const State<D>& state, double since) {
    set_scaled_loads(model_, loads, point.factor);
    postpone_courses(model_, since - std::exchange(told, since));
    state_ = state;
    state_.time = begun + since, state_.last_dt = 0;
    drop_work();
    refresh();
  };
  const auto tell_here = [&](const Waypoint<D>& point) {
    tell_point(point, listener);
    for (const std::vector<Crack<D>>& cracks : point.cracks) {
      assert(listener.crack_bodies);
      listener.crack_bodies(cracks);
      tell_change(listener);
    }
    if (!point.cracks.empty()) loads = point.loads;
  };
  const std::size_t last = way.points.size() - 1;
  try {
    if (!is_beyond(model_, way.points[0])) go_to(way.points[0], way.points[0].state, way.time_of(0));
    tell(stage_event(EventType::stage_begun, instant(), stage_->options.name), listener, instant());
    for (; at <= last && !is_beyond(model_, way.points[at]); ++at) {
      if (at > 0) go_to(way.points[at], way.points[at].state, way.time_of(at));
      tell_here(way.points[at]);
    }
  } catch (...) {  // a handler failed: the model still ends at the end of the path, unless bodies crack before it
    if (!cracks_from(way, at)) go_to(way.points[last], end, way.duration());
    throw;
  }
  go_to(way.points[last], end, way.duration());
}

/// Reports the events that led to a point, and its samples.
template <int D>
void Simulation<D>::tell_point(const Waypoint<D>& point, const RunListener<D>& listener) {
  const Instant<D> now = instant();
  const StageOptions& options = stage_->options;
  for (Event e : point.events) {
    e.time = state_.time;
    tell(std::move(e), listener, now);
  }
  if (options.frame_interval > 0 && listener.on_frame) listener.on_frame(now);
  if (options.history_interval > 0 && listener.on_history) listener.on_history(now);
  if (options.energy_interval > 0 && listener.on_energy) listener.on_energy(now, energy());
  if (listener.on_step) listener.on_step(now);
}

/// An equilibrium in which bodies crack is followed by another one, with their parts. The events of each are reported.
template <int D>
std::optional<Divergence> Simulation<D>::find_rest(const EquilibriumOptions& how, const RunListener<D>& listener,
                                                   const std::string& loads, Equilibrium& found) {
  for (int steps = 0;; steps = found.steps) {
    found = find_equilibrium(model_, state_, how);
    found.steps += steps;
    watch_->reset();
    drop_work();
    refresh();
    for (const Event& e : found.events) tell(e, listener, instant());
    if (std::optional<Divergence> diverged = watch_->look_at_strains(instant(), loads)) return diverged;
    if (!found.converged || !cracks_now(listener)) return std::nullopt;
  }
}

/// Makes the changes of this instant, and reports them. True if bodies have cracked.
template <int D>
bool Simulation<D>::cracks_now(const RunListener<D>& listener) {
  if (cracking_.bodies.empty() || !listener.change_model) return false;
  const std::size_t bodies = model_.bodies.size();
  if (!listener.change_model(model_)) return false;
  const std::vector<Event> told = tell_change(listener);
  const auto is_crack = [](const Event& e) { return e.type == EventType::unit_cracked; };
  return model_.bodies.size() != bodies && std::any_of(told.begin(), told.end(), is_crack);
}

/// A stage without duration, between two evaluations of the same instant; the events that led to rest are reported at
/// the second one. A structure strained beyond its limit at the start, as at the end of a load path, is not settled.
template <int D>
StageReport Simulation<D>::settle(const StageOptions& options, const EquilibriumOptions& how,
                                  const RunListener<D>& listener, const LoadWay<D>* way) {
  if (options.process) return process(options, how, listener);
  StageOptions asked = options;
  asked.must_rest = false;  // if no rest is found the state remains unchanged and valid
  begin_stage(asked);
  StageReport& report = stage_->report;
  const Flagged running(running_);
  try {
    if (way != nullptr && !way->points.empty()) {
      tell_way(*way, listener);
    } else {
      refresh();
      tell(stage_event(EventType::stage_begun, instant(), options.name), listener, instant());
    }
    std::optional<Divergence> diverged =
        watch_->look_at_strains(instant(), way != nullptr ? loads_text(way) : "at the start of the stage");
    Equilibrium found;
    if (!diverged) diverged = find_rest(how, listener, loads_text(way), found);
    const Instant<D> now = instant();
    if (listener.on_step) listener.on_step(now);
    if (diverged && diverged->event) tell(*diverged->event, listener, now);
    report.steps = found.steps;
    report.speed = now.speed, report.ratio = found.left;
    set_end(report, now, diverged, rest_end(found));
    if (report.end == StageEnd::not_at_rest) report.reason = no_rest_reason(model_, found);
    if (report.end == StageEnd::unstable) set_unstable(report, model_, found.travel, how.within);
    if (!diverged) tell_samples(listener, now, true);
    tell_end(listener, now);
    // Requests of handlers take effect at the end of the stage.
    if (listener.change_model && listener.change_model(model_)) unscale_masses(), edited();
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

template void postpone_by_way(Model<2>&, const LoadWay<2>&);
template void postpone_by_way(Model<3>&, const LoadWay<3>&);

}  // namespace trilith
