// Pushover: bodies pushed steadily, with the force that this requires.
#include <algorithm>
#include <cmath>

#include "base/quantity_text.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/loads/load_reading.hpp"
#include "bindings/stages/pushover_parts.hpp"
#include "bindings/stages/stage_run.hpp"
#include "load/motion.hpp"
#include "load/ramp.hpp"
#include "model/caution.hpp"
#include "model/loads.hpp"
#include "model/pose.hpp"
#include "model/pushes.hpp"
#include "run/pushover.hpp"
#include "statics/push_compliance.hpp"

namespace trilith::script {
namespace {

/// Displacement of the pushed points.
template <int D>
std::function<double(const Instant<D>&)> way_reading(const PushOrder<D>& o) {
  return [name = o.stage.name](const Instant<D>& now) {
    for (const Push<D>& p : now.model.pushes)
      if (p.name == name) return push_place(now.state, p) - p.origin;
    return 0.0;
  };
}

/// Drift; without storeys the displacement of the pushed points.
template <int D>
std::function<double(const Instant<D>&)> drift_reading(SimulatedModel<D>& m, const PushOrder<D>& o) {
  const std::function<const Findings<D>&()> findings = [&m]() -> const Findings<D>& { return m.findings(); };
  if (auto drift = storey_reading<D>(findings, o))
    return [drift](const Instant<D>& now) { return drift(now.model, now.state); };
  return way_reading(o);
}

/// A push that was ended early stops within 1 % of its intended duration.
template <int D>
void stop_push(SimulatedModel<D>& m, const PushOrder<D>& o) {
  m.change([&](Model<D>& model) {
    const double now = m.time();
    for (Push<D>& p : model.pushes) {
      if (p.name != o.stage.name) continue;
      const MotionAt at = p.motion->at(now - p.start);
      if (at.velocity == 0) continue;
      p.motion = std::make_shared<const GroundMotion>(
          stopping_motion(at.displacement, at.velocity, 0.01 * o.displacement / o.rate));
      p.start = now;
    }
  });
}

/// Sets the model's watch during its lifetime.
template <int D>
struct Watch {
  SimulatedModel<D>& model;
  Watch(SimulatedModel<D>& m, std::function<void(const Instant<D>&)> f) : model(m) { model.watch = std::move(f); }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;
  ~Watch() { model.watch = nullptr; }
};

/// Default rate: the push accelerates by at most this value [m/s2]. It takes this number of periods of a structure with
/// the same stiffness along the push and the whole mass, but at most this time [s]. An elastic structure then
/// oscillates about the static force by about 1 % of the largest force.
constexpr double gentle_acceleration = 1e-3 * standard_gravity, gentle_periods = 10, longest_gentle = 100;
/// A given rate is reached within this number of periods, and by this mean acceleration [m/s2], as the default rate is.
constexpr double ramp_periods = 0.2 * gentle_periods, ramp_acceleration = 0.5 * gentle_acceleration;

/// Period of a structure with the same stiffness along the push and the whole mass [s]; 0 if another push acts.
template <int D>
double push_period(const Simulation<D>& sim, const PushOrder<D>& o) {
  if (!sim.model().pushes.empty()) return 0;
  double mass = 0;
  for (int n = 0; n < sim.model().nodes(); ++n) mass += sim.model().moves(n) ? sim.model().mass[n] : 0;
  return 2 * M_PI * std::sqrt(mass * push_compliance(sim.model(), sim.state(), order_push(sim.model(), o)));
}

template <int D>
GroundMotion push_motion(const Simulation<D>& sim, const PushOrder<D>& o) {
  const double period = push_period(sim, o);
  if (o.rate != 0)
    return even_motion(o.displacement, o.rate, std::max(ramp_periods * period, o.rate / ramp_acceleration));
  return gentle_motion(o.displacement, gentle_acceleration, std::min(gentle_periods * period, longest_gentle));
}

/// The part of a peak that the structure carries, and a remedy. Below 0 the supports push along with it: the masses
/// swing, and a slower push does not end this.
std::string inertia_text(const PushPeak& peak, double slower, bool gently) {
  if (peak.carried <= 0)
    return fmt::format(
        "the structure carries none of it, and its masses take {}: it swings, as after a break or an "
        "impact. Read the curve before this displacement, or use control = \"arc\"",
        quantity_text(peak.force - peak.carried, "N"));
  return fmt::format(
      "the structure carries {} of it, and inertia and damping the rest, {:.1f} %. Push more slowly, at "
      "{:.2g} m/s or less, {}or use control = \"arc\"",
      quantity_text(peak.carried, "N"), 100 * peak.share_of_inertia(), slower, gently ? "" : "or leave out rate, ");
}

/// A peak with a share of inertia and damping is not a capacity.
void note_inertia(lua_State* L, ScriptModel& m, const std::string& name, double rate, double usual, bool gently,
                  const PushPeak& peak) {
  if (peak.is_static()) return;
  const double slower = std::min(usual, rate * PushPeak::most_of_inertia / peak.share_of_inertia());
  m.note_at_once(fmt::format("{}{}: the peak of {} at {} is not a static capacity: {}", caution_mark, name,
                             quantity_text(peak.force, "N"), quantity_text(peak.displacement, "m"),
                             inertia_text(peak, slower, gently)),
                 host(L));
}

/// m:pushover{ control = "time", ... }: steadily in time.
template <int D, class ModelOfScript>
int push_by_time(lua_State* L, ModelOfScript& m, PushOrder<D>& o, const StageUntil& until) {
  const double usual = gentle_speed(gentle_motion(o.displacement, gentle_acceleration, 0));
  const bool gently = o.rate == 0;
  const auto motion = std::make_shared<const GroundMotion>(push_motion(m.evaluated(), o));
  if (gently) o.rate = gentle_speed(*motion);
  o.stage.duration = motion->duration();
  PushoverRecorder<D> recorder(o.stage.name, o.stage.duration / o.samples, o.limits, drift_reading<D>(m, o));
  std::vector<PushRow<D>> rows = order_push(m.simulation().model(), o).rows;
  m.change([&](Model<D>& changed) {
    add_push(changed, m.if_built()->state(), o.stage.name, std::move(rows), o.direction, motion);
  });
  const Watch<D> watch(m, [&](const Instant<D>& now) {
    if (recorder.step(now)) m.stop("limit of the pushover: " + recorder.limit());
  });
  std::size_t given = 0;
  const StageSamples samples{o.on_sample, [&] { return recorder.curve().force.size() > given; },
                             [&] { push_sample(L, recorder.curve(), given++); }};
  const StageReport report = run_stage(L, m, o.stage, until, samples);
  recorder.finish();
  stop_push<D>(m, o);
  push_report(L, report);
  const bool met = report.end == StageEnd::stopped && recorder.limit().empty();
  const PushCurve curve = with_peak(recorder.curve(), recorder.peak());
  add_curve(L, curve, curve.peak(), met ? "until" : recorder.limit().empty() ? "displacement" : recorder.limit());
  add_statics(L, recorder.peak().carried, recorder.peak().is_static());
  note_inertia(L, m, o.stage.name, o.rate, usual, gently, recorder.peak());
  return 1;
}

void require_stopped(const ScriptModel& m) {
  if (m.running()) throw InputError("pushover: a stage runs already; begin it when that has ended");
}

int push_in_space(lua_State* L, SpaceModel& m) {
  Keys keys(L, 2, "pushover");
  PushOrder<3> o = read_order<3>(keys, m);
  const StageUntil until = o.by_arc ? StageUntil{} : read_until(keys, m);
  keys.finish();
  require_stopped(m);
  if (!o.place.empty()) o.at = named_place(m, o.bodies.front(), o.place, keys.owner());
  hold_top(m, o);
  return o.by_arc ? push_by_arc<3>(L, m, o) : push_by_time(L, m, o, until);
}

/// m:pushover{ body =, at =, direction =, pattern =, rate =, displacement =, drift =, storey =, drop =, ... }
int pushover(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return push_in_space(L, *space);
  PlaneModel& m = this_plane(L);
  Keys keys(L, 2, "pushover");
  PushOrder<2> o = read_order<2>(keys, m);
  const StageUntil until = o.by_arc ? StageUntil{} : read_until(keys, m);
  keys.finish();
  require_stopped(m);
  if (!o.place.empty()) o.at = named_place(m, o.bodies.front(), o.place, keys.owner());
  hold_top(m, o);
  return o.by_arc ? push_by_arc<2>(L, m, o) : push_by_time(L, m, o, until);
}

/// Present force of a push along a load path; 0 if its load was removed.
template <int D>
double force_of(const Simulation<D>& sim, const LoadPush<D>& pushed) {
  double sum = 0;
  for (const PointLoad<D>& load : loads_of<PointLoad<D>>(sim.model()))
    if (load.name == pushed.push.name) sum += load.curve.at(sim.state().time) * load.force.dot(pushed.push.direction);
  return sum;
}

template <int D>
double sum_of(SimulatedModel<D>& m) {
  const Simulation<D>& sim = m.evaluated();
  double sum = 0;
  for (const double force : sim.work().push_force) sum += force;
  for (const LoadPush<D>& pushed : m.load_pushes) sum += force_of(sim, pushed);
  return sum;
}
double sum_of_pushes(const ModelBox& box) {
  SpaceModel* space = as_space(box.get());
  return space != nullptr ? sum_of(*space) : sum_of(box.plane());
}

template <int D>
double latest_way(const SimulatedModel<D>& m) {
  const Simulation<D>* s = m.if_built();
  if (s == nullptr) return 0;
  if (!s->model().pushes.empty()) {  // a load path cannot be followed with an active push, so this one is later
    const Push<D>& p = s->model().pushes.back();
    return push_place(s->state(), p) - p.origin;
  }
  const auto& loads = loads_of<PointLoad<D>>(s->model());
  for (auto p = m.load_pushes.rbegin(); p != m.load_pushes.rend(); ++p)
    if (std::any_of(loads.begin(), loads.end(), [&](const auto& load) { return load.name == p->push.name; }))
      return push_place(s->state(), p->push) - p->first_place;
  return 0;
}
double push_displacement(const ModelBox& box) {
  SpaceModel* space = as_space(box.get());
  return space != nullptr ? latest_way(*space) : latest_way(box.plane());
}

const std::array pushover_method_list{
    Method{"pushover", guarded<pushover>},
};

using PushoverProperty = Property<ModelBox>;
const std::array pushover_property_list{
    PushoverProperty{"push_force", "N", "present force of all pushes, along them", sum_of_pushes},
    PushoverProperty{"push_displacement", "m", "displacement of the latest push", push_displacement},
};

}  // namespace

std::span<const Method> pushover_methods() {
  return pushover_method_list;
}
std::span<const Property<ModelBox>> pushover_properties() {
  return pushover_property_list;
}

}  // namespace trilith::script
