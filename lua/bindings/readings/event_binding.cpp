// Events in handlers.
#include <algorithm>
#include <cstdlib>

#include "bindings/core/bindings.hpp"
#include "bindings/core/table_fields.hpp"
#include "model/event/event_list.hpp"

namespace trilith::script {
namespace {

/// The two parts of a body that has cracked, of which the event names the first. Its text ends with the plane.
void set_crack(lua_State* L, int model_index, const Event& e) {
  const std::size_t at = e.text.rfind(' ');
  if (at != std::string::npos) set_integer(L, "plane", std::atoi(e.text.c_str() + at));
  lua_createtable(L, 2, 0);
  for (const int k : {0, 1}) {
    push_body(L, model_index, e.body_b + k);
    lua_rawseti(L, -2, k + 1);
  }
  lua_setfield(L, -2, "parts");
}

void set_bodies(lua_State* L, int model_index, const Event& e) {
  lua_createtable(L, 2, 0);
  int count = 0;
  for (const int body : {e.body_a, e.body_b}) {
    if (body < 0) continue;
    push_body(L, model_index, body);
    lua_rawseti(L, -2, ++count);
  }
  lua_setfield(L, -2, "bodies");
  if (e.body_a < 0) return;
  push_body(L, model_index, e.body_a);
  lua_setfield(L, -2, "body");
}

}  // namespace

void push_event(lua_State* L, int model_index, const Event& e) {
  model_index = lua_absindex(L, model_index);
  lua_checkstack(L, 10);
  const ScriptModel& m = handle<ModelBox>(L, model_index).get();
  lua_createtable(L, 0, 15);
  set_text(L, "type", info_of(e.type).name);
  set_text(L, "severity", name_of(severity_of(e.type)));
  set_number(L, "time", e.time);
  set_integer(L, "id", e.id);
  if (e.cause >= 0) set_integer(L, "cause", e.cause);
  set_integer(L, "step", e.step);
  set_number(L, "value", e.value);
  set_text(L, "value_name", info_of(e.type).value.name);
  set_number(L, "x", e.x);
  set_number(L, "y", e.y);
  if (m.dim() == 3) set_number(L, "z", e.z);
  if (has_trait(e.type, of_joint)) set_text(L, "mode", name_of(e.mode));
  if (e.type == EventType::unit_cracked) set_crack(L, model_index, e);
  set_text(L, "text", m.text_of(e));
  set_bodies(L, model_index, e);
  if (e.bearing >= 0) {
    push_bearing(L, model_index, e.bearing);
    lua_setfield(L, -2, "bearing");
  }
  const auto seat = e.type == EventType::seat_lost ? std::find(m.seats.begin(), m.seats.end(), e.text) : m.seats.end();
  if (seat != m.seats.end()) {
    push_seat(L, model_index, static_cast<int>(seat - m.seats.begin()));
    lua_setfield(L, -2, "seat");
  }
  luaL_setmetatable(L, "trilith.event");
}

}  // namespace trilith::script
