// Histories of temperatures, and of water in joints.
#pragma once

#include <string>

#include "bindings/core/keys.hpp"
#include "bindings/model/script_model.hpp"

namespace trilith::script {

/// Records the temperature of a body, or of a point of it (keys `body`, `point`); false if `what` is another reading or
/// no body is given.
bool follow_temperature(Keys& keys, History& history, const std::string& what, ScriptModel& m);

/// Records the water in a joint of m:seepage, or in one place of it (keys `seepage`, `at`); false without `seepage`.
bool follow_seepage(Keys& keys, History& history, const std::string& what, ScriptModel& m);

}  // namespace trilith::script
