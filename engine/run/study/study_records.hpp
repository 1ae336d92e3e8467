// What a case leaves in its folder: that it is finished, with its figures, or that it failed, and why.
#pragma once

#include <string>

#include "run/study/study.hpp"

namespace trilith {

/// Of all that decides what a case comes to; other digests are of other cases.
std::string case_digest(const StudyOrder& order, std::size_t index);

/// A file as a whole; "" where there is none.
std::string case_text(const std::filesystem::path& path);

/// What an earlier call, or a task of a cluster, has left in the case's folder, where it still holds.
bool take_finished_case(const std::string& digest, StudyOutcome& outcome);
void take_failed_case(const std::string& digest, StudyOutcome& outcome);

void keep_finished_case(const std::string& digest, const StudyOutcome& outcome);
void keep_failed_case(const std::string& digest, const StudyOutcome& outcome);

}  // namespace trilith
