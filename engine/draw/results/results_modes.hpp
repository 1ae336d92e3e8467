// Pictures of natural modes in a results file.
#pragma once

#include <limits>

#include "draw/results/results_picture.hpp"

namespace trilith::draw {

/// The modes that were found last at or before `time` [s]. Throws InputError if there are none.
std::vector<results::ModeRow> modes_found(const results::ResultsReader& reader,
                                          double time = std::numeric_limits<double>::infinity());

/// Factor of a mode for a picture [m sqrt(kg)]. The largest displacement of an outline is then 6 % of the structure's
/// size, or less if a body would rotate by more than 0.5 rad.
double mode_scale(const results::Header& header, const results::ModeRow& mode);

/// The plane structure in a mode, `magnify` times mode_scale(), over its outline at the time when the mode was found.
Scene mode_scene(const results::Header& header, const results::ModeRow& mode, double magnify = 1);

/// The version for the plane or space, without bodies that were not active when the mode was found: removed, not added
/// yet, or out of bounds. For models in space the view direction and the cut of `choice` are used.
Scene mode_scene(const results::ResultsReader& reader, const results::ModeRow& mode, double magnify = 1,
                 const SceneChoice& choice = {});

}  // namespace trilith::draw
