// Lua errors that came from a NoSolution (base/no_solution.hpp).
#pragma once

#include <string>

#include "bindings/core/lua_api.hpp"

namespace trilith::script {

/// True of the message of such an error, also where a script has added text to it.
bool is_no_solution(lua_State* L, const std::string& message);

}  // namespace trilith::script
