// trilith.study: a table of cases, each run in a separate process; or, if one case is requested, that case in this
// process.
#include <cmath>
#include <fstream>
#include <sstream>

#include "base/no_solution.hpp"
#include "base/units.hpp"
#include "base/whole_file.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/core/interrupt_watch.hpp"
#include "bindings/core/no_solution_error.hpp"
#include "bindings/core/unit_door.hpp"
#include "bindings/readings/figures_reading.hpp"
#include "bindings/study/study_order.hpp"
#include "bindings/study/study_reading.hpp"
#include "run/study/study.hpp"

namespace trilith::script {
namespace {

/// Options of a script's study except its plan.
struct Wanted {
  std::string file, script;
  int jobs = 0;
  bool has_function = false, has_before = false;
  std::optional<StudyRise> rise;
};

std::optional<StudyRise> read_rise(Keys& keys) {
  lua_State* L = keys.lua();
  std::optional<StudyRise> rise;
  if (keys.push("ida") != LUA_TNIL) {
    Keys own(L, lua_gettop(L), "study: 'ida'");
    rise = StudyRise{own.text("over"), own.text("stop")};
    own.finish();
  }
  lua_pop(L, 1);
  return rise;
}

Wanted read_wanted(Keys& keys) {
  Wanted w;
  w.file = keys.text("file");
  w.script = keys.text("script", "");
  w.jobs = keys.count("jobs", 0);
  w.has_function = keys.push("case") == LUA_TFUNCTION;
  if (!w.has_function && !lua_isnil(keys.lua(), -1)) keys.wrong("case", "a function");
  lua_pop(keys.lua(), 1);
  w.has_before = keys.push("before") == LUA_TFUNCTION;
  if (!w.has_before && !lua_isnil(keys.lua(), -1)) keys.wrong("before", "a function");
  lua_pop(keys.lua(), 1);
  w.rise = read_rise(keys);
  if (w.has_before && !w.has_function) keys.problem("'before' needs case = a function, which receives its result");
  if (w.has_function == !w.script.empty())
    keys.problem("give just one of script = a file that runs a case, and case = a function of its parameters");
  return w;
}

/// A number of the script's parameter in `unit` [SI], or in the units of the script if its models have some.
double parameter_number(const Host& h, double number, const std::string& unit) {
  if (unit.empty()) return number;
  const UnitProduct product = parse_unit(unit);
  if (h.units.is_si()) {
    count_quantity();
    return number * product.factor;
  }
  return h.units.shown(number * product.factor, si_unit(product.dimension));
}

/// The parameters of a case as a table; a number whose unit the plan names is in the units of the script's models, or
/// in SI.
void push_parameters(lua_State* L, const Host& h, const StudyPlan& plan, std::size_t index) {
  lua_newtable(L);
  for (std::size_t k = 0; k < plan.names.size(); ++k) {
    const StudyValue& value = plan.cases[index][k];
    if (const auto* number = std::get_if<double>(&value))
      lua_pushnumber(L, parameter_number(h, *number, plan.units[k]));
    else if (const auto* flag = std::get_if<bool>(&value))
      lua_pushboolean(L, *flag ? 1 : 0);
    else
      lua_pushstring(L, std::get<std::string>(value).c_str());
    lua_setfield(L, -2, plan.names[k].c_str());
  }
}

/// Registry key of the result of `before`.
constexpr const char* state_key = "trilith.study.state";

/// Calls `before` of the study and stores its result.
void make_state(lua_State* L) {
  lua_getfield(L, 1, "before");
  call(L, 0, 1);
  lua_setfield(L, LUA_REGISTRYINDEX, state_key);
}

/// Calls the case's function with its parameters and the result of `before`; stores its figures.
void call_case(lua_State* L, Host& h, const StudyPlan& plan, std::size_t index) {
  lua_getfield(L, 1, "case");
  push_parameters(L, h, plan, index);
  lua_getfield(L, LUA_REGISTRYINDEX, state_key);
  for (std::size_t k = 0; k < plan.names.size(); ++k)
    h.parameters.push_back({plan.names[k], text_of(plan.cases[index][k]), plan.units[k], "", "of the study"});
  call(L, 2, 1);
  h.figures = figures_at(L, -1);
}

/// Runs a case in this forked process: results and figures are written to `folder`. Returns the exit code.
int run_parted_case(lua_State* L, Host& h, const StudyPlan& plan, std::size_t index,
                    const std::filesystem::path& folder) {
  h.case_folder = folder;
  h.observer = nullptr;
  try {
    call_case(L, h, plan, index);
  } catch (const std::exception& e) {
    h.finish(e.what());
    fmt::print(stderr, "{}\n", e.what());
    const bool has_none = dynamic_cast<const NoSolution*>(&e) != nullptr || is_no_solution(L, e.what());
    return has_none || !h.untrusted_runs().empty() ? 3 : 1;
  }
  h.finish("");
  write_whole_file(folder / figures_file, figures_text(h.figures));
  for (const std::string& line : h.untrusted_runs()) fmt::print(stderr, "{}\n", line);
  return h.untrusted_runs().empty() ? 0 : 3;
}

/// Runs one case in this process: its function, with its parameters.
void run_case(lua_State* L, Host& h, const StudyPlan& plan, const Wanted& wanted) {
  const auto only = static_cast<std::size_t>(h.study.only);
  if (only > plan.cases.size())
    throw InputError(fmt::format("study: there is no case {}; there are {}", only, plan.cases.size()));
  if (!wanted.has_function) throw InputError("study: its cases are separate runs of a script; see --list");
  if (wanted.has_before) make_state(L);
  call_case(L, h, plan, only - 1);
  throw InputError(script_is_done);
}

void push_value(lua_State* L, const StudyValue& value) {
  if (const auto* number = std::get_if<double>(&value))
    lua_pushnumber(L, *number);
  else if (const auto* flag = std::get_if<bool>(&value))
    lua_pushboolean(L, *flag ? 1 : 0);
  else
    lua_pushstring(L, std::get<std::string>(value).c_str());
}

void push_outcome(lua_State* L, const StudyPlan& plan, std::size_t index, const StudyOutcome& o) {
  lua_newtable(L);
  lua_pushinteger(L, static_cast<lua_Integer>(index) + 1);
  lua_setfield(L, -2, "case");
  for (std::size_t k = 0; k < plan.names.size(); ++k) {
    push_value(L, plan.cases[index][k]);
    lua_setfield(L, -2, plan.names[k].c_str());
  }
  for (const StudyFigure& f : o.figures) {
    if (const auto* number = std::get_if<double>(&f.value))
      lua_pushnumber(L, *number);
    else if (const auto* flag = std::get_if<bool>(&f.value))
      lua_pushboolean(L, *flag ? 1 : 0);
    else
      lua_pushstring(L, std::get<std::string>(f.value).c_str());
    lua_setfield(L, -2, f.name.c_str());
  }
  lua_pushstring(L, name_of(o.status));
  lua_setfield(L, -2, "status");
  lua_pushinteger(L, o.exit);
  lua_setfield(L, -2, "exit");
  lua_pushnumber(L, o.seconds);
  lua_setfield(L, -2, "seconds");
  lua_pushstring(L, o.message.c_str());
  lua_setfield(L, -2, "message");
  lua_pushstring(L, o.folder.string().c_str());
  lua_setfield(L, -2, "folder");
}

/// { file =, rows = {...}, finished =, failed = }
void push_study(lua_State* L, const StudyOrder& order, const std::vector<StudyOutcome>& outcomes) {
  lua_newtable(L);
  lua_pushstring(L, order.file.string().c_str());
  lua_setfield(L, -2, "file");
  lua_newtable(L);
  std::array<lua_Integer, 4> count{};
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    ++count[static_cast<std::size_t>(outcomes[i].status)];
    push_outcome(L, order.plan, i, outcomes[i]);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  lua_setfield(L, -2, "rows");
  lua_pushinteger(L, count[static_cast<std::size_t>(StudyStatus::finished)]);
  lua_setfield(L, -2, "finished");
  lua_pushinteger(L, count[static_cast<std::size_t>(StudyStatus::failed)]);
  lua_setfield(L, -2, "failed");
  lua_pushinteger(L, count[static_cast<std::size_t>(StudyStatus::passed_over)]);
  lua_setfield(L, -2, "passed_over");
}

StudyOrder order_of(Host& h, StudyPlan plan, const Wanted& wanted) {
  CasesOfScript cases;
  cases.program = h.study.program;
  cases.script = wanted.has_function ? std::filesystem::path(h.script) : h.folder() / wanted.script;
  if (wanted.has_function) cases.fixed = h.arguments;
  cases.by_number = wanted.has_function;
  cases.checkpoint = h.study.checkpoint;
  cases.trust = !h.room.closed();
  cases.memory = h.script_memory == default_script_memory ? 0 : h.script_memory;
  cases.seconds = h.script_seconds == default_script_seconds ? 0 : h.script_seconds;
  if (!wanted.has_function) static_cast<void>(h.room.readable(cases.script, "study: script"));
  static_cast<void>(h.room.writable(wanted.file, "study: file"));
  cases.folders = h.room.folders();
  StudyOrder order = study_order(std::move(plan), cases);
  order.file = wanted.file;
  order.jobs = wanted.jobs;
  order.provenance.command_line = h.command_line;
  order.rise = wanted.rise;
  take_choice(h.study, order);
  return order;
}

/// Rejects links in the folder of a case that lead elsewhere.
void require_own_folders(const Host& h, const StudyOrder& order) {
  if (!h.room.closed() || order.plan.cases.empty()) return;
  static_cast<void>(h.room.writable(case_folder(order, 0).parent_path() / "lock", "study"));
  for (std::size_t i = 0; i < order.plan.cases.size(); ++i)
    for (const char* name : {"log.txt", "errors.txt"})
      static_cast<void>(h.room.writable(case_folder(order, i) / name, "study"));
}

void require_place(Host& h) {
  if (h.list_parameters) throw InputError(parameters_listed);
  if (h.study.begun) throw InputError("study: called a second time; a script has one study");
  h.study.begun = true;
  if (h.study.only == 0 && h.study.program.empty())
    throw InputError("study: only the program can begin one: trilith study SCRIPT");
  if (h.study.only == 0 && !h.case_folder.empty()) throw InputError("study: a case of a study cannot begin another");
}

/// trilith.study{ file =, parameters = | cases = | samples =, script = | case =, histories =, jobs = }
int study(lua_State* L) {
  Host& h = host(L);
  lua_settop(L, 1);
  require_place(h);
  Keys keys(L, 1, "study");
  const Wanted wanted = read_wanted(keys);
  StudyPlan plan = read_plan(keys);
  std::vector<StudyHistory> histories = read_histories(keys);
  keys.finish();
  if (h.study.only > 0) run_case(L, h, plan, wanted);
  StudyOrder order = order_of(h, std::move(plan), wanted);
  order.histories = std::move(histories);
  require_own_folders(h, order);
  if (h.study.list) {
    list_cases(order);
    throw InputError(script_is_done);
  }
  if (wanted.has_before) {
    h.threads = 1;  // a forked process does not inherit threads
    order.prepare = [L] { make_state(L); };
    order.run_here = [L, &h, &order](std::size_t i, const std::filesystem::path& folder) {
      return run_parted_case(L, h, order.plan, i, folder);
    };
  }
  const InterruptWatch interrupt(L, h);
  StudyWatch watch;
  watch.line = [&h](const std::string& text, bool strong) { h.observer->line(text, strong); };
  watch.status = [&h](const std::string& text) { h.observer->status(text); };
  watch.goes_on = [&interrupt] { return !interrupt.pressed(); };
  const std::vector<StudyOutcome> outcomes = run_study(order, watch);
  h.study.failed = any_failed(outcomes);
  if (!order.only.empty())
    throw InputError(script_is_done);  // the rest of the script, which uses all cases, does not
                                       // belong to a task
  push_study(L, order, outcomes);
  return 1;
}

}  // namespace

void open_study(lua_State* L) {
  set_function(L, "study", guarded<study>);
}

}  // namespace trilith::script
