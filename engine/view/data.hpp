// The data of the page that `trilith view` writes: a results file made small. A pure function of the file.
#pragma once

#include <functional>
#include <string>

#include "results/file/time_origin.hpp"
#include "results/reading/reader.hpp"

namespace trilith::view {

/// What a page may hold at most; a longer run keeps every second, third, ... frame, and says so.
struct ViewLimits {
  double node_frames = 1.8e6;   ///< nodes, and a third more than elements, times frames
  double contact_rows = 3.5e5;  ///< contact forces of all frames
  double event_rows = 2.5e4;    ///< events of note come first; of the others the earliest
  double samples = 6000;        ///< of each history, evenly taken
};

/// Called with the share that is done, 0 to 1.
using ViewProgress = std::function<void(double)>;

/// The data before compression: "TRLV", version and length of the JSON (two uint32, little-endian), the JSON, then the
/// blocks it lists under "blocks" (name, rows, columns, quantum, bytes), each as view/bytes.hpp packs it. What
/// the blocks hold is told in frames.hpp. Lengths within half a quantum: 1/2000 of the smallest free body or
/// finer. `origin`: what the page counts times from at first. Throws InputError for a model in space without faces,
/// ResultsError for a file that cannot be read.
std::string view_data(const results::ResultsReader& reader, const ViewLimits& limits = {},
                      const ViewProgress& progress = {}, const results::TimeOrigin& origin = {});

/// The page as HTML: self-contained, needs no network. `data` as view_data gives it.
std::string view_page(const std::string& data, const std::string& title);

}  // namespace trilith::view
