// Summary of a study as plain text.
#pragma once

#include <string>
#include <vector>

#include "results/study/study_table.hpp"

namespace trilith::results {

/// Several lines: number of finished cases, failures with their reasons, and the parameters with their values. For each
/// figure they contain median, 16 to 84 % band, range and dispersion; for a flag its probability with Wilson's
/// interval.
std::string study_info_text(const std::vector<StudyColumn>& columns);

/// The probability of `condition` with its interval; for each value of parameter `over` unless that is "". Throws
/// InputError as condition_of_cases.
std::string study_probability_text(const std::vector<StudyColumn>& columns, const std::string& condition,
                                   const std::string& over);

}  // namespace trilith::results
