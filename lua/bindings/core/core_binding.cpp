// Engine functions for the library in lua/lib: clocks, event names, messages. Not for scripts.
#include <algorithm>
#include <cmath>

#include "bindings/core/bindings.hpp"
#include "bindings/core/unit_door.hpp"
#include "bindings/model/model_binding.hpp"
#include "model/event/event_list.hpp"

namespace trilith::script {
namespace {

ScriptModel& model_at(lua_State* L) {
  return handle<ModelBox>(L, 1).get();
}

/// core.fail(text): an input error at the user's line.
int fail(lua_State* L) {
  throw InputError(lua_type(L, 1) == LUA_TSTRING ? text_at(L, 1) : "something is wrong");
}

/// core.what_is(value): description of a value for messages.
int what_it_is(lua_State* L) {
  lua_settop(L, 1);
  const std::string text = what_is(L, 1);
  lua_pushlstring(L, text.data(), text.size());
  return 1;
}

std::vector<std::string> event_names() {
  std::vector<std::string> names;
  for (const EventTypeInfo& e : event_type_info) names.emplace_back(e.name);
  return names;
}

/// core.listen(model, name, owner): passes such events to the library from now on. "*": all events.
int listen(lua_State* L) {
  ScriptModel& m = model_at(L);
  const std::string owner = lua_type(L, 3) == LUA_TSTRING ? text_at(L, 3) : "on";
  if (lua_type(L, 2) != LUA_TSTRING)
    throw InputError(
        fmt::format("{}: {} is not an event; give a name such as \"bearing.failed\", or \"*\"", owner, what_is(L, 2)));
  const std::string name = text_at(L, 2);
  const std::vector<std::string> names = event_names();
  const auto it = std::find(names.begin(), names.end(), name);
  if (name != "*" && it == names.end())
    throw InputError(fmt::format("{}: there is no event '{}'{}", owner, name, name_hint(name, names)));
  m.wanted_events |= name == "*" ? ~0U : 1U << static_cast<unsigned>(it - names.begin());
  return 0;
}

/// Shortest interval of a clock [s]: the number of its ticks is counted.
constexpr double shortest_interval = 1e-9;

/// core.timer(model, interval): index of a new clock.
int timer(lua_State* L) {
  ScriptModel& m = model_at(L);
  if (lua_type(L, 2) != LUA_TNUMBER || !(lua_tonumber(L, 2) > 0) || !std::isfinite(lua_tonumber(L, 2)))
    throw InputError(fmt::format("every: the interval is {}, must be a number of seconds above 0", what_is(L, 2)));
  if (lua_tonumber(L, 2) < shortest_interval)
    throw InputError(
        fmt::format("every: the interval is {:g} s, must be at least {:g} s", lua_tonumber(L, 2), shortest_interval));
  m.timers.push_back({m.time(), lua_tonumber(L, 2), 1});
  lua_pushinteger(L, static_cast<lua_Integer>(m.timers.size()));
  return 1;
}

/// core.wake(model, time): calls the library's wake function at that time.
int wake(lua_State* L) {
  ScriptModel& m = model_at(L);
  m.wake_at = std::min(m.wake_at, lua_tonumber(L, 2));
  return 0;
}

/// core.step_handler(model, there)
int step_handler(lua_State* L) {
  model_at(L).has_step_handler = lua_toboolean(L, 2) != 0;
  return 0;
}

/// core.effect(model): a lasting change, which a resumed run repeats.
int effect(lua_State* L) {
  ++model_at(L).effects;
  return 0;
}
/// core.keeps(model): the script has called m:keep.
int keeps(lua_State* L) {
  model_at(L).keeps_tables = true;
  return 0;
}

/// core.own(model): the model's own table.
int own(lua_State* L) {
  push_own_table(L, 1);
  return 1;
}

int named_row(lua_State* L, const std::vector<std::string>& names, const char* kind) {
  if (lua_isinteger(L, 2) != 0) {
    const lua_Integer i = lua_tointeger(L, 2);
    return i >= 1 && i <= static_cast<lua_Integer>(names.size()) ? static_cast<int>(i) - 1 : -1;
  }
  const std::string name = lua_type(L, 2) == LUA_TSTRING ? text_at(L, 2) : what_is(L, 2);
  const auto it = std::find(names.begin(), names.end(), name);
  if (it == names.end()) throw InputError(fmt::format("there is no {} '{}'{}", kind, name, name_hint(name, names)));
  return static_cast<int>(it - names.begin());
}

/// core.bearing(model, name or number), core.seat: nil past the last number.
int bearing(lua_State* L) {
  const int row = named_row(L, model_at(L).bearings, "bearing");
  if (row < 0) return 0;
  push_bearing(L, 1, row);
  return 1;
}
int seat(lua_State* L) {
  const int row = named_row(L, model_at(L).seats, "seat");
  if (row < 0) return 0;
  push_seat(L, 1, row);
  return 1;
}
/// core.storey(model, number): nil if there is no such storey.
int storey(lua_State* L) {
  if (lua_isinteger(L, 2) == 0)
    throw InputError(fmt::format("storeys are indexed by number; this is {}", what_is(L, 2)));
  const lua_Integer number = lua_tointeger(L, 2);
  if (number < 1 || number > storey_count(model_at(L))) return 0;
  push_storey(L, 1, static_cast<int>(number) - 1);
  return 1;
}
int storeys(lua_State* L) {
  lua_pushinteger(L, storey_count(model_at(L)));
  return 1;
}
int bearing_count(lua_State* L) {
  lua_pushinteger(L, static_cast<lua_Integer>(model_at(L).bearings.size()));
  return 1;
}
int seat_count(lua_State* L) {
  lua_pushinteger(L, static_cast<lua_Integer>(model_at(L).seats.size()));
  return 1;
}

/// core.traced(thread, message): the message with the thread's traceback, marked as complete; an error object is
/// returned unchanged.
int traced(lua_State* L) {
  lua_settop(L, 2);
  if (lua_tothread(L, 1) == nullptr) throw InputError("traced: takes a thread and a message");
  add_thread_traceback(L, lua_tothread(L, 1));
  return 1;
}

/// core.name_of(model, kind, thing, owner): the name of a body, bearing or seat of the model, which is given as a
/// handle or by name. An unknown name is an error after the model is built; before, it may still be added.
int name_of(lua_State* L) {
  const ScriptModel& m = model_at(L);
  const std::string kind = text_at(L, 2), owner = text_at(L, 4);
  if (lua_type(L, 3) == LUA_TSTRING && !m.built()) {
    lua_settop(L, 3);
    return 1;
  }
  std::string name;
  if (kind == Kind<BearingHandle>::name)
    name = m.bearings[static_cast<std::size_t>(row_at<BearingHandle>(L, 3, m, owner))];
  else if (kind == Kind<SeatHandle>::name)
    name = m.seats[static_cast<std::size_t>(row_at<SeatHandle>(L, 3, m, owner))];
  else
    name = m.body_name(row_at<BodyHandle>(L, 3, m, owner));
  lua_pushlstring(L, name.data(), name.size());
  return 1;
}

/// core.nearest(name, {known}): the hint in messages.
int hint(lua_State* L) {
  std::vector<std::string> known;
  const auto count = lua_type(L, 2) == LUA_TTABLE ? static_cast<lua_Integer>(lua_rawlen(L, 2)) : 0;
  for (lua_Integer i = 1; i <= count; ++i) {
    if (lua_rawgeti(L, 2, i) == LUA_TSTRING) known.emplace_back(text_at(L, -1));
    lua_pop(L, 1);
  }
  const std::string text = name_hint(lua_type(L, 1) == LUA_TSTRING ? text_at(L, 1) : "", known);
  lua_pushstring(L, text.c_str());
  return 1;
}

/// core.members(kind): the table of a kind's members, to which the library adds methods.
int members(lua_State* L) {
  const std::string key = std::string("trilith.") + (lua_type(L, 1) == LUA_TSTRING ? text_at(L, 1) : "");
  if (luaL_getmetatable(L, key.c_str()) != LUA_TTABLE) throw InputError(fmt::format("there is no kind '{}'", key));
  lua_getfield(L, -1, "members");
  return 1;
}

}  // namespace

void open_core(lua_State* L) {
  register_kind<ModelBox>(L);
  register_kind<BodyHandle>(L);
  register_kind<BodySet>(L);
  register_kind<BearingHandle>(L);
  register_kind<SeatHandle>(L);
  register_kind<HistoryHandle>(L);
  register_kind<StoreyHandle>(L);
  for (const char* kind : {"event", "findings"}) {
    luaL_newmetatable(L, (std::string("trilith.") + kind).c_str());
    lua_setfield(L, -2, kind);
  }
  set_function(L, "model", guarded<make_model>);
  set_function(L, "extruded", guarded<make_extruded>);
  set_function(L, "fail", guarded<fail>);
  set_function(L, "what_is", guarded<what_it_is>);
  set_function(L, "listen", guarded<listen>);
  set_function(L, "timer", guarded<timer>);
  set_function(L, "wake", guarded<wake>);
  set_function(L, "step_handler", guarded<step_handler>);
  set_function(L, "effect", guarded<effect>);
  set_function(L, "keeps", guarded<keeps>);
  set_function(L, "own", guarded<own>);
  set_function(L, "bearing", guarded<bearing>);
  set_function(L, "seat", guarded<seat>);
  set_function(L, "storey", guarded<storey>);
  set_function(L, "storey_count", guarded<storeys>);
  set_function(L, "bearing_count", guarded<bearing_count>);
  set_function(L, "seat_count", guarded<seat_count>);
  set_function(L, "name_of", guarded<name_of>);
  set_function(L, "traced", guarded<traced>);
  set_function(L, "hint", guarded<hint>);
  set_function(L, "members", guarded<members>);
  set_function(L, "unit_door", set_door);
  set_function(L, "raise", raise_whole);
  set_function(L, "dimension", dimension_of_unit);
  set_function(L, "quantities_read", quantities_read);
  set_function(L, "take_units", guarded<take_units>);
  set_function(L, "unit_name", guarded<name_of_unit>);
  set_function(L, "unit_message", guarded<message_in_units>);
  open_declarations(L);
  open_debug(L);
  open_bridge(L);
}

}  // namespace trilith::script
