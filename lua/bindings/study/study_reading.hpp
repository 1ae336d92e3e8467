// Reader of a study's plan from a table.
#pragma once

#include "bindings/core/keys.hpp"
#include "run/study/study_figures.hpp"
#include "run/study/study_plan.hpp"

namespace trilith::script {

/// Reads one of `parameters` (a product), `cases` (a list) and `samples` (with `count` and `seed`). Throws InputError
/// as the functions of study_plan.hpp, and for other tables.
StudyPlan read_plan(Keys& keys);

/// Reads `histories`: { ["top drift"] = "max", ["base shear"] = { "max", "min" } }. Throws InputError.
std::vector<StudyHistory> read_histories(Keys& keys);

}  // namespace trilith::script
