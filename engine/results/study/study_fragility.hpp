// Preparation of a study's table for the fit of a fragility curve.
#pragma once

#include <string>
#include <vector>

#include "results/study/fragility.hpp"
#include "results/study/study_condition.hpp"

namespace trilith::results {

/// Results at one intensity.
struct Stripe {
  double intensity = 0;
  Tally seen;
};

/// Cases of one record (all parameters except the intensity are equal), by increasing intensity; row indices of the
/// table.
struct RecordCases {
  std::string name;  ///< "record=elcentro.csv, seed=2"; "" if only the intensity varies
  std::vector<std::size_t> rows;
};

struct StudyFragility {
  std::string intensity, unit;  ///< the parameter
  bool incremental = false;     ///< the study skipped cases: each record gives the interval of its capacity
  std::vector<Stripe> stripes;  ///< by increasing intensity; of an incremental one: records with the outcome at or
                                ///< below it
  Fragility curve;
};

/// The cases of each record, in the order of the table. Throws InputError if `over` is not a numeric parameter.
std::vector<RecordCases> cases_by_record(const std::vector<StudyColumn>& columns, const std::string& over);

/// Fits the curve of `condition` (study_condition.hpp) over parameter `over`: as stripes of independent cases, or, if
/// the study skipped cases, from the capacities of the records. Throws InputError as fit_fragility and
/// condition_of_cases.
StudyFragility study_fragility(const std::vector<StudyColumn>& columns, const std::string& condition,
                               const std::string& over);

/// One line: median and dispersion with their intervals, and the data of the fit.
std::string fragility_text(const StudyFragility& f);

}  // namespace trilith::results
