// Inspection of a model: single steps, checkpoints and rewinding, its worst body, differences between two branches.
#include <algorithm>
#include <chrono>
#include <cmath>

#include "assembly/contact/solid_resultants.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/core/table_fields.hpp"
#include "bindings/loads/small_peak.hpp"
#include "bindings/stages/stage_run.hpp"
#include "run/record/body_forces.hpp"

namespace trilith::script {
namespace {

/// m:step(n): takes n further steps, of the paused stage, or of a separate one.
int step(lua_State* L) {
  ScriptModel& m = this_model(L);
  const lua_Integer n = lua_isnoneornil(L, 2) ? 1 : lua_tointeger(L, 2);
  if (n < 1 || (!lua_isnoneornil(L, 2) && lua_isinteger(L, 2) == 0))
    throw InputError(fmt::format("step: takes a number of steps, at least 1; this is {}", what_is(L, 2)));
  lua_settop(L, 1);
  if (m.paused()) {
    run_on(L, m, {n, unbounded, {}});
    return 0;
  }
  StageOptions o;
  o.name = fmt::format("{} step{}", n, n == 1 ? "" : "s");
  o.duration = 1e9;
  push_report(L, run_stage(L, m, o, {.steps = n}));
  return 1;
}

double time_to_go_to(lua_State* L, const ScriptModel& m) {
  if (lua_type(L, 2) == LUA_TNUMBER) {
    const double back = lua_tonumber(L, 2);
    if (!(back >= 0)) throw InputError(fmt::format("rewind: the time to go back is {:g} s, must not be below 0", back));
    return m.time() - back;
  }
  Keys keys(L, 2, "rewind");
  const double to = keys.number("to", "s");
  keys.finish();
  return to;
}

/// m:rewind(seconds) or m:rewind{ to = time }: returns the time after rewinding.
int rewind(lua_State* L) {
  ScriptModel& m = this_model(L);
  const double left = m.time();
  const double to = m.rewind(time_to_go_to(L, m), host(L));
  if (RunObserver* observer = host(L).observer)
    observer->note(fmt::format("back at {:.6g} s, {:.6g} s before {:.6g} s{}", to, left - to, left,
                               m.paused() ? "" : "; m:continue() continues the stage"));
  lua_pushnumber(L, to);
  return 1;
}

std::string checkpoints_text(const Checkpoints& c) {
  const std::string limits =
      fmt::format("one every {:g} s, at most {} in {:.4g} MB", c.options.every, c.options.count, c.options.bytes / 1e6);
  if (!c.on) return "no checkpoints are taken";
  if (c.list().empty()) return "no checkpoint yet; " + limits;
  return fmt::format("{} checkpoints from {:.4f} s to {:.4f} s, {:.3g} MB; {}", c.list().size(),
                     c.list().front().time(), c.list().back().time(), static_cast<double>(c.bytes()) / 1e6, limits);
}

/// m:checkpoints{ every =, count =, bytes =, on = }: sets the given options; returns the present ones.
int checkpoints(lua_State* L) {
  ScriptModel& m = this_model(L);
  Checkpoints& c = m.checkpoints;
  lua_settop(L, 2);
  if (!lua_isnil(L, 2)) {
    Keys keys(L, 2, "checkpoints");
    CheckpointOptions o = c.options;
    o.every = keys.number("every", "s", o.every);
    o.count = keys.count("count", o.count);
    o.bytes = keys.number("bytes", "bytes", o.bytes);
    const bool on = keys.flag("on", true);
    if (!(o.every >= 0)) keys.problem(fmt::format("'every' is {:g} s, must not be below 0", o.every));
    if (o.count < 1) keys.problem(fmt::format("'count' is {}, must be at least 1", o.count));
    if (!(o.bytes > 0)) keys.problem(fmt::format("'bytes' is {:g}, must be above 0", o.bytes));
    keys.finish();
    c.options = o;
    c.on = on;
    c.drop_oldest();
    m.checkpoints_chosen = true;
  }
  lua_createtable(L, 0, 5);
  lua_pushinteger(L, static_cast<lua_Integer>(c.list().size()));
  lua_setfield(L, -2, "count");
  lua_pushinteger(L, static_cast<lua_Integer>(c.bytes()));
  lua_setfield(L, -2, "bytes");
  if (!c.list().empty()) {
    set_number(L, "first", c.list().front().time());
    set_number(L, "last", c.list().back().time());
  }
  set_text(L, "text", checkpoints_text(c));
  luaL_setmetatable(L, "trilith.findings");
  return 1;
}

/// core.pause(model, why): pauses the run at the next step border. False if there is no console.
int pause(lua_State* L) {
  ScriptModel& m = this_model(L);
  m.pause_reason = lua_type(L, 2) == LUA_TSTRING ? text_at(L, 2) : "asked for";
  const bool can = host(L).console != nullptr;
  if (!can) {
    if (host(L).observer != nullptr) host(L).observer->note("no console to pause at: " + m.pause_reason);
    m.pause_reason.clear();
  }
  lua_pushboolean(L, can ? 1 : 0);
  return 1;
}

/// core.paused(model)
int paused(lua_State* L) {
  lua_pushboolean(L, this_model(L).paused() ? 1 : 0);
  return 1;
}

/// core.pause_reason(model): reason of a pause during a console command, returned once; "" without a pause.
int pause_reason(lua_State* L) {
  ScriptModel& m = this_model(L);
  const std::string why = std::exchange(m.pause_reason, "");
  lua_pushlstring(L, why.data(), why.size());
  return 1;
}

/// core.resume(model): continues the stage that rewind has restored.
int resume(lua_State* L) {
  lua_settop(L, 1);
  push_report(L, resume_stage(L, this_model(L)));
  return 1;
}

/// core.save(model, path): writes the present instant, for trilith -i --from.
int save(lua_State* L) {
  if (lua_type(L, 2) != LUA_TSTRING) throw InputError("save: takes the name of a file, as in save \"shake.instant\"");
  const std::string path = text_at(L, 2);
  lua_settop(L, 1);
  save_instant(L, this_model(L), path);
  return 0;
}

/// core.note(model, text): adds a note to the results file.
int note(lua_State* L) {
  this_model(L).note(lua_type(L, 2) == LUA_TSTRING ? text_at(L, 2) : "");
  return 0;
}

/// core.note_input(model, text): a note on the input of a function, told at once.
int note_input(lua_State* L) {
  this_model(L).note_at_once(text_at(L, 2), host(L));
  return 0;
}

/// core.records(model): true if results or histories were requested.
int records(lua_State* L) {
  const ScriptModel& m = this_model(L);
  lua_pushboolean(L, m.results || !m.histories.empty() || !host(L).results_file.empty() ? 1 : 0);
  return 1;
}

/// core.has_console()
int has_console(lua_State* L) {
  lua_pushboolean(L, host(L).console != nullptr ? 1 : 0);
  return 1;
}

/// core.open_console(why): opens the console at this place in Lua code.
int open_console(lua_State* L) {
  const std::string why = lua_type(L, 1) == LUA_TSTRING ? text_at(L, 1) : "";
  if (host(L).console == nullptr) return 0;
  lua_pushnil(L);
  host(L).console->open(L, why);
  return 0;
}

/// The function of upvalue 1, timed in row upvalue 2 of the profile. It contains no object with a destructor, because
/// errors pass through it.
int call_timed(lua_State* L) {
  const auto begun = std::chrono::steady_clock::now();
  const int given = lua_gettop(L);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, given, LUA_MULTRET);
  auto* h = static_cast<Host*>(lua_touserdata(L, lua_upvalueindex(3)));
  CallbackTime& row = h->profile.callbacks[static_cast<std::size_t>(lua_tointeger(L, lua_upvalueindex(2)))];
  ++row.calls;
  row.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  return lua_gettop(L);
}

/// `core.timed(f, what, written)`: f itself; with a profile, a function that adds its run time under that name and the
/// place of `written`, the function of the script that f may wrap.
int timed(lua_State* L) {
  Host& h = host(L);
  lua_settop(L, 3);
  if (!h.profile.wanted || lua_type(L, 1) != LUA_TFUNCTION) {
    lua_settop(L, 1);
    return 1;
  }
  lua_Debug info;
  lua_pushvalue(L, lua_type(L, 3) == LUA_TFUNCTION ? 3 : 1);
  lua_getinfo(L, ">S", &info);
  h.profile.callbacks.push_back({fmt::format("{} at {}:{}", text_at(L, 2), info.short_src, info.linedefined), 0, 0});
  lua_settop(L, 1);
  lua_pushinteger(L, static_cast<lua_Integer>(h.profile.callbacks.size()) - 1);
  lua_pushlightuserdata(L, &h);
  lua_pushcclosure(L, call_timed, 3);
  return 1;
}

/// "\n  on b3: sticking, normal 12 N, shear 3 N".
std::string contact_text(const std::string& other, ContactHold hold, double normal, double shear) {
  constexpr std::array holds{"bonded", "sticking", "sliding"};
  return fmt::format("\n  on {}: {}, normal {:.4g} N, shear {:.4g} N", other, holds[static_cast<std::size_t>(hold)],
                     normal, shear);
}

std::string contacts_text(const Simulation<2>& s, int body) {
  std::vector<TouchingContact> touching;
  contact_resultants(s.model(), s.state(), s.work(), touching);
  std::string text;
  for (const TouchingContact& c : touching)
    if (c.body_a == body || c.body_b == body)
      text += contact_text(s.model().bodies[c.body_a == body ? c.body_b : c.body_a].name, c.hold, c.resultant.normal,
                           c.resultant.shear);
  return text.empty() ? "\n  it has no contacts" : text;
}
std::string contacts_text(const Simulation<3>& s, int body) {
  std::string text;
  for (std::size_t i = 0; i < s.work().general_touching.size(); ++i) {
    const SolidResultant c = solid_resultant(s.model(), s.state(), s.work(), i);
    if (c.body_a != body && c.body_b != body) continue;
    const double normal = c.normal.dot(c.force);
    text += contact_text(s.model().bodies[c.body_a == body ? c.body_b : c.body_a].name, c.hold, normal,
                         (c.force - normal * c.normal).norm());
  }
  return text.empty() ? "\n  it has no contacts" : text;
}

template <int D>
void push_worst_of(lua_State* L, const Simulation<D>& s) {
  const WorstBodies worst = worst_bodies(s.model(), s.work());
  lua_createtable(L, 0, 4);
  luaL_setmetatable(L, "trilith.findings");
  if (worst.unbalanced < 0) {
    set_text(L, "text", "no body moves");
    return;
  }
  const double ratio = s.work().carried > 0 ? worst.force / s.work().carried : 0;
  push_body(L, 1, worst.unbalanced);
  lua_setfield(L, -2, "body");
  set_number(L, "force", worst.force);
  set_number(L, "ratio", ratio);
  set_text(L, "text",
           fmt::format("{}: {:.4g} N unbalanced, {:.3g} of the largest force carried",
                       s.model().bodies[worst.unbalanced].name, worst.force, ratio) +
               contacts_text(s, worst.unbalanced));
}

void push_worst(lua_State* L, const ModelBox& box) {
  if (SpaceModel* space = as_space(box.get()))
    push_worst_of(L, space->evaluated());
  else
    push_worst_of(L, box.plane().evaluated());
}

const std::array debug_property_list{
    Property<ModelBox>{"worst", "", "body with the largest unbalanced force, and its contacts", nullptr, push_worst},
};

const std::array debug_method_list{
    Method{"step", guarded<step>},
    Method{"rewind", guarded<rewind>},
    Method{"checkpoints", guarded<checkpoints>},
};

}  // namespace

std::span<const Property<ModelBox>> debug_properties() {
  return debug_property_list;
}
std::span<const Method> debug_methods() {
  return debug_method_list;
}

void open_debug(lua_State* L) {
  set_function(L, "pause", guarded<pause>);
  set_function(L, "paused", guarded<paused>);
  set_function(L, "pause_reason", guarded<pause_reason>);
  set_function(L, "resume", guarded<resume>);
  set_function(L, "note", guarded<note>);
  set_function(L, "note_input", guarded<note_input>);
  set_function(L, "note_small_peak", guarded<note_small_peak>);
  set_function(L, "save", guarded<save>);
  set_function(L, "records", guarded<records>);
  set_function(L, "timed", guarded<timed>);
  set_function(L, "has_console", guarded<has_console>);
  set_function(L, "open_console", guarded<open_console>);
  open_compare(L);
  open_change(L);
  open_modes(L);
  open_lint(L);
}

}  // namespace trilith::script
