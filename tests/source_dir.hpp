// Folder of the project's own files: scripts, records, pages.
#pragma once

#include <string>

namespace trilith::testing {

/// The folder of the project, without a slash at its end. Only the source that contains the path is recompiled in
/// another folder; all others are not.
const std::string& source_dir();

}  // namespace trilith::testing
