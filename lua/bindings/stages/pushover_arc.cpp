// Pushover by arc length: equilibria along a push, reported as a stage.
#include <algorithm>
#include <cmath>

#include "base/no_solution.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/core/interrupt_watch.hpp"
#include "bindings/stages/pushover_parts.hpp"
#include "bindings/stages/stage_run.hpp"
#include "model/caution.hpp"
#include "model/loads.hpp"
#include "model/pose.hpp"
#include "model/postpone.hpp"
#include "model/pushes.hpp"
#include "run/crack_path.hpp"
#include "run/load_way.hpp"
#include "run/watch.hpp"
#include "statics/equilibrium.hpp"
#include "statics/load_path.hpp"

namespace trilith::script {
namespace {

/// The push as loads at its points, with a sum of 1 N; loads at points of a rigid body rotate it too.
template <int D>
std::vector<PointLoad<D>> unit_loads(const Model<D>& model, const std::string& name, const Push<D>& push) {
  std::vector<PointLoad<D>> out;
  for (const PushRow<D>& row : push.rows) {
    PointLoad<D> load;
    load.name = name, load.body = body_of_node(model, row.node);
    load.at = Attachment<D>::to_node(row.node, row.place), load.at.turn[0] = row.turn;
    load.force = row.weight * push.direction;
    out.push_back(std::move(load));
  }
  return out;
}

/// Equilibria along a push, and its end criteria. `drift`: none if it is the place of the push.
template <int D>
class ArcRecorder {
 public:
  ArcRecorder(Push<D> push, const PushOrder<D>& order, std::function<double(const State<D>&)> drift)
      : push_(std::move(push)), order_(order), drift_(std::move(drift)) {}

  /// True if the path continues. A point strained beyond a limit ends the path, and is not part of the curve.
  bool add(const PathPoint& point, const State<D>& state, bool overstrained) {
    way_.push_back({state, point.factor, point.length});
    if (overstrained) limit_ = "strain";
    if (overstrained) return false;
    const double place = push_place(state, push_), drift = drift_ ? drift_(state) : place;
    if (curve_.force.empty()) first_place_ = place, first_drift_ = drift;
    curve_.time.push_back(state.time);  // the path's begin, see finish()
    curve_.force.push_back(point.factor);
    curve_.displacement.push_back(place - first_place_);
    curve_.drift.push_back(drift - first_drift_);
    const double most = curve_.force[curve_.peak()];
    if (std::abs(curve_.drift.back()) >= order_.limits.drift) limit_ = "drift";
    if (order_.limits.drop > 0 && most > 0 && point.factor < order_.limits.drop * most) limit_ = "drop";
    if (std::abs(curve_.displacement.back()) >= order_.displacement) limit_ = "displacement";
    return limit_.empty();
  }
  /// Bodies crack at the last point; `model` has their parts.
  void add(const std::vector<Crack<D>>& cracks, const Model<D>& model) {
    way_.back().cracks.push_back(cracks);
    way_.back().loads.clear();
    for (const PointLoad<D>& load : loads_of<PointLoad<D>>(model))
      if (load.name == push_.name) way_.back().loads.push_back(load);
    push_.rows = rows_of_loads(model, push_.name, push_.direction);
  }
  [[nodiscard]] const PushCurve& curve() const { return curve_; }
  [[nodiscard]] const std::string& limit() const { return limit_; }
  /// The push on the bodies at the end of the path, and its place at the start.
  [[nodiscard]] LoadPush<D> push() const { return {push_, first_place_}; }
  /// Moves the points to `way`, each with the events up to it, and sets the times of the curve. Cracks are reported
  /// when the bodies are divided.
  void finish(const LoadPath& path, LoadWay<D>& way) {
    std::size_t told = 0;
    for (std::size_t i = 0; i < way_.size(); ++i) {
      for (; told < std::min(path.points[i].events, path.events.size()); ++told)
        if (path.events[told].type != EventType::unit_cracked) way_[i].events.push_back(path.events[told]);
    }
    way.points = std::move(way_);
    for (std::size_t i = 0; i < curve_.time.size(); ++i) curve_.time[i] += way.time_of(i);
  }

 private:
  Push<D> push_;
  const PushOrder<D>& order_;
  std::function<double(const State<D>&)> drift_;
  double first_place_ = 0, first_drift_ = 0;
  PushCurve curve_;
  std::vector<Waypoint<D>> way_;
  std::string limit_;
};

/// Ends of a path that its recorder did not cause.
std::string_view arc_limit(PathEnd end) {
  if (end == PathEnd::no_resistance) return "no resistance";
  if (end == PathEnd::stopped) return "stopped";
  return end == PathEnd::most_points ? "samples" : end == PathEnd::stuck ? "stuck" : "arrived";
}

/// Force and displacement of the last point, in words.
std::string last_point(const LoadPath& path) {
  return fmt::format("{:g} N and {:g} m", path.points.back().factor, path.points.back().displacement);
}

/// Note on a path without a further equilibrium: the place, the last event, and advice.
template <int D>
std::string stuck_note(SimulatedModel<D>& m, const LoadPath& path) {
  const Model<D>& model = m.simulation().model();
  const int body = path.worst >= 0 ? body_of_node(model, path.worst) : -1;
  const std::string where =
      body >= 0 ? fmt::format("; the largest residual of the last try is at '{}'", model.bodies[body].name) : "";
  const std::string event = path.events.empty() ? "" : "; last event: " + m.text_of(path.events.back());
  return fmt::format(
      "ends at {}, because no equilibrium is found next to it, even with the shortest step{}{}. A part may be free to "
      "slide or fall there; otherwise a shorter 'arc', or a finer mesh at softening joints, may help",
      last_point(path), where, event);
}

/// Notes where and why a path ended early, and the points that no arc has found.
template <int D>
void note_end(SimulatedModel<D>& m, const PushOrder<D>& o, const LoadPath& path, Host& host) {
  const auto note = [&](const std::string& text) { m.note_at_once(fmt::format("{}: {}", o.stage.name, text), host); };
  const auto caution = [&](const std::string& text) {
    m.note_at_once(fmt::format("{}{}: {}", caution_mark, o.stage.name, text), host);
  };
  if (path.end == PathEnd::stuck) caution("the load path " + stuck_note(m, path));
  if (path.end == PathEnd::no_resistance)
    note(fmt::format("the load path ends at {}: the structure can no longer carry the load", last_point(path)));
  if (path.end == PathEnd::most_points)
    caution(
        fmt::format("the load path ends at {} after the largest number of points, {}, before the displacement of {:g} "
                    "m; give more 'samples' or a longer 'arc'",
                    last_point(path), path.points.size(), o.displacement));
  if (path.searched > 0)
    note(
        fmt::format("{} of {} points were found by a search for rest at a given displacement, because contacts that "
                    "open, close or slide let no arc converge there",
                    path.searched, path.points.size()));
  if (const double whole = std::abs(path.points.back().displacement); path.missed > most_path_error * whole)
    caution(
        fmt::format("the steps miss {:.1f} % of the work of the push, as the path jumps; compare with a shorter 'arc'",
                    100 * path.missed / whole));
  if (path.snaps > 0)
    note(fmt::format(
        "{} times a part snapped, as no equilibrium lay next to the last point; rest was found behind it, and "
        "the slip on the way depends on the search",
        path.snaps));
  if (path.jumps > 0)
    note(
        fmt::format("{} times a bond broke and equilibrium was found again at the same displacement with another force",
                    path.jumps));
}

/// { {force =, displacement =, highest =}, ... }: limit points of the force.
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

/// Failures and yielding along the path, in words.
void set_happened(lua_State* L, const ScriptModel& m, const LoadPath& path) {
  lua_createtable(L, static_cast<int>(path.events.size()), 0);
  for (std::size_t i = 0; i < path.events.size(); ++i) {
    lua_pushstring(L, m.text_of(path.events[i]).c_str());
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  lua_setfield(L, -2, "happened");
}

/// The last equilibrium of the path becomes the model's state, with its loads, so that it is in equilibrium. Where
/// bodies crack on the path, the stage begins at the first one, and takes the model to the last one.
template <int D>
void take_over(SimulatedModel<D>& m, LoadWay<D>& way, State<D> state) {
  const bool cracks =
      std::any_of(way.points.begin(), way.points.end(), [](const auto& p) { return !p.cracks.empty(); });
  if (cracks) way.end = std::make_shared<const State<D>>(std::exchange(state, way.points.front().state));
  const double factor = cracks ? way.points.front().factor : way.points.back().factor;
  std::vector<PointLoad<D>> loads = way.loads;
  for (PointLoad<D>& load : loads) load.force *= factor;
  m.change([&](Model<D>& model) { model.loads.add(loads); });
  Simulation<D>& sim = m.simulation();
  Snapshot<D> there = sim.snapshot();
  there.state = std::move(state);
  sim.restore(there);
}

/// The path of a push, on a copy of the model: its bodies crack there first, and again when the path is reported.
template <int D>
class PushPath {
 public:
  PushPath(BuiltModel<D>& m, const PushOrder<D>& order, const InterruptWatch& watch)
      : order_(order),
        push_(order_push(m.simulation().model(), order)),
        path_{m.builder, m.simulation().model(), m.simulation().state(), m.simulation().cracking().bodies, {}},
        way_{unit_loads(path_.model, order.stage.name, push_), {}},
        recorder_(push_, order, drift()) {
    path_.model.loads.add(way_.loads);
    path_.on_cracks = [this](const std::vector<Crack<D>>& cracks) {
      recorder_.add(cracks, path_.model);
      findings_.reset();
    };
    how_.loads = order.stage.name;
    how_.first = order.arc > 0 ? order.arc : 0.01 * order.displacement;
    how_.longest = 5 * how_.first, how_.most_points = order.samples;
    how_.goes_on = [this, &watch](const PathPoint& point, const State<D>& state) {
      const bool on = recorder_.add(point, state, is_overstrained(path_.model, state));
      return on && !watch.pressed();
    };
    how_.is_stopped = [&watch] { return watch.pressed(); };
  }
  PushPath(const PushPath&) = delete;
  PushPath& operator=(const PushPath&) = delete;

  LoadPath follow() { return follow_loads(path_, how_); }
  [[nodiscard]] const ArcRecorder<D>& recorder() const { return recorder_; }
  /// The points of the path, which becomes the path of the model.
  const LoadWay<D>& take_over(SimulatedModel<D>& m, const LoadPath& path) {
    recorder_.finish(path, way_);
    script::take_over<D>(m, way_, std::move(path_.state));
    m.load_pushes.push_back(recorder_.push());
    return way_;
  }

 private:
  /// Storeys of the model of the path, which changes where bodies crack.
  std::function<double(const State<D>&)> drift() {
    const std::function<const Findings<D>&()> findings = [this]() -> const Findings<D>& {
      if (!findings_) findings_.emplace(path_.model);
      return *findings_;
    };
    if (auto reading = storey_reading<D>(findings, order_))
      return [reading, this](const State<D>& state) { return reading(path_.model, state); };
    return {};
  }

  const PushOrder<D>& order_;
  Push<D> push_;
  CrackPath<D> path_;
  std::optional<Findings<D>> findings_;
  LoadWay<D> way_;
  ArcRecorder<D> recorder_;
  LoadPathOptions<D> how_;
};

/// Follows the path, and then reports it as a stage.
template <int D>
int follow_push(lua_State* L, BuiltModel<D>& m, PushOrder<D>& o) {
  const std::vector<std::string> names = load_names(m.evaluated().model());
  if (std::find(names.begin(), names.end(), o.stage.name) != names.end())
    throw InputError(fmt::format("pushover: there is a load or push '{}'; give another name", o.stage.name));
  const InterruptWatch watch(L, host(L));
  PushPath<D> push(m, o, watch);
  const LoadPath path = push.follow();
  if (path.end == PathEnd::stopped && path.points.empty()) {  // before the first point
    push_report(L, settle_stage(L, m, o.stage, EquilibriumOptions{}));
    return 1;
  }
  if (path.end == PathEnd::no_rest)
    throw NoSolution(
        "pushover: there is no equilibrium to begin from; find it with m:consolidate{ integrator = \"static\" }, which "
        "reports the cause");
  const LoadWay<D>& way = push.take_over(m, path);
  const ArcRecorder<D>& recorder = push.recorder();
  if (has_courses_to_come(m.simulation().model(), m.time()))
    m.note_at_once(fmt::format("{}: motions and loads in progress are suspended for the {:g} s of its load path",
                               o.stage.name, path_duration),
                   host(L));
  EquilibriumOptions rest;
  o.stage.duration = path_duration;
  std::size_t given = 0;  // the stage ends with one more step, at the end of the path
  const StageSamples samples{o.on_sample, [&] { return given < recorder.curve().force.size(); },
                             [&] { push_sample(L, recorder.curve(), given++); }};
  push_report(L, settle_stage(L, m, o.stage, rest, &way, samples));
  note_end(m, o, path, host(L));
  const PushCurve& curve = recorder.curve();
  add_curve(L, curve, curve.peak(), recorder.limit().empty() ? arc_limit(path.end) : recorder.limit());
  add_statics(L, curve.force.empty() ? 0 : curve.force[curve.peak()], true);
  set_limits(L, path), set_happened(L, m, path);
  return 1;
}

}  // namespace

template <int D>
int push_by_arc(lua_State* L, BuiltModel<D>& m, PushOrder<D>& o) {
  return follow_push(L, m, o);
}

template int push_by_arc(lua_State*, BuiltModel<2>&, PushOrder<2>&);
template int push_by_arc(lua_State*, BuiltModel<3>&, PushOrder<3>&);

}  // namespace trilith::script
