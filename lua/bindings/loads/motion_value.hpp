// Pushes a ground motion on the stack of Lua.
#pragma once
#include "bindings/core/bindings.hpp"

namespace trilith::script {

/// Pushes `motion` as a value of a script; `steady` is a motion that may end with a displacement or a velocity, which
/// no check of drift shall refuse.
void push_motion(lua_State* L, GroundMotion motion, bool steady);

}  // namespace trilith::script
