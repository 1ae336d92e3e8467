// The closed room of a script: which parts of Lua's own libraries it has.
#pragma once

#include "bindings/core/host.hpp"
#include "bindings/core/lua_api.hpp"

namespace trilith::program {

/// Takes from the globals of `L` what reaches out of the room, and puts functions in the place of the rest that ask
/// `host.room`. May raise a Lua error. The library keeps its own globals, see keep_library_environment.
void close_room(lua_State* L, script::Host& host);

}  // namespace trilith::program
