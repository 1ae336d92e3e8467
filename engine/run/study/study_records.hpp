// Record of a case in its folder: finished, with its figures, or failed, with the reason.
#pragma once

#include <string>

#include "run/study/study.hpp"

namespace trilith {

/// Digest of all input that determines the result of a case.
std::string case_digest(const StudyOrder& order, std::size_t index);

/// Content of a file; "" if there is none.
std::string case_text(const std::filesystem::path& path);

/// Reads the record of an earlier call, or of a task of a cluster, from the case's folder if it is still valid.
bool take_finished_case(const std::string& digest, StudyOutcome& outcome);
void take_failed_case(const std::string& digest, StudyOutcome& outcome);

void keep_finished_case(const std::string& digest, const StudyOutcome& outcome);
void keep_failed_case(const std::string& digest, const StudyOutcome& outcome);

}  // namespace trilith
