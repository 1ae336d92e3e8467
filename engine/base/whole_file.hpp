// A file written whole or not at all.
#pragma once

#include <filesystem>
#include <string_view>

namespace trilith {

/// Writes `bytes` beside `path` under a temporary name and renames it to `path` when all of it is on the disk; what was
/// at `path` before stays until then. Throws InputError with the system's reason (no such directory, permission, disk
/// full, ...) and leaves no part behind.
void write_whole_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace trilith
