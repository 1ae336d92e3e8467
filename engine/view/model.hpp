// Private to view/: what the page of `trilith view` is told in words: model, stages, events, parameters, colours.
#pragma once

#include "results/reading/reader.hpp"
#include "view/frames.hpp"
#include "view/json_text.hpp"

namespace trilith::view {

/// Writes the keys "run", "bodies", "vertices", "elements", "bearings", "stages", "types", "events", "joints",
/// "palette" into the object `json` is in. `frames` tells which joints were bonded and what was thinned out.
void write_view_model(const results::ResultsReader& reader, const ViewFrames& frames, const ViewLimits& limits,
                      JsonText& json);

}  // namespace trilith::view
