// Runs a stage of a model with the script's handlers listening.
#pragma once

#include <functional>

#include "bindings/core/handles.hpp"
#include "bindings/core/keys.hpp"

namespace trilith::script {

/// End criteria of a stage other than its duration.
struct StageUntil {
  int function = 0;        ///< stack index of a function of the model, called after each step: true ends the stage; 0:
                           ///< none
  double drop = 0;         ///< ends when bodies that were free at its start have fallen by more than this [m]; 0: not
                           ///< used
  int bodies = 1;          ///< ... and their number
  std::int64_t steps = 0;  ///< stopped after this number of steps; 0: not used
};

/// A function of the script that is called with the model and a sample, where a stage has taken a new one.
struct StageSamples {
  int function = 0;            ///< stack index; 0: none
  std::function<bool()> due;   ///< called after each step: true where there is a new sample
  std::function<void()> push;  ///< pushes this sample
};

/// { until_true = function, until_collapse = true | { drop =, bodies = } }. The function remains on the stack.
StageUntil read_until(Keys& keys, ScriptModel& m);

/// Runs a stage of the model at stack index 1. Handlers are called through the model's own table: dispatch(event),
/// tick(index), wake(), stepped(), sample(index). Their errors end the stage and are thrown as ScriptError; at a
/// console the run pauses instead.
StageReport run_stage(lua_State* L, ScriptModel& model, const StageOptions& options, const StageUntil& until = {},
                      const StageSamples& samples = {});

/// Runs a static stage, which takes no time. Each point of a load path counts as a step.
StageReport settle_stage(lua_State* L, ScriptModel& model, const StageOptions& options, const EquilibriumOptions& how,
                         AnyLoadWay way = {}, const StageSamples& samples = {});

/// Runs a stage that rewind has restored.
StageReport resume_stage(lua_State* L, ScriptModel& model);

/// Writes the present instant of the model at stack index 1 to a file: see ScriptModel::save_instant.
void save_instant(lua_State* L, ScriptModel& model, const std::filesystem::path& file);

/// Takes further steps of the stage of a paused model. A pause requested meanwhile ends them.
void run_on(lua_State* L, ScriptModel& model, RunLimit limit);

/// StageReport::reason of a stage that until_collapse has ended.
inline constexpr const char* collapse_reason = "collapse, by until_collapse";

/// Pushes the report of a stage for scripts.
void push_report(lua_State* L, const StageReport& report);

}  // namespace trilith::script
