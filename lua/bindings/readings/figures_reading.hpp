// What a script, or a function of a study, gives back as its figures.
#pragma once

#include <vector>

#include "bindings/core/lua_api.hpp"
#include "run/study/study_figures.hpp"

namespace trilith::script {

/// Reads { drift = 0.01, collapsed = true, mode = "rocking", opening = { 0.002, unit = "m" } } at `index`, in the order
/// of the names; flags become 1 and 0; nothing where it is nil or no table. Throws InputError for what is no figure.
std::vector<StudyFigure> figures_at(lua_State* L, int index);

}  // namespace trilith::script
