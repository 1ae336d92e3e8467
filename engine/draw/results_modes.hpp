// Pictures of natural modes that a run has found.
#pragma once

#include <limits>

#include "draw/results_picture.hpp"

namespace trilith::draw {

/// The modes that were found at once, the last ones before or at `time` [s]. Throws InputError where there are none.
std::vector<results::ModeRow> modes_found(const results::ResultsReader& reader,
                                          double time = std::numeric_limits<double>::infinity());

/// The structure in a mode, over its outline as it stood when the mode was found. The largest displacement of an
/// outline is 6 % of the structure's size, times `magnify`, and less where a body would turn by more than half a
/// radian.
Scene mode_scene(const results::Header& header, const results::ModeRow& mode, double magnify = 1);

}  // namespace trilith::draw
