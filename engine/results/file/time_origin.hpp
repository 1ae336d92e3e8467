// From when times are counted: the start of the run, the beginning of a stage, or an event. One rule for plots,
// pictures, tables, reports and the page; whatever counts from elsewhere than the start says so.
#pragma once

#include <string>
#include <string_view>

#include "results/reading/reader.hpp"

namespace trilith::results {

struct TimeOrigin {
  double zero = 0;         ///< what counts as 0 [s of the run]
  std::string name = {};   ///< of the stage, or the event's type
  std::string since = {};  ///< "'shake' began", "the first seat.lost"; "": the start of the run

  /// " since 'shake' began", which follows a time; "" where times count from the start.
  [[nodiscard]] std::string text() const { return since.empty() ? "" : " since " + since; }
};

/// Of the first stage called `name`, else of the first event of that type; of the start where it is empty. Throws
/// InputError with the nearest name where the run has neither.
TimeOrigin time_origin(const ResultsReader& reader, std::string_view name);

/// The first stage called `name`; throws InputError with the nearest name where there is none.
StageRow find_stage(const ResultsReader& reader, std::string_view name);

}  // namespace trilith::results
