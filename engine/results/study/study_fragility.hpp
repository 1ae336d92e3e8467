// The table of a study as what a fragility curve is fitted to.
#pragma once

#include <string>
#include <vector>

#include "results/study/fragility.hpp"
#include "results/study/study_condition.hpp"

namespace trilith::results {

/// What was seen at one intensity.
struct Stripe {
  double intensity = 0;
  Tally seen;
};

/// Cases of one record (all parameters but the intensity the same), by rising intensity; row numbers of the table.
struct RecordCases {
  std::string name;  ///< "record=elcentro.csv, seed=2"; "" where nothing but the intensity varies
  std::vector<std::size_t> rows;
};

struct StudyFragility {
  std::string intensity, unit;  ///< the parameter
  bool incremental = false;     ///< the study passed cases over: each record gives the interval of its capacity
  std::vector<Stripe> stripes;  ///< by rising intensity; of an incremental one: records brought down at or below it
  Fragility curve;
};

/// The cases of each record, in the order of the table. Throws InputError where `over` is no parameter of numbers.
std::vector<RecordCases> cases_by_record(const std::vector<StudyColumn>& columns, const std::string& over);

/// Fits the curve of `condition` (study_condition.hpp) over parameter `over`: as stripes of independent cases, or,
/// where the study passed cases over, by the records' capacities. Throws InputError as fit_fragility and
/// condition_of_cases.
StudyFragility study_fragility(const std::vector<StudyColumn>& columns, const std::string& condition,
                               const std::string& over);

/// One line: median and dispersion with their intervals, and what they were fitted to.
std::string fragility_text(const StudyFragility& f);

}  // namespace trilith::results
