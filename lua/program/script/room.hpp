// The sandbox of a script: available parts of Lua's own libraries.
#pragma once

#include "bindings/core/host.hpp"
#include "bindings/core/lua_api.hpp"

namespace trilith::program {

/// Removes access to the outside of the room from the globals of `L`, and replaces the remaining functions by versions
/// that check `host.room`. May raise a Lua error. The library keeps its own globals, see keep_library_environment.
void close_room(lua_State* L, script::Host& host);

}  // namespace trilith::program
