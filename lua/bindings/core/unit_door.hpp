// A door for the units of a script's models. While units are in use, a script cannot call functions that do not convert
// numbers.
//
// lua/lib/model_units.lua replaces each function of the module by one that converts arguments and results. It opens the
// door around the call. Another call, such as of a function that the script has stored before, gets an error.
#pragma once

#include <string>

#include "bindings/core/lua_api.hpp"

namespace trilith::script {

/// State of the door of a Lua state.
enum class UnitDoor { unused, open, shut };

/// The present state. Until units are set in this thread it costs one comparison.
UnitDoor unit_door(lua_State* L);
void set_unit_door(lua_State* L, UnitDoor door);

/// Throws InputError where the door is shut and the running C function was not called by the built-in library.
void require_open_door(lua_State* L);

/// During its lifetime the door is open for a function of the built-in library at `index`, and shut for another one.
class DoorFor {
 public:
  DoorFor(lua_State* L, int index);
  DoorFor(const DoorFor&) = delete;
  DoorFor& operator=(const DoorFor&) = delete;
  ~DoorFor();

 private:
  lua_State* L_;
  UnitDoor before_;
};

/// core.unit_door(state): sets "unused", "open" or "shut", and returns the state before.
int set_door(lua_State* L);
/// core.raise(text): an error whose text is complete.
int raise_whole(lua_State* L);
/// core.dimension(unit): exponents of length, time and mass of a unit; nothing for an unknown unit.
int dimension_of_unit(lua_State* L);

/// core.take_units(text): the units of the script from now on; returns SI value and name of its units of force and of
/// length.
int take_units(lua_State* L);
/// core.unit_name(unit): the unit of the script for a quantity in this SI unit.
int name_of_unit(lua_State* L);
/// core.unit_message(text, value, unit): the text with its numbers in the units of the script. `value`, in an SI unit,
/// is the exact number that the text gives rounded; both may be left out.
int message_in_units(lua_State* L);

/// A number with a unit or a point was read from a script, or the factor of a unit was given to it.
void count_quantity();
/// core.quantities_read(): how many this thread has read.
int quantities_read(lua_State* L);

}  // namespace trilith::script
