// The data of the page that `trilith view` writes: a reduced results file. A pure function of the file.
#pragma once

#include <functional>
#include <string>

#include "results/file/time_origin.hpp"
#include "results/reading/reader.hpp"

namespace trilith::view {

/// Limits of a page; a longer run keeps every second, third, ... frame, and reports it.
struct ViewLimits {
  double node_frames = 1.8e6;   ///< nodes, and a third more than elements, times frames
  double contact_rows = 3.5e5;  ///< contact forces of all frames
  double event_rows = 2.5e4;    ///< important events first; of the others the earliest
  double samples = 6000;        ///< of each history, evenly spaced
};

/// Called with the completed share, 0 to 1.
using ViewProgress = std::function<void(double)>;

/// The data before compression: "TRLV", version and length of the JSON (two uint32, little-endian), the JSON, then the
/// blocks in its list "blocks" (name, rows, columns, quantum, bytes), each packed as in view/bytes.hpp. The blocks are
/// described in frames.hpp. Lengths are accurate to half a quantum: 1/2000 of the smallest free body or finer.
/// `origin`: initial origin of times in the page. `units`: in which the page shows numbers; the data are in SI. Throws
/// InputError for a model in space without faces, ResultsError for a file that cannot be read.
std::string view_data(const results::ResultsReader& reader, const ViewLimits& limits = {},
                      const ViewProgress& progress = {}, const results::TimeOrigin& origin = {},
                      const UnitSystem& units = {});

/// The page as HTML: self-contained, needs no network. `data` from view_data.
std::string view_page(const std::string& data, const std::string& title);

}  // namespace trilith::view
