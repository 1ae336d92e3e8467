#include "base/whole_file.hpp"

#include <fmt/format.h>

#include <system_error>

#include "base/error.hpp"
#include "base/fresh_file.hpp"

namespace trilith {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, std::error_code reason) {
  throw InputError(fmt::format("cannot write '{}': {}", path.string(), reason.message()));
}

}  // namespace

void write_whole_file(const std::filesystem::path& path, std::string_view bytes) try {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) refuse(path, std::make_error_code(std::errc::is_a_directory));
  FreshFile file(path);
  file.write(bytes);
  file.take_place();
} catch (const std::system_error& error) {
  refuse(path, error.code());
}

}  // namespace trilith
