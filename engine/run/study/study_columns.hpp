// The table of a study: its columns from parameters, figures and outcomes.
#pragma once

#include <vector>

#include "results/study/study_table.hpp"
#include "run/study/study.hpp"

namespace trilith {

/// Throws InputError if a figure has the name of a parameter, of a column of the table, or of another figure.
void check_figure_names(const StudyPlan& plan, const std::vector<StudyFigure>& figures);

/// Columns: case, the parameters, the figures (in the order of the first case that has them), status, exit, seconds,
/// message and folder. Missing numbers are NaN, missing texts are empty.
std::vector<results::StudyColumn> study_table_columns(const StudyPlan& plan, const std::vector<StudyOutcome>& outcomes);

}  // namespace trilith
