// Where the project's own files are: scripts, records, pages.
#pragma once

#include <string>

namespace trilith::testing {

/// The folder of the project, without a slash at its end. The one source that names it is compiled anew in another
/// folder, all others are not.
const std::string& source_dir();

}  // namespace trilith::testing
