// A condition on the cases of a study: "collapsed", "not collapsed", "drift > 0.02", "mode = rocking".
#pragma once

#include <string>
#include <vector>

#include "results/study/study_table.hpp"

namespace trilith::results {

/// Result of a condition for one case.
enum class Holds { no, yes, unknown };

/// Evaluates `condition` in each case; unknown if the case has no value. It is a flag of the table, alone or after
/// "not", a numeric column compared with a number, or a text column compared with a text; signs are > < >= <= = !=.
/// Numbers are in the column's unit. Throws InputError for anything else, with the nearest name.
std::vector<Holds> condition_of_cases(const std::vector<StudyColumn>& columns, const std::string& condition);

/// Number of cases with a result, and of cases in which the condition holds.
struct Tally {
  int hits = 0, count = 0;
  void add(Holds holds) {
    hits += holds == Holds::yes ? 1 : 0;
    count += holds != Holds::unknown ? 1 : 0;
  }
};

}  // namespace trilith::results
