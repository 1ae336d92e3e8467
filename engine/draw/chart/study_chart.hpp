// Charts of a study's table: figures over one parameter, fragility curves, incremental analyses.
#pragma once

#include <string>
#include <vector>

#include "draw/chart/chart.hpp"
#include "results/study/study_fragility.hpp"
#include "results/study/study_table.hpp"

namespace trilith::draw {

/// One panel for each unit among `figures` (all with numbers if empty). For each figure it shows the median over the
/// cases with equal parameter `over` as a line, the band from 16 % to 84 %, and the extremes as dashed lines. For a
/// flag it shows the share of the cases with Wilson's 95 % interval. If `over` is empty, the first parameter with
/// several values is used; texts or flags give an axis of words. The axis is logarithmic for positive values over two
/// decades or more. Throws InputError for an unknown name, with the nearest one, for a figure of texts, and for a table
/// without cases or figures.
Chart study_chart(const std::vector<results::StudyColumn>& columns, const std::string& over,
                  const std::vector<std::string>& figures);

/// The fitted curve with its 95 % band, and the observed share at each intensity with Wilson's interval.
Chart fragility_chart(const results::StudyFragility& fragility, const std::string& condition);

/// Incremental dynamic analysis (D. Vamvatsikos and C. A. Cornell, Earthquake Engineering and Structural Dynamics 31,
/// 2002). It shows intensity `over` over the response `figure`, a line for each record, and the 16, 50 and 84 %
/// quantile lines. `stop`, unless empty, is a condition under which the response is unbounded. The line of the record
/// then continues horizontally to the edge, half-way between the highest intensity without and the lowest with the
/// condition. Throws InputError as study_fragility.
Chart ida_chart(const std::vector<results::StudyColumn>& columns, const std::string& figure, const std::string& over,
                const std::string& stop);

}  // namespace trilith::draw
