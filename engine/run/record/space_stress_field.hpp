// Fields of deformable bodies in space in each frame: mean stress and plastic strain.
#pragma once

#include <vector>

#include "results/file/results.hpp"
#include "run/stage.hpp"

namespace trilith {

/// Adds /frames/body_stress_tensor and /frames/body_plastic_strain to a header that contains the bodies.
void describe_space_stress(results::Header& header);
/// Values of the fields at this instant; 0 for bodies that do not deform.
void take_space_stress(const Instant<3>& now, std::vector<std::vector<double>>& fields);

}  // namespace trilith
