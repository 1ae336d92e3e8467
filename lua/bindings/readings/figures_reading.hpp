// Figures that a script, or a function of a study, returns.
#pragma once

#include <vector>

#include "bindings/core/lua_api.hpp"
#include "run/study/study_figures.hpp"

namespace trilith::script {

/// Reads { drift = 0.01, collapsed = true, mode = "rocking", opening = { 0.002, unit = "m" } } at `index`, sorted by
/// name; flags become 1 and 0; nothing for nil or other values. Throws InputError for an invalid figure.
std::vector<StudyFigure> figures_at(lua_State* L, int index);

}  // namespace trilith::script
