// Runs a stage of a model with the script's handlers listening.
#pragma once

#include "bindings/core/handles.hpp"
#include "bindings/core/keys.hpp"

namespace trilith::script {

/// What ends a stage besides its own time.
struct StageUntil {
  int function = 0;        ///< stack index of a function of the model, asked after each step: true ends it; 0: none
  double drop = 0;         ///< bodies that were free as it began have come down by more than this [m]; 0: not asked
  int bodies = 1;          ///< ... so many of them
  std::int64_t steps = 0;  ///< it is stopped after so many; 0: it is not
};

/// { until_true = function, until_collapse = true | { drop =, bodies = } }. The function stays on the stack.
StageUntil read_until(Keys& keys, ScriptModel& m);

/// Runs a stage of the model at stack index 1. Handlers are called through the model's own table: dispatch(event),
/// tick(index), wake(), stepped(), sample(index). What they raise ends the stage and is thrown as ScriptError; at a
/// console the run pauses there instead.
StageReport run_stage(lua_State* L, ScriptModel& model, const StageOptions& options, const StageUntil& until = {});

/// The same of a stage of statics, which takes no time.
StageReport settle_stage(lua_State* L, ScriptModel& model, const StageOptions& options, const EquilibriumOptions& how,
                         AnyLoadWay way = {});

/// The same of a stage that rewind has brought back.
StageReport resume_stage(lua_State* L, ScriptModel& model);

/// While that model is paused: further steps of its stage. A pause asked for on the way ends them.
void run_on(lua_State* L, ScriptModel& model, RunLimit limit);

/// Pushes what a stage came to, as scripts get it.
void push_report(lua_State* L, const StageReport& report);

}  // namespace trilith::script
