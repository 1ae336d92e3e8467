// A file read or written as a whole.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace trilith {

/// Writes `bytes` beside `path` under a temporary name and renames it to `path` when all of it is on the disk; what was
/// at `path` before stays until then. Throws InputError with the system's reason (no such directory, permission, disk
/// full, ...) and leaves no part behind.
void write_whole_file(const std::filesystem::path& path, std::string_view bytes);

/// All of a text file; also what a pipe gives. `what` begins messages: "script", "mesh". Throws InputError where it is
/// not there, is a folder or a device, holds more than `most` bytes, or cannot be read.
std::string text_of_file(const std::filesystem::path& path, std::string_view what, std::size_t most);

}  // namespace trilith
