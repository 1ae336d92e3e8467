// Stages that scale masses: what they are asked for, and what is told of it.
#pragma once

#include "bindings/core/handles.hpp"
#include "bindings/core/keys.hpp"

namespace trilith::script {

/// mass_scaling = { step =, most =, bodies = }
void read_scaling(Keys& keys, const ScriptModel& m, StageOptions& o);

/// Where a stage scaled masses, what that came to is said, and kept with the results.
void tell_scaling(lua_State* L, ScriptModel& m, const StageReport& report);

}  // namespace trilith::script
