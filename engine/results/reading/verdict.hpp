// What the events of a results file say of whether its run may be trusted.
#pragma once

#include <vector>

#include "model/verdict.hpp"
#include "results/file/results.hpp"

namespace trilith::results {

/// Of all events of a file, in time.
Verdict results_verdict(const std::vector<EventRow>& events);

}  // namespace trilith::results
