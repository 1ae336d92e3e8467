#include "bindings/core/unit_door.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "base/error.hpp"
#include "base/exact_message.hpp"
#include "base/units.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/core/guard.hpp"

namespace trilith::script {
namespace {

const char door_key = 'd';
constexpr std::array<std::string_view, 3> door_names{"unused", "open", "shut"};
/// True once any Lua state of this thread has used units.
thread_local bool any_door = false;
thread_local lua_Integer quantities = 0;

bool is_library_source(const char* source) {
  return std::string_view(source).starts_with("=trilith/");
}

}  // namespace

UnitDoor unit_door(lua_State* L) {
  if (!any_door) return UnitDoor::unused;
  lua_rawgetp(L, LUA_REGISTRYINDEX, &door_key);
  const auto state = static_cast<UnitDoor>(lua_tointeger(L, -1));
  lua_pop(L, 1);
  return state;
}

void set_unit_door(lua_State* L, UnitDoor door) {
  if (door != UnitDoor::unused) any_door = true;
  lua_pushinteger(L, static_cast<lua_Integer>(door));
  lua_rawsetp(L, LUA_REGISTRYINDEX, &door_key);
}

void require_open_door(lua_State* L) {
  if (unit_door(L) != UnitDoor::shut) return;
  lua_Debug self{}, caller{};
  std::string name;
  if (lua_getstack(L, 0, &self) == 1 && lua_getinfo(L, "nt", &self) != 0) {
    if (self.name != nullptr) name = self.name;
    // After a tail call the caller is not on the stack.
    const bool known = self.istailcall == 0 && lua_getstack(L, 1, &caller) == 1;
    if (known && lua_getinfo(L, "S", &caller) != 0 && is_library_source(caller.source)) return;
  }
  throw InputError(fmt::format(
      "{}this function does not convert numbers to the units of the models, because it was taken from trilith "
      "before trilith.model{{ units = }}; call it by its full name",
      name.empty() ? "" : name + ": "));
}

DoorFor::DoorFor(lua_State* L, int index) : L_(L), before_(unit_door(L)) {
  if (before_ == UnitDoor::unused) return;
  lua_Debug about{};
  lua_pushvalue(L, index);
  lua_getinfo(L, ">S", &about);
  set_unit_door(L, is_library_source(about.source) ? UnitDoor::open : UnitDoor::shut);
}

DoorFor::~DoorFor() {
  if (before_ != UnitDoor::unused) set_unit_door(L_, before_);
}

int set_door(lua_State* L) {
  const std::string_view before = door_names[static_cast<std::size_t>(unit_door(L))];
  const std::string wanted = text_at(L, 1);
  for (std::size_t i = 0; i < door_names.size(); ++i)
    if (wanted == door_names[i]) set_unit_door(L, static_cast<UnitDoor>(i));
  lua_pushlstring(L, before.data(), before.size());
  return 1;
}

int raise_whole(lua_State* L) {
  lua_settop(L, 1);
  mark_whole(L);
  return lua_error(L);
}

int take_units(lua_State* L) {
  if (lua_type(L, 1) != LUA_TSTRING)
    throw InputError(fmt::format("model: 'units' is {}, must be {}", what_is(L, 1), system_example));
  Host& h = host(L);
  h.units = UnitSystem(text_at(L, 1), "model");
  if (h.units.is_si()) throw InputError(fmt::format("model: 'units' is empty, must be {}", system_example));
  if (h.observer != nullptr) h.observer->show_in(h.units);
  for (const std::string& name : {h.units.force(), h.units.length()}) {
    lua_pushnumber(L, parse_unit(name).factor);
    lua_pushstring(L, name.c_str());
  }
  return 4;
}

int name_of_unit(lua_State* L) {
  lua_pushstring(L, host(L).units.name(text_at(L, 1)).c_str());
  return 1;
}

int message_in_units(lua_State* L) {
  const std::string unit = lua_type(L, 3) == LUA_TSTRING ? text_at(L, 3) : "";
  const std::array exact{ExactNumber{lua_tonumber(L, 2), unit}};
  const std::string text = exact_message(host(L).units, text_at(L, 1), exact);
  lua_pushlstring(L, text.data(), text.size());
  return 1;
}

void count_quantity() {
  ++quantities;
}

int quantities_read(lua_State* L) {
  lua_pushinteger(L, quantities);
  return 1;
}

int dimension_of_unit(lua_State* L) {
  try {
    const Dimension d = parse_unit(text_at(L, 1)).dimension;
    for (const int exponent : {d.length, d.time, d.mass}) lua_pushinteger(L, exponent);
    return 3;
  } catch (const InputError&) {
    return 0;
  }
}

}  // namespace trilith::script
