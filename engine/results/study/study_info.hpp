// A study in plain words, for a terminal.
#pragma once

#include <string>
#include <vector>

#include "results/study/study_table.hpp"

namespace trilith::results {

/// Several lines, each ended: how many cases finished, what failed and why, the parameters with their values, and of
/// each figure median, 16 to 84 % band, range and dispersion; of a flag its probability with Wilson's interval.
std::string study_info_text(const std::vector<StudyColumn>& columns);

/// The probability that `condition` holds with its interval; for each value of parameter `over` where that is not "".
/// Throws InputError as condition_of_cases.
std::string study_probability_text(const std::vector<StudyColumn>& columns, const std::string& condition,
                                   const std::string& over);

}  // namespace trilith::results
