// Verdict on the reliability of a run, from the events of a results file.
#pragma once

#include <vector>

#include "model/verdict.hpp"
#include "results/file/results.hpp"

namespace trilith::results {

/// `events`: all events of a file, sorted by time.
Verdict results_verdict(const std::vector<EventRow>& events);

}  // namespace trilith::results
