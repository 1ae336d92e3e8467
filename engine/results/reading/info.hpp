// Summary of a results file in plain text: the output of `trilith info RESULT`.
#pragma once

#include <string>

#include "results/reading/reader.hpp"

namespace trilith::results {

/// State (finished, still running, ended prematurely), provenance, model counts, stages, frames, histories, events by
/// type, energy and notes, as lines ending in '\n'. Throws ResultsError if the file cannot be read completely.
std::string info_text(const ResultsReader& reader, const UnitSystem& units = {});

/// A line if these are finished results and a later run has left, or is writing, a part file; otherwise "".
std::string newer_run_text(const ResultsReader& reader);

}  // namespace trilith::results
