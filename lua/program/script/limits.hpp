// Limits of a script: Lua memory, and time between two calls into the engine.
#pragma once

#include <string>

#include "bindings/core/lua_api.hpp"

namespace trilith::program {

/// Lua code of `L` can hold this number of bytes; 0: no limit. Only one state of a program has a limit at a time.
void limit_memory(lua_State* L, double bytes);
/// The last rejected request, with the script's line; "" if there was none.
std::string memory_refusal();

/// Lua code of this thread can run for this time [s] without a stage, a handler or a long call of the engine, while an
/// InterruptScope lives; 0: no limit. An error that no script can catch reports the place.
void limit_time(double seconds);

}  // namespace trilith::program
