// Reads or writes a whole file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace trilith {

/// Writes `bytes` to a temporary file in the folder of `path` and renames it to `path` after all of it is on the disk;
/// the old file stays until then. Throws InputError with the system's reason (no such directory, permission, disk full,
/// ...) and leaves no partial file.
void write_whole_file(const std::filesystem::path& path, std::string_view bytes);

/// The whole text of a file or a pipe. Messages begin with `what`: "script", "mesh". Throws InputError where the file
/// does not exist, is a folder or a device, holds more than `most` bytes, or cannot be read.
std::string text_of_file(const std::filesystem::path& path, std::string_view what, std::size_t most);

/// `text` without the UTF-8 byte order mark that some editors write first.
constexpr std::string_view without_byte_order_mark(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

}  // namespace trilith
