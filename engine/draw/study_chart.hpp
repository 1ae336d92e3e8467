// The table of a study as a chart: figures over one parameter.
#pragma once

#include <string>
#include <vector>

#include "draw/chart.hpp"
#include "results/study_table.hpp"

namespace trilith::draw {

/// What a study's table may be drawn over, and of: its parameters and its figures, of numbers alone.
struct StudyNames {
  std::vector<std::string> parameters, figures;
};
StudyNames study_names(const std::vector<results::StudyColumn>& columns);

/// One panel for each unit among `figures` (all where empty): each figure's mean over the cases that share a value of
/// parameter `over` as a line, its largest and smallest as dashed ones. `over` empty: the first parameter that takes
/// several values. On a logarithmic axis where the values are above 0 and span two decades. Throws InputError for a
/// name that is not there, with the nearest, and for a table without cases or figures.
Chart study_chart(const std::vector<results::StudyColumn>& columns, const std::string& over,
                  const std::vector<std::string>& figures);

}  // namespace trilith::draw
