// m:consolidate: finds static equilibrium under weight, by explicit steps with damping or by statics.
#include <algorithm>

#include "base/no_solution.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/stages/mass_scaling_stage.hpp"
#include "bindings/stages/stage_reading.hpp"
#include "bindings/stages/stage_run.hpp"
#include "statics/equilibrium.hpp"

namespace trilith::script {
namespace {

/// The given keys for the approach of rest in explicit steps, "'local_damping', 'grow'"; "": none.
std::string explicit_keys(Keys& keys) {
  std::string out;
  for (const char* const key :
       {"local_damping", "grow", "rest", "duration", "dt", "safety", "until_collapse", "until_true"})
    if (keys.has(key)) out += fmt::format("{}'{}'", out.empty() ? "" : ", ", key);
  return out;
}

/// An order of m:consolidate.
struct Consolidation {
  StageOptions stage;
  EquilibriumOptions how;  ///< of statics
  double grow = 0.5;       ///< time in which the weight grows at the start [s]
  bool fresh = false;      ///< mortar sets at the end
  bool or_go_on = false;   ///< the run continues without rest
  bool by_statics = false;
};

void read_statics(Keys& keys, const ScriptModel& m, Consolidation& order) {
  order.by_statics = keys.choice("integrator", {"explicit", "static"}, 0) == 1;
  EquilibriumOptions& how = order.how;
  how.within = keys.number("within", "1", usual_travel);
  if (!(how.within > 0))
    keys.problem(fmt::format("'within' is {:g}, must be above 0: a share of each body's size", how.within));
  order.stage.within = static_cast<float>(how.within);
  how.shares = keys.count("shares", how.shares), how.tolerance = keys.number("tolerance", "1", how.tolerance);
  if (!order.by_statics) return refuse(keys, {"shares", "tolerance"}, "static");
  if (order.stage.mass_scaling) keys.problem("mass_scaling is for explicit steps; integrator = \"static\" has none");
  if (m.running()) keys.problem("a stage runs already; integrator = \"static\" is a separate stage");
}

Consolidation read_consolidation(Keys& keys, ScriptModel& m) {
  Consolidation order;
  StageOptions& o = order.stage;
  o.still_ratio = 1e-5;
  o.name = keys.text("name", "consolidation");
  o.duration = keys.number("duration", "s", 60);
  o.rest_share = keys.number("local_damping", "1", 0.8);
  o.until_rest = read_rest_table(keys, o) || !keys.has("rest");
  if (!o.until_rest) keys.problem("'rest' is false; give its limits, or use run for a stage that need not end at rest");
  read_step(keys, o);
  read_scaling(keys, m, o);
  order.grow = keys.number("grow", "s", order.grow);
  if (!(order.grow >= 0)) keys.problem(fmt::format("'grow' is {:g} s, must not be below 0", order.grow));
  order.fresh = keys.flag("fresh", false), order.or_go_on = keys.flag("or_go_on", false);
  o.must_rest = !order.or_go_on;
  read_statics(keys, m, order);
  return order;
}

/// Throws NoSolution if the stage did not come to rest. An explicit stage beyond strain_limit still moves, and its
/// verdict reports it; statics was requested to find rest.
void require_rest(const Consolidation& order, const StageReport& report) {
  const StageOptions& o = order.stage;
  if (report.end == StageEnd::not_at_rest)
    throw NoSolution(fmt::format("{} did not come to rest{}: {}; or_go_on = true continues anyway", o.name,
                                 order.by_statics ? "" : fmt::format(" in {:g} s", o.duration), report.reason));
  if (order.by_statics && report.end == StageEnd::unstable)
    throw NoSolution(fmt::format(
        "{} did not come to rest: {}; integrator = \"explicit\" shows how it moves, or_go_on = true continues anyway",
        o.name, report.reason));
  if (order.by_statics && report.end == StageEnd::diverged)
    throw NoSolution(fmt::format("{} did not come to rest: {}", o.name, report.reason));
}

/// Notes keys that statics ignores, and a stage that continues without rest.
void note_consolidation(lua_State* L, ScriptModel& m, const std::string& name, const std::string& unused,
                        const StageReport& report) {
  const auto note = [&](const std::string& said) {
    m.note(said);
    if (host(L).observer != nullptr) host(L).observer->note(said);
  };
  if (!unused.empty()) note(fmt::format("{}: statics has no time steps, so it ignores {}", name, unused));
  if (report.end == StageEnd::not_at_rest) {
    // The line of the stage's end gives the reason in the terminal.
    const std::string said = fmt::format("{} did not come to rest, but the run continues", name);
    m.note(said + ": " + report.reason);
    if (host(L).observer != nullptr) host(L).observer->note(said);
  }
  if (report.end != StageEnd::unstable) return;
  const std::string said = fmt::format("{}: {}", name, report.reason);
  m.note(said), tell_note(L, m, said);  // in the file, and in m.notes
}

}  // namespace

int push_consolidation(lua_State* L) {
  ScriptModel& m = this_model(L);
  read_nothing_for_nil(L);
  Keys keys(L, 2, "consolidate");
  Consolidation order = read_consolidation(keys, m);
  StageOptions& o = order.stage;
  const std::string unused = order.by_statics ? explicit_keys(keys) : "";
  const StageUntil until = read_until(keys, m);
  keys.finish();
  if (order.fresh && m.running())
    throw InputError("consolidate: a stage runs already; mortar cannot be fresh within it");
  m.build();
  if (!order.by_statics && m.time() == 0) {
    o.still_from = std::max(o.still_from, order.grow);
    m.grow_weight(order.grow);
  }
  if (order.fresh) m.lift_bonds();
  const StageReport report = order.by_statics ? settle_stage(L, m, o, order.how) : run_stage(L, m, o, until);
  tell_scaling(L, m, report);
  if (!order.or_go_on) require_rest(order, report);
  note_consolidation(L, m, o.name, unused, report);
  if (order.fresh && report.end != StageEnd::diverged) m.set_bonds();
  push_report(L, report);
  return 1;
}

}  // namespace trilith::script
