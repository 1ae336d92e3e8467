// The events of a run as a table in plain text, each below its cause.
#pragma once

#include <string>
#include <vector>

#include "results/file/results.hpp"
#include "results/file/time_origin.hpp"

namespace trilith::results {

/// One line for each event, '\n' ended: time [s] since `origin`, type, and its text indented below its cause; the
/// effects of one cause are sorted by time. An event whose cause is not among `events` starts at the left. Without
/// events: a line that reports it.
std::string event_table(const std::vector<EventRow>& events, const TimeOrigin& origin = {});

}  // namespace trilith::results
