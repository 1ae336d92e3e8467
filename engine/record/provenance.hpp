// What the program knows of itself and of where it runs.
#pragma once

#include <string>

#include "record/results.hpp"

namespace trilith::record {

/// Compiler, platform, git commit (where the build defines TRILITH_GIT_COMMIT) and start time (now, UTC) filled in; the
/// rest, script, program version and command line, is the caller's.
Provenance provenance_here();

}  // namespace trilith::record
