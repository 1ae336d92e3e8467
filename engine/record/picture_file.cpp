#include "record/picture_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "base/error.hpp"

namespace trilith {
namespace {

/// Throws unless all bytes reached the disk.
void write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t done = ::write(file, bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) throw errno;
    bytes.remove_prefix(static_cast<std::size_t>(done));
  }
  // Some file systems report a full disk only here; one that cannot sync at all (EINVAL, a pipe) is no failure.
  if (::fsync(file) != 0 && errno != EINVAL && errno != EROFS) throw errno;
}

[[noreturn]] void refuse(const std::filesystem::path& path, int reason) {
  throw InputError(fmt::format("cannot write '{}': {}", path.string(), std::strerror(reason)));
}

}  // namespace

void write_whole_file(const std::filesystem::path& path, std::string_view bytes) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) refuse(path, EISDIR);
  const std::string part = fmt::format("{}.{}.part", path.string(), ::getpid());
  const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) refuse(path, errno);
  int reason = 0;
  try {
    write_all(file, bytes);
  } catch (int error) {
    reason = error;
  }
  if (::close(file) != 0 && reason == 0) reason = errno;
  if (reason == 0 && std::rename(part.c_str(), path.c_str()) != 0) reason = errno;
  if (reason == 0) return;
  std::remove(part.c_str());
  refuse(path, reason);
}

}  // namespace trilith
