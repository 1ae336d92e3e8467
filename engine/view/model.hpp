// Private to view/: texts and tables of the page of `trilith view`: model, stages, events, parameters, colours.
#pragma once

#include "results/reading/reader.hpp"
#include "view/frames.hpp"
#include "view/json_text.hpp"

namespace trilith::view {

/// Writes the keys "run", "bodies", "vertices", "elements", "bearings", "stages", "types", "events", "joints",
/// "palette" into the present object of `json`. `frames` contains the bonded joints and the strides. Numbers in texts
/// are in `units`.
void write_view_model(const results::ResultsReader& reader, const ViewFrames& frames, const ViewLimits& limits,
                      const UnitSystem& units, JsonText& json);

}  // namespace trilith::view
