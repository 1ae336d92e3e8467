// Private to record/: what the page of `trilith view` is told in words: model, stages, events, parameters, colours.
#pragma once

#include "record/json_text.hpp"
#include "record/results_reader.hpp"
#include "record/view_frames.hpp"

namespace trilith::record {

/// Writes the keys "run", "bodies", "vertices", "elements", "bearings", "stages", "types", "events", "joints",
/// "palette" into the object `json` is in. `frames` tells which joints were bonded and what was thinned out.
void write_view_model(const ResultsReader& reader, const ViewFrames& frames, const ViewLimits& limits, JsonText& json);

}  // namespace trilith::record
