// A results file that goes on with more bodies, bearings or histories than it began with.
#pragma once

#include "results/file/results.hpp"
#include "results/file/writer.hpp"

namespace trilith::results {

/// Ends the writing of `before` and goes on, under the same name, in a file of `header`, which has everything that was
/// written. `header` has the rows of the file before, in their places, and further ones at the ends. In frames of
/// before a body that was not there yet stands where it starts; its bearings are absent; its stresses, and what
/// `before` did not record at all, are 0; histories that were not followed have no number. Throws ResultsError as a
/// writer does; then what was written lies under a name of its own, which the message gives.
ResultsWriter extended(ResultsWriter before, const Header& header, WriterOptions options);

/// A mode with as many numbers as `header` has nodes: those that came later stand where they begin, and do not move.
void fit_mode(const Header& header, ModeRow& mode);

}  // namespace trilith::results
