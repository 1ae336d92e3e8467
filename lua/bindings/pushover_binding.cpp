// Pushover: bodies pushed steadily, as much force as it takes.
#include <algorithm>
#include <cmath>

#include "bindings.hpp"
#include "interrupt_watch.hpp"
#include "load/ramp.hpp"
#include "load_reading.hpp"
#include "pushover_order.hpp"
#include "run/load_way.hpp"
#include "run/pushover.hpp"
#include "run/watch.hpp"
#include "stage_run.hpp"
#include "step/equilibrium.hpp"
#include "step/load_path.hpp"
#include "world/loads.hpp"
#include "world/pose.hpp"
#include "world/pushes.hpp"

namespace trilith::script {
namespace {

/// How far the pushed points are.
template <int D>
std::function<double(const Instant<D>&)> way_reading(const PushOrder<D>& o) {
  return [name = o.stage.name](const Instant<D>& now) {
    for (const Push<D>& p : now.model.pushes)
      if (p.name == name) return push_place(now.state, p) - p.origin;
    return 0.0;
  };
}

/// The level part of a push's direction, of length 1; nothing where it is upright.
template <int D>
std::optional<Vec<D>> level_direction(Vec<D> direction) {
  direction[D - 1] = 0;
  const double size = direction.norm();
  if (!(size > 1e-9)) return std::nullopt;
  return Vec<D>(direction / size);
}

/// Drift of a storey or of the top one: along x in the plane, in space along the level part of the push. Nothing, where
/// there are no storeys, or nothing level in the push.
template <int D>
std::function<double(const Model<D>&, const State<D>&)> storey_reading(SimulatedModel<D>& m, const PushOrder<D>& o) {
  const Findings<D>& f = m.findings();
  if (f.storeys.empty()) {
    if (o.storey != 0) throw InputError("pushover: there are no storeys; leave 'storey' out");
    return {};
  }
  const std::optional<Vec<D>> along = D == 2 ? Vec<D>(Vec<D>::UnitX()) : level_direction<D>(o.direction);
  if (!along) {
    if (o.storey != 0) throw InputError("pushover: an upright push has no drift; leave 'storey' out");
    return {};
  }
  if (o.storey == 0)
    return [&f, e = *along](const Model<D>& model, const State<D>& state) {
      return e.dot(top_drift(model, state, f.storeys, f.base));
    };
  for (std::size_t i = 0; i < f.storeys.size(); ++i)
    if (f.storeys[i].number == o.storey)
      return [&f, i, e = *along](const Model<D>& model, const State<D>& state) {
        return e.dot(storey_drift(model, state, f.storeys, f.base, i));
      };
  throw InputError(fmt::format("pushover: there is no storey {}; there are {}", o.storey, f.storeys.size()));
}

/// Without storeys how far the pushed points are.
template <int D>
std::function<double(const Instant<D>&)> drift_reading(SimulatedModel<D>& m, const PushOrder<D>& o) {
  if (auto drift = storey_reading(m, o)) return [drift](const Instant<D>& now) { return drift(now.model, now.state); };
  return way_reading(o);
}

/// A push that was ended on its way comes to rest within a hundredth of the time it was meant to last.
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

void set_array(lua_State* L, const char* key, const std::vector<double>& values) {
  lua_createtable(L, static_cast<int>(values.size()), 0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    lua_pushnumber(L, values[i]);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  lua_setfield(L, -2, key);
}

void add_curve(lua_State* L, const PushCurve& curve, std::string_view limit) {
  const auto number = [&](const char* key, double value) {
    lua_pushnumber(L, value);
    lua_setfield(L, -2, key);
  };
  lua_createtable(L, 0, 4);
  set_array(L, "t", curve.time);
  set_array(L, "displacement", curve.displacement);
  set_array(L, "force", curve.force);
  set_array(L, "drift", curve.drift);
  lua_setfield(L, -2, "curve");
  const bool any = !curve.force.empty();
  const std::size_t peak = curve.peak();
  number("peak_force", any ? curve.force[peak] : 0);
  number("displacement_at_peak", any ? curve.displacement[peak] : 0);
  number("drift_at_peak", any ? curve.drift[peak] : 0);
  number("force", any ? curve.force.back() : 0);
  number("displacement", any ? curve.displacement.back() : 0);
  number("drift", any ? curve.drift.back() : 0);
  lua_pushlstring(L, limit.data(), limit.size());
  lua_setfield(L, -2, "limit");
}

/// The model's watch, for as long as this lives.
template <int D>
struct Watch {
  SimulatedModel<D>& model;
  Watch(SimulatedModel<D>& m, std::function<void(const Instant<D>&)> f) : model(m) { model.watch = std::move(f); }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;
  ~Watch() { model.watch = nullptr; }
};

/// The push as loads at its points, 1 N in all; those of a rigid body at a point of it turn it too.
template <int D>
std::vector<PointLoad<D>> unit_loads(const Model<D>& model, const std::string& name, const Push<D>& push) {
  std::vector<PointLoad<D>> out;
  for (const PushRow<D>& row : push.rows) {
    PointLoad<D> load;
    load.name = name, load.body = body_of_node(model, row.node);
    load.at = Tie<D>::to_node(row.node, row.place), load.at.turn[0] = row.turn;
    load.force = row.weight * push.direction;
    out.push_back(std::move(load));
  }
  return out;
}

/// Equilibria along a push, and when to end.
template <int D>
class ArcRecorder {
 public:
  ArcRecorder(const Push<D>& push, const PushOrder<D>& order, std::function<double(const State<D>&)> drift)
      : push_(push), order_(order), drift_(std::move(drift)) {}

  /// True where the path is to go on. A point that is strained beyond a limit ends it, and is none of the curve's.
  bool add(const PathPoint& point, const State<D>& state, bool overstrained) {
    way_.push_back({state, point.factor});
    if (overstrained) limit_ = "strain";
    if (overstrained) return false;
    const double place = push_place(state, push_), drift = drift_(state);
    if (curve_.force.empty()) first_place_ = place, first_drift_ = drift;
    curve_.time.push_back(state.time);
    curve_.force.push_back(point.factor);
    curve_.displacement.push_back(place - first_place_);
    curve_.drift.push_back(drift - first_drift_);
    const double most = curve_.force[curve_.peak()];
    if (std::abs(curve_.drift.back()) >= order_.limits.drift) limit_ = "drift";
    if (order_.limits.drop > 0 && most > 0 && point.factor < order_.limits.drop * most) limit_ = "drop";
    if (std::abs(curve_.displacement.back()) >= order_.displacement) limit_ = "displacement";
    return limit_.empty();
  }
  [[nodiscard]] const PushCurve& curve() const { return curve_; }
  [[nodiscard]] const std::string& limit() const { return limit_; }
  [[nodiscard]] std::vector<Waypoint<D>> take_way() { return std::move(way_); }

 private:
  const Push<D>& push_;
  const PushOrder<D>& order_;
  std::function<double(const State<D>&)> drift_;
  double first_place_ = 0, first_drift_ = 0;
  PushCurve curve_;
  std::vector<Waypoint<D>> way_;
  std::string limit_;
};

template <int D>
std::function<double(const State<D>&)> arc_drift(SimulatedModel<D>& m, const PushOrder<D>& o, const Push<D>& push) {
  if (auto drift = storey_reading(m, o)) {
    const Model<D>& model = m.simulation().model();
    return [drift, &model](const State<D>& state) { return drift(model, state); };
  }
  return [&push](const State<D>& state) { return push_place(state, push); };
}

/// Ends of a path that its recorder did not ask for.
std::string_view arc_limit(PathEnd end) {
  return end == PathEnd::most_points ? "samples" : end == PathEnd::stuck ? "stuck" : "arrived";
}

/// { {force =, displacement =, highest =}, ... }: where the force turns.
void set_limits(lua_State* L, const LoadPath& path) {
  lua_createtable(L, static_cast<int>(path.limits.size()), 0);
  for (std::size_t i = 0; i < path.limits.size(); ++i) {
    lua_createtable(L, 0, 3);
    lua_pushnumber(L, path.limits[i].factor);
    lua_setfield(L, -2, "force");
    lua_pushnumber(L, path.limits[i].displacement);
    lua_setfield(L, -2, "displacement");
    lua_pushboolean(L, path.limits[i].is_highest ? 1 : 0);
    lua_setfield(L, -2, "highest");
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  lua_setfield(L, -2, "limits");
}

/// What broke and yielded on the way, in words.
void set_happened(lua_State* L, const ScriptModel& m, const LoadPath& path) {
  lua_createtable(L, static_cast<int>(path.events.size()), 0);
  for (std::size_t i = 0; i < path.events.size(); ++i) {
    lua_pushstring(L, m.text_of(path.events[i]).c_str());
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  lua_setfield(L, -2, "happened");
}

/// The path's last equilibrium becomes the model's state, with the loads of there, so that it stands.
template <int D>
void take_over(SimulatedModel<D>& m, State<D> state, std::vector<PointLoad<D>> loads, double factor) {
  for (PointLoad<D>& load : loads) load.force *= factor;
  m.change([&](Model<D>& model) {
    model.point_loads.insert(model.point_loads.end(), std::make_move_iterator(loads.begin()),
                             std::make_move_iterator(loads.end()));
  });
  Simulation<D>& sim = m.simulation();
  Snapshot<D> there = sim.snapshot();
  there.state = std::move(state);
  sim.restore(there);
}

/// m:pushover{ control = "arc", ... }: by equilibria, past limit points (step/load_path.hpp).
template <int D, class ModelOfScript>
int push_by_arc(lua_State* L, ModelOfScript& m, PushOrder<D>& o) {
  const Simulation<D>& sim = m.evaluated();
  const std::vector<std::string> names = load_names(sim.model());
  if (std::find(names.begin(), names.end(), o.stage.name) != names.end())
    throw InputError(fmt::format("pushover: there is a load or push '{}'; give another name", o.stage.name));
  Push<D> push;
  push.rows = push_rows(sim.model(), o.bodies, o.at, o.pattern, o.direction), push.direction = o.direction;
  LoadWay<D> way{unit_loads(sim.model(), o.stage.name, push), {}};
  Model<D> model = sim.model();
  model.point_loads.insert(model.point_loads.end(), way.loads.begin(), way.loads.end());
  ArcRecorder<D> recorder(push, o, arc_drift<D>(m, o, push));
  LoadPathOptions<D> how;
  how.loads = o.stage.name;
  how.first = o.arc > 0 ? o.arc : 0.01 * o.displacement;
  how.longest = 5 * how.first, how.most_points = o.samples;
  for (const PushRow<D>& row : push.rows)
    for (int k = 0; k < D; ++k)
      if (push.direction[k] != 0) how.followed.push_back({{row.node, k}, row.weight * push.direction[k]});
  const InterruptWatch watch(L, host(L));
  how.goes_on = [&](const PathPoint& point, const State<D>& state) {
    return !watch.pressed() && recorder.add(point, state, is_overstrained(model, state));
  };
  State<D> state = sim.state();
  const LoadPath path = follow_loads(model, state, how);
  if (path.end == PathEnd::no_rest)
    throw InputError(
        "pushover: there is no rest to begin from; find it by m:consolidate{ integrator = \"static\" }, "
        "which tells what fails");
  take_over<D>(m, std::move(state), way.loads, path.points.back().factor);
  way.points = recorder.take_way();
  EquilibriumOptions rest;
  o.stage.duration = 1;  // none goes by
  push_report(L, settle_stage(L, m, o.stage, rest, &way));
  add_curve(L, recorder.curve(), recorder.limit().empty() ? arc_limit(path.end) : recorder.limit());
  set_limits(L, path), set_happened(L, m, path);
  return 1;
}

/// m:pushover{ control = "time", ... }: steadily in time.
template <int D, class ModelOfScript>
int push_by_time(lua_State* L, ModelOfScript& m, PushOrder<D>& o, const StageUntil& until) {
  const auto motion = std::make_shared<const GroundMotion>(even_motion(o.displacement, o.rate));
  o.stage.duration = motion->duration();
  PushoverRecorder<D> recorder(o.stage.name, o.stage.duration / o.samples, o.limits, drift_reading<D>(m, o));
  std::vector<PushRow<D>> rows = push_rows(m.simulation().model(), o.bodies, o.at, o.pattern, o.direction);
  m.change([&](Model<D>& changed) {
    add_push(changed, m.if_built()->state(), o.stage.name, std::move(rows), o.direction, motion);
  });
  const Watch<D> watch(m, [&](const Instant<D>& now) {
    if (recorder.step(now)) m.stop();
  });
  const StageReport report = run_stage(L, m, o.stage, until);
  recorder.finish();
  stop_push<D>(m, o);
  push_report(L, report);
  const bool met = report.end == StageEnd::stopped && recorder.limit().empty();
  add_curve(L, recorder.curve(), met ? "until" : recorder.limit().empty() ? "displacement" : recorder.limit());
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
  return o.by_arc ? push_by_arc(L, m, o) : push_by_time(L, m, o, until);
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
  return o.by_arc ? push_by_arc(L, m, o) : push_by_time(L, m, o, until);
}

template <int D>
double sum_of(SimulatedModel<D>& m) {
  double sum = 0;
  for (const double force : m.evaluated().work().push_force) sum += force;
  return sum;
}
double sum_of_pushes(const ModelBox& box) {
  SpaceModel* space = as_space(box.get());
  return space != nullptr ? sum_of(*space) : sum_of(box.plane());
}

template <int D>
double latest_way(const SimulatedModel<D>& m) {
  const Simulation<D>* s = m.if_built();
  if (s == nullptr || s->model().pushes.empty()) return 0;
  const Push<D>& p = s->model().pushes.back();
  return push_place(s->state(), p) - p.origin;
}
double push_displacement(const ModelBox& box) {
  SpaceModel* space = as_space(box.get());
  return space != nullptr ? latest_way(*space) : latest_way(box.plane());
}

const std::array pushover_method_list{
    Method{"pushover", guarded<pushover>,
           "pushover{body=, at=, direction=, pattern=, control=, rate=, arc=, displacement=, drift=, storey=, drop=}: "
           "a stage that pushes steadily, or by equilibria past limit points"},
};

using PushoverProperty = Property<ModelBox>;
const std::array pushover_property_list{
    PushoverProperty{"push_force", "N", "force of all pushes now, along them", sum_of_pushes},
    PushoverProperty{"push_displacement", "m", "displacement of the latest push since it began", push_displacement},
};

}  // namespace

std::span<const Method> pushover_methods() {
  return pushover_method_list;
}
std::span<const Property<ModelBox>> pushover_properties() {
  return pushover_property_list;
}

}  // namespace trilith::script
