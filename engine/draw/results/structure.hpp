// Which bodies still belong to the structure at a moment: pictures are fitted to them, and cracks are drawn between
// them.
#pragma once

#include <vector>

#include "results/file/results.hpp"

namespace trilith::draw {

/// Free bodies beyond the structure's initial AABB, enlarged by a third of its size on all sides: debris [body]. Where
/// this would be more than half of the free bodies, the model is one that moves as a whole, and none is debris.
std::vector<bool> debris(const results::Header& header, const results::Frame& frame);

/// Free bodies that have moved, relative to the ground, by more than their own size since the start [body].
std::vector<bool> displaced(const results::Header& header, const results::Frame& frame);

}  // namespace trilith::draw
