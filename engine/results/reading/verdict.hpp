// Verdict on the reliability of a run, from the events and the seal of a results file.
#pragma once

#include <vector>

#include "model/verdict.hpp"
#include "results/reading/reader.hpp"

namespace trilith::results {

/// `events`: all events of the file, sorted by time.
Verdict results_verdict(const ResultsReader& reader, const std::vector<EventRow>& events);

}  // namespace trilith::results
