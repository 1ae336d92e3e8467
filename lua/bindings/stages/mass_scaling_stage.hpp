// Stages with mass scaling: options and report.
#pragma once

#include "bindings/core/handles.hpp"
#include "bindings/core/keys.hpp"

namespace trilith::script {

/// mass_scaling = { step =, most =, bodies = }
void read_scaling(Keys& keys, const ScriptModel& m, StageOptions& o);

/// Prints the result of mass scaling of a stage, if any, and stores it with the results.
void tell_scaling(lua_State* L, ScriptModel& m, const StageReport& report);

}  // namespace trilith::script
