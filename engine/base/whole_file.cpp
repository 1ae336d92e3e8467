#include "base/whole_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "base/error.hpp"
#include "base/fresh_file.hpp"

namespace trilith {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, std::error_code reason) {
  throw InputError(fmt::format("cannot write '{}': {}", path.string(), reason.message()));
}

}  // namespace

/// Atomic: a temporary file replaces the existing one.
void write_whole_file(const std::filesystem::path& path, std::string_view bytes) try {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) refuse(path, std::make_error_code(std::errc::is_a_directory));
  FreshFile file(path);
  file.write(bytes);
  file.take_place();
} catch (const std::system_error& error) {
  refuse(path, error.code());
}

/// Reads block by block with a limit, because a pipe or a growing file has no known size.
std::string text_of_file(const std::filesystem::path& path, std::string_view what, std::size_t most) {
  const auto fail = [&](const std::string& why) {
    return InputError(fmt::format("cannot read {} '{}': {}", what, path.string(), why));
  };
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (std::filesystem::is_directory(status)) throw fail("it is a folder");
  if (std::filesystem::is_character_file(status) || std::filesystem::is_block_file(status))
    throw fail("it is a device; give a file");
  // A device could deliver bytes without end; a pipe is read until its end.
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) throw fail(std::strerror(errno));
  std::string text;
  std::array<char, 1 << 16> block;
  while (in.read(block.data(), block.size()) || in.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(in.gcount()));
    if (text.size() > most) throw fail(fmt::format("it holds more than {} bytes", most));
  }
  if (in.bad()) throw fail(std::strerror(errno));
  return text;
}

}  // namespace trilith
