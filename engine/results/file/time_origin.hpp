// Origin of displayed times: the start of the run, the start of a stage, or an event. One rule for plots, pictures,
// tables, reports and the page; all state an origin other than the start.
#pragma once

#include <string>
#include <string_view>

#include "results/reading/reader.hpp"

namespace trilith::results {

struct TimeOrigin {
  double zero = 0;         ///< run time of the origin [s]
  std::string name = {};   ///< of the stage, or the event's type
  std::string since = {};  ///< "'shake' began", "the first seat.lost"; "": the start of the run

  /// " since 'shake' began", to be appended to a time; "" if times count from the start.
  [[nodiscard]] std::string text() const { return since.empty() ? "" : " since " + since; }
};

/// Origin at the start of the first stage called `name`, otherwise at the first event of that type; the start if `name`
/// is empty. Throws InputError with the nearest name if the run has neither.
TimeOrigin time_origin(const ResultsReader& reader, std::string_view name);

/// The first stage called `name`; throws InputError with the nearest name if there is none.
StageRow find_stage(const ResultsReader& reader, std::string_view name);

}  // namespace trilith::results
