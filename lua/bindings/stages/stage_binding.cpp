// Stages, and changes between them: drives, gravity, bounds.
#include <algorithm>
#include <cmath>

#include "base/no_solution.hpp"
#include "base/portable.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/fields/seepage_binding.hpp"
#include "bindings/loads/drive_reading.hpp"
#include "bindings/stages/mass_scaling_stage.hpp"
#include "bindings/stages/stage_reading.hpp"
#include "bindings/stages/stage_run.hpp"
#include "model/bounds.hpp"
#include "model/plausible_ranges.hpp"
#include "statics/equilibrium.hpp"

namespace trilith::script {
namespace {

/// Share of the longest stable step if `accuracy` limits the step at impacts and no damping brings the model to rest;
/// then only stability matters. It leaves a margin for contacts that become 50 % stiffer before the next estimate.
constexpr double safety_beside_accuracy = 0.8;
/// Default of explicit steps: a relevant impact keeps its energy within 1 % during closing and opening.
constexpr double usual_blow_accuracy = 0.02;
/// Smaller values would need an excessive number of steps, because these shorten in proportion.
constexpr double least_accuracy = 1e-9;

/// Reads the parameters of a scheme if it is named, and rejects its parameters if it is not.
template <Integrator I>
void read_scheme(Keys& keys, std::string_view name, StageOptions& o) {
  constexpr bool has_parameters = Declared<I>;
  if (name != I::name) {
    if constexpr (has_parameters)
      for (const Parameter<I>& p : I::parameters())
        if (keys.has(p.name))
          keys.problem(fmt::format("'{}' is for integrator = \"{}\", but this stage is {}; leave it out", p.name,
                                   I::name, name));
    return;
  }
  I scheme;
  if constexpr (has_parameters) keys.declared(scheme);
  if constexpr (requires { I::exclusive; }) {
    const auto [one, other, reason] = I::exclusive;
    if (keys.has(one) && keys.has(other))
      keys.problem(fmt::format("both '{}' and '{}' are given; keep one: {}", one, other, reason));
  }
  o.integrator = scheme;
}

/// { integrator =, tolerance =, accuracy = } and the parameters of the scheme. "auto": the implicit scheme, or central
/// differences.
void read_integrator(Keys& keys, StageOptions& o) {
  const std::string name = keys.text("integrator", "explicit");
  o.may_change = name == "auto";
  std::string names;
  bool is_known = o.may_change;
  Integrators::for_each([&]<class I>() {
    names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", I::name);
    is_known = is_known || name == I::name;
  });
  if (!is_known) keys.problem(fmt::format("'integrator' is \"{}\", must be {} or \"auto\"", name, names));
  const std::string_view scheme = o.may_change ? AlphaMethod::name : std::string_view(name);
  Integrators::for_each([&]<class I>() { read_scheme<I>(keys, scheme, o); });
  const bool is_stable = bound_of(o.integrator) == StepBound::stability;
  o.impact_accuracy = usual_blow_accuracy;
  double& accuracy = is_stable ? o.impact_accuracy : o.accuracy;
  accuracy = keys.number("accuracy", "1", accuracy);
  if (!(accuracy >= 0 && accuracy <= 1))
    keys.problem(fmt::format("'accuracy' is {:g}, must be from 0 to 1, a share of energies", accuracy));
  if (accuracy > 0 && accuracy < least_accuracy)
    keys.problem(fmt::format("'accuracy' is {:g}, must be 0 for any error, or at least {:g}; less needs too many steps",
                             accuracy, least_accuracy));
  const bool alone = keys.has("accuracy") && !keys.has("safety");
  if (is_stable && accuracy > 0 && alone && !(o.rest_share > 0)) o.safety = safety_beside_accuracy;
  if (is_stable) return refuse(keys, {"tolerance"}, AlphaMethod::name);
  o.tolerance = keys.number("tolerance", "1", o.tolerance);
  if (!(o.tolerance > 0 && o.tolerance <= 1e-2))
    keys.problem(fmt::format("'tolerance' is {:g}, must be above 0 and at most 0.01", o.tolerance));
}

int finish_stage(lua_State* L, ScriptModel& m, const StageOptions& o, const StageUntil& until = {}) {
  const StageReport report = run_stage(L, m, o, until);
  tell_scaling(L, m, report);
  if (const std::string held = held_water_note(m, o); !held.empty()) tell_note(L, m, held);
  if (report.end != StageEnd::diverged && report.end != StageEnd::unstable && !report.found.empty())
    tell_note(L, m, fmt::format("{}: {}", o.name, report.found));
  if (report.end == StageEnd::not_converged) throw NoSolution(fmt::format("{}: {}", o.name, report.reason));
  push_report(L, report);
  return 1;
}

/// Continues the stage of a paused model up to `limit`.
int run_paused(lua_State* L, ScriptModel& m, const RunLimit& limit) {
  run_on(L, m, limit);
  return 0;
}

int run(lua_State* L) {
  ScriptModel& m = this_model(L);
  Keys keys(L, 2, "run");
  StageOptions o;
  o.name = keys.text("name", "run");
  const double to = keys.number("to", "s", unbounded);
  o.duration = std::isfinite(to) ? to - m.time() : keys.number("duration", "s");
  if (std::isfinite(to) && keys.has("duration"))
    keys.problem("both 'to' and 'duration' are given; keep one: the time at which it ends, or how long it lasts");
  if (std::isfinite(to)) o.end_time = to, keys.know({"duration"});
  if (std::isfinite(to) && !(to > m.time()))
    keys.problem(fmt::format("'to' is {:g} s, must be after the present {:g} s", to, m.time()));
  o.rest_share = keys.number("local_damping", "1", 0);
  read_step(keys, o);
  read_scaling(keys, m, o);
  read_integrator(keys, o);
  o.until_rest = read_rest_table(keys, o);
  const StageUntil until = read_until(keys, m);
  keys.finish();
  if (m.paused()) return run_paused(L, m, {0, m.time() + o.duration, {}});
  return finish_stage(L, m, o, until);
}

int shake(lua_State* L) {
  ScriptModel& m = this_model(L);
  Keys keys(L, 2, "shake");
  StageOptions o;
  o.name = keys.text("name", "shake");
  const std::vector<DriveOrder> orders = read_drives(keys, m);
  const double end = last_end(orders);
  o.still_from = end;
  o.until_rest = read_rest_table(keys, o);
  o.duration = keys.number("duration", "s", o.until_rest ? end + 60 : end);
  read_step(keys, o);
  read_scaling(keys, m, o);
  read_integrator(keys, o);
  const StageUntil until = read_until(keys, m);
  keys.finish();
  if (m.running()) throw InputError("shake: a stage runs already; use m:drive to move a body while it runs");
  m.build();
  for (const DriveOrder& order : orders) apply_drive(m, order);
  tell_abrupt_ends(m, "shake", orders, host(L));
  tell_motions(m, orders, host(L).observer);
  return finish_stage(L, m, o, until);
}

int drive(lua_State* L) {
  ScriptModel& m = this_model(L);
  Keys keys(L, 2, "drive");
  const std::vector<DriveOrder> orders = read_drives(keys, m);
  keys.finish();
  m.build();
  for (const DriveOrder& order : orders) apply_drive(m, order);
  tell_abrupt_ends(m, "drive", orders, host(L));
  return 0;
}

/// A number that is allowed but implausible gets a note.
void report_implausible(lua_State* L, ScriptModel& m, const std::string& owner, std::string_view name,
                        std::string_view unit, double value) {
  std::vector<std::string> plausibility_notes;
  add_plausibility_note(plausibility_notes, owner, name, unit, value);
  for (const std::string& text : plausibility_notes) tell_note(L, m, text);
}

/// True while gravity rotates.
bool is_tilting(const ScriptModel& m) {
  const auto turns = [now = m.time()]<int D>(const SimulatedModel<D>& model) {
    if (model.if_built() == nullptr) return false;
    const Gravity<D>& g = model.if_built()->model().gravity;
    return g.tilt_rate != nothing<Spin<D>>() && now < g.tilt_end;
  };
  if (const PlaneModel* plane = as_plane(m)) return turns(*plane);
  return turns(static_cast<const SpaceModel&>(m));
}

/// From now on gravity rotates at `rate`, for the time needed to rotate by `by`.
template <int D>
void begin_tilt(SimulatedModel<D>& m, const Spin<D>& rate, double duration) {
  const SimulatedModel<D>* const self_model = &m;
  m.change([rate, duration, self_model](Model<D>& model) {
    const double now = self_model->if_built()->state().time;
    Gravity<D>& g = model.gravity;
    g.field = g.grown(now);
    g.tilt_rate = rate;
    g.tilt_start = now;
    g.tilt_end = now + duration;
  });
}

/// m:tilt{ rate =, by =, towards = }: from now on gravity rotates, up to `by`. In space it rotates towards the azimuth
/// `towards`, counted from x to y.
int tilt(lua_State* L) {
  ScriptModel& m = this_model(L);
  Keys keys(L, 2, "tilt");
  const double rate = keys.number("rate", "rad/s"), by = keys.number("by", "rad", unbounded);
  const double towards = m.dim() == 3 ? keys.number("towards", "rad", 0) : 0;
  if (!(by > 0)) keys.problem(fmt::format("'by' is {:g} rad, must be above 0; the rate sets the sign", by));
  if (rate == 0 && keys.has("by"))
    keys.problem(
        "'rate' is 0 rad/s, so gravity never turns by 'by'; give a rate, or leave 'by' out to stop the rotation");
  keys.finish();
  if (rate == 0 && !is_tilting(m))
    tell_note(L, m, "tilt: rate is 0 rad/s, and gravity is not rotating: nothing changes");
  report_implausible(L, m, "tilt", "rate", "rad/s", rate);
  report_implausible(L, m, "tilt", "by", "rad", by);
  const double duration = rate == 0 ? unbounded : by / std::abs(rate);
  if (SpaceModel* space = as_space(m)) {
    // About the horizontal axis across: the downward vector rotates towards (cos, sin, 0).
    const portable::SineCosine way = portable::sine_cosine(towards);
    const Vec3 axis(way.sine, -way.cosine, 0);
    begin_tilt<3>(*space, rate * axis, duration);
  } else {
    begin_tilt<2>(require_plane(m, "tilt"), rate, duration);
  }
  return 0;
}

template <int D>
Bounds<D> read_bounds(Keys& keys) {
  Bounds<D> chosen;
  bool any = false;
  for (int k = 0; k < D; ++k) {
    const auto [low, high] = bound_names<D>[static_cast<std::size_t>(k)];
    any = keys.has(low) || any;
    any = keys.has(high) || any;
    chosen.low[k] = keys.number(low, "m", -unbounded);
    chosen.high[k] = keys.number(high, "m", unbounded);
  }
  if (!any)
    keys.problem(D == 2 ? "no side is given; give left, right, bottom or top"
                        : "no side is given; give left, right, front, back, bottom or top");
  keys.finish();
  return chosen;
}

template <class M, int D>
void choose_bounds(M& m, const Bounds<D>& chosen) {
  m.builder.bounds = chosen;  // also for later additions
  if (m.built()) m.change([chosen](Model<D>& model) { set_bounds(model, chosen); });
}

/// m:bounds{ left =, right =, bottom =, top = }, in space front and back too: bodies outside are deactivated.
int bounds(lua_State* L) {
  ScriptModel& m = this_model(L);
  Keys keys(L, 2, "bounds");
  if (SpaceModel* space = as_space(m))
    choose_bounds(*space, read_bounds<3>(keys));
  else
    choose_bounds(require_plane(m, "bounds"), read_bounds<2>(keys));
  return 0;
}

int stop(lua_State* L) {
  ScriptModel& m = this_model(L);
  if (!m.running()) throw InputError("stop: no stage runs; call it from a handler or a story while one does");
  m.stop("by m:stop()");
  return 0;
}

const std::array stage_method_list{
    Method{"run", guarded<run>},     Method{"consolidate", guarded<push_consolidation>},
    Method{"shake", guarded<shake>}, Method{"drive", guarded<drive>},
    Method{"tilt", guarded<tilt>},   Method{"bounds", guarded<bounds>},
    Method{"stop", guarded<stop>},
};

}  // namespace

void tell_note(lua_State* L, ScriptModel& model, const std::string& text) {
  if (!model.running())
    model.add_note(text);
  else if (host(L).observer != nullptr)
    host(L).observer->note(text);
}

std::span<const Method> stage_methods() {
  return stage_method_list;
}

}  // namespace trilith::script
