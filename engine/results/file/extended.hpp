// Continues a results file with more bodies, bearings or histories.
#pragma once

#include "results/file/results.hpp"
#include "results/file/writer.hpp"

namespace trilith::results {

/// Ends the writing of `before` and continues, under the same name, in a file of `header`, which contains all previous
/// records. `header` has the previous rows in their places, and further ones at the ends. In previous frames an added
/// body has its initial position. Its bearings are absent; its stresses, and fields that `before` did not record, are
/// 0; new histories have no values. Throws ResultsError as a writer does; the previous records then remain in a file
/// whose name is in the message.
ResultsWriter extended(ResultsWriter before, const Header& header, WriterOptions options);

/// Appends the first `rows` of the unfinished file `from` to `to`, which has the header `header` and no rows yet, and
/// flushes. `header` contains all bodies, bearings and histories of `from`. `last_is_open`: the last stage has not
/// ended. Throws ResultsError if `from` has fewer rows.
void continue_rows(const std::filesystem::path& from, const Header& header, const RowCounts& rows, bool last_is_open,
                   ResultsWriter& to);

/// Extends a mode to the number of nodes of `header`: added nodes are in their initial position and do not move.
void fit_mode(const Header& header, ModeRow& mode);

}  // namespace trilith::results
