// Runs a stage of a model with the script's handlers listening.
#pragma once

#include "handles.hpp"

namespace trilith::script {

/// Runs a stage of the model at stack index 1. Handlers are called through the model's own table: dispatch(event),
/// tick(index), wake(), stepped(), sample(index). What they raise ends the stage and is thrown as ScriptError.
/// `steps`: it is stopped after so many; 0: it is not.
StageReport run_stage(lua_State* L, ScriptModel& model, const StageOptions& options, std::int64_t steps = 0);

/// The same of a stage of statics, which takes no time.
StageReport settle_stage(lua_State* L, ScriptModel& model, const StageOptions& options, const EquilibriumOptions& how);

/// The same of a stage that rewind has brought back.
StageReport resume_stage(lua_State* L, ScriptModel& model);

/// While that model is paused: further steps of its stage. A pause asked for on the way ends them.
void run_on(lua_State* L, ScriptModel& model, RunLimit limit);

/// Pushes what a stage came to, as scripts get it.
void push_report(lua_State* L, const StageReport& report);

}  // namespace trilith::script
