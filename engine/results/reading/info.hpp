// What a results file holds, in a page of plain text: the output of `trilith info RESULT`.
#pragma once

#include <string>

#include "results/reading/reader.hpp"

namespace trilith::results {

/// State (finished, still running, ended before its end), provenance, model counts, stages, frames, histories, events
/// by type, energy and notes, as lines ending in '\n'. Throws ResultsError where the file cannot be read to its end.
std::string info_text(const ResultsReader& reader);

/// A line where these are finished results beside what a later run has left or is writing; else "".
std::string newer_run_text(const ResultsReader& reader);

}  // namespace trilith::results
