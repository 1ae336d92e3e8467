// Natural modes as rows of a results file.
#pragma once

#include <vector>

#include "modal/mode_damping.hpp"
#include "results/file/results.hpp"

namespace trilith {

/// One row for each mode, with its damping and the positions of all nodes in `state`, for which the modes were found.
template <int D>
std::vector<results::ModeRow> recorded_modes(const State<D>& state, const std::vector<NaturalMode<D>>& modes,
                                             const std::vector<ModeDamping>& damping);

}  // namespace trilith
