// Pictures of natural modes that a run has found.
#pragma once

#include <limits>

#include "draw/scene/results_picture.hpp"

namespace trilith::draw {

/// The modes that were found at once, the last ones before or at `time` [s]. Throws InputError where there are none.
std::vector<results::ModeRow> modes_found(const results::ResultsReader& reader,
                                          double time = std::numeric_limits<double>::infinity());

/// What a mode is multiplied by for a picture [m sqrt(kg)]: its largest displacement of an outline is then 6 % of the
/// structure's size, and less where a body would turn by more than half a radian.
double mode_scale(const results::Header& header, const results::ModeRow& mode);

/// The structure in a mode, in the plane, `magnify` times mode_scale(), over its outline as it stood when the mode was
/// found.
Scene mode_scene(const results::Header& header, const results::ModeRow& mode, double magnify = 1);

/// The same, in the plane or in space, without bodies that were not there when the mode was found: removed, not added
/// yet, or out of bounds. Of `choice` the direction of view and the cut count, of models in space.
Scene mode_scene(const results::ResultsReader& reader, const results::ModeRow& mode, double magnify = 1,
                 const SceneChoice& choice = {});

}  // namespace trilith::draw
