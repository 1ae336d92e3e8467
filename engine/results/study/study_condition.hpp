// A condition on the cases of a study: "collapsed", "not collapsed", "drift > 0.02", "mode = rocking".
#pragma once

#include <string>
#include <vector>

#include "results/study/study_table.hpp"

namespace trilith::results {

/// Of one case.
enum class Holds { no, yes, unknown };

/// Whether `condition` holds in each case; unknown where the case has no value. It is a flag of the table, alone or
/// after "not", or one of its numbers against a number, or one of its texts against a text; signs are > < >= <= = !=.
/// Numbers stand in the column's unit. Throws InputError for anything else, with the nearest name.
std::vector<Holds> condition_of_cases(const std::vector<StudyColumn>& columns, const std::string& condition);

/// How many of the cases that answer say yes.
struct Tally {
  int hits = 0, count = 0;
  void add(Holds holds) {
    hits += holds == Holds::yes ? 1 : 0;
    count += holds != Holds::unknown ? 1 : 0;
  }
};

}  // namespace trilith::results
