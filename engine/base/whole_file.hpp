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

/// `text` without the mark (byte order mark of UTF-8) that some editors begin a text file with.
constexpr std::string_view without_byte_order_mark(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

}  // namespace trilith
