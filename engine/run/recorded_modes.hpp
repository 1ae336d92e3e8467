// Natural modes as rows of a results file.
#pragma once

#include <vector>

#include "results/results.hpp"
#include "step/mode_damping.hpp"

namespace trilith {

/// One row for each mode, with its damping and the place of all nodes in `state`, of which they were found.
std::vector<results::ModeRow> recorded_modes(const State<2>& state, const std::vector<Mode>& modes,
                                             const std::vector<ModeDamping>& damping);

}  // namespace trilith
