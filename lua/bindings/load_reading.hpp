// What all loads are asked for: bodies, load curve, name.
#pragma once

#include <string>
#include <vector>

#include "keys.hpp"
#include "load/load_curve.hpp"
#include "script_model.hpp"

namespace trilith::script {

/// `body`: a body, a set or a name; none where that is wrong, which Keys::finish tells.
std::vector<int> read_loaded_bodies(Keys& keys, const ScriptModel& m);

/// `course`: nothing (all at once, for good), a share, { ramp = T }, { smooth = T } or { {t, share}, ... , smooth =
/// true } with times from `now` on [s].
LoadCurve read_load_curve(Keys& keys, double now);

/// Names of the loads and pushes of a model; builds it.
std::vector<std::string> names_of_loads(ScriptModel& m);
/// The first of "kind 1", "kind 2", ... that no load has.
std::string free_load_name(ScriptModel& m, const char* kind);
int push_load_name(lua_State* L, const std::string& name);

}  // namespace trilith::script
