// The table of a study as charts: figures over one parameter, fragility curves, incremental analyses.
#pragma once

#include <string>
#include <vector>

#include "draw/chart/chart.hpp"
#include "results/study/study_fragility.hpp"
#include "results/study/study_table.hpp"

namespace trilith::draw {

/// One panel for each unit among `figures` (all that have numbers where empty): each figure's median over the cases
/// that share a value of parameter `over` as a line, the band from 16 to 84 % of them, its largest and smallest as
/// dashed lines; of a flag the share of the cases with Wilson's interval of 95 %. `over` empty: the first parameter
/// that takes several values; one of texts or flags gives an axis of words. Logarithmic where the values are above 0
/// and span two decades. Throws InputError for a name that is not there, with the nearest, for a figure of texts, and
/// for a table without cases or figures.
Chart study_chart(const std::vector<results::StudyColumn>& columns, const std::string& over,
                  const std::vector<std::string>& figures);

/// The fitted curve with its band of 95 %, and what was seen at each intensity with Wilson's interval.
Chart fragility_chart(const results::StudyFragility& fragility, const std::string& condition);

/// Incremental dynamic analysis (D. Vamvatsikos and C. A. Cornell, Earthquake Engineering and Structural Dynamics 31,
/// 2002): intensity `over` over the response `figure`, a line for each record, and the intensity's 16, 50 and 84 %
/// lines of the response. `stop` not "": a condition; where it holds the response is without bound, and the record's
/// line goes on level to the edge, half-way between the intensities that it stood and that brought it down. Throws
/// InputError as study_fragility.
Chart ida_chart(const std::vector<results::StudyColumn>& columns, const std::string& figure, const std::string& over,
                const std::string& stop);

}  // namespace trilith::draw
