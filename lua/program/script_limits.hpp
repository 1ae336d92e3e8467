// What a script may use up: memory that Lua holds, time between two calls into the engine.
#pragma once

#include <string>

#include "bindings/core/lua_api.hpp"

namespace trilith::program {

/// Lua code of `L` can hold so many bytes; 0: no limit. One state of a program has one at a time.
void limit_memory(lua_State* L, double bytes);
/// What was refused last, with the script's line; "" where nothing was.
std::string memory_refusal();

/// Lua code of this thread can run so long [s] without a call into the engine or back, while an InterruptScope lives;
/// 0: no limit. An error that no script can catch says where it was.
void limit_time(double seconds);

}  // namespace trilith::program
