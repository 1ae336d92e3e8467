// Of bodies in space at each frame: the mean stress of those that deform, and what has flown of them.
#pragma once

#include <vector>

#include "results/file/results.hpp"
#include "run/stage.hpp"

namespace trilith {

/// Adds /frames/body_stress_tensor and /frames/body_plastic_strain to a header that has its bodies.
void describe_space_stress(results::Header& header);
/// Their numbers at this instant, 0 of bodies that do not deform.
void take_space_stress(const Instant<3>& now, std::vector<std::vector<double>>& fields);

}  // namespace trilith
