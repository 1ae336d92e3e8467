#include "base/fresh_file.hpp"

#include <fcntl.h>
#include <sys/random.h>
#include <unistd.h>

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "base/error.hpp"

namespace trilith {
namespace {

constexpr int most_links = 40;  // the limit of the operating system
constexpr int most_names = 100;

[[noreturn]] void fail(const std::filesystem::path& path) {
  throw std::system_error(errno, std::generic_category(), path.string());
}

/// Unpredictable letters and digits.
std::string random_word() {
  static constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz234567";
  std::array<unsigned char, 10> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) fail("random numbers");
  std::string word;
  for (const unsigned char byte : bytes) word += letters[byte % letters.size()];
  return word;
}

/// A file system without sync reports EINVAL or EROFS; neither is a failure.
void sync(int descriptor, const std::filesystem::path& path) {
  if (::fsync(descriptor) != 0 && errno != EINVAL && errno != EROFS) fail(path);
}

void sync_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;  // a folder that is writable but not readable
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

/// Follows links, so that the rename replaces the file and not the link to it.
std::filesystem::path past_links(std::filesystem::path path) {
  std::error_code error;
  for (int i = 0; i < most_links && std::filesystem::is_symlink(path, error); ++i) {
    const std::filesystem::path to = std::filesystem::read_symlink(path, error);
    if (error) break;
    path = path.parent_path() / to;
  }
  return path;
}

// If a caller has closed a standard stream, the next opened file gets its number and would receive the printed text.
int above_standard(int descriptor) {
  if (descriptor < 0 || descriptor > STDERR_FILENO) return descriptor;
  const int higher = ::fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  const int reason = errno;
  ::close(descriptor);
  errno = reason;
  return higher;
}

/// A temporary file in the folder of the target. The old file is not touched before take_place(), so a full disk or a
/// killed program leaves it whole.
FreshFile::FreshFile(const std::filesystem::path& target) : target_(past_links(target)) {
  std::error_code ignored;
  const std::filesystem::file_status there = std::filesystem::status(target_, ignored);
  if (std::filesystem::is_other(there))
    throw InputError(
        fmt::format("cannot write '{}': it is not a regular file; give the name of a file", target.string()));
  for (int i = 0; i < most_names && descriptor_ < 0; ++i) {
    path_ = target_.string() + "." + random_word() + ".new";
    descriptor_ = above_standard(::open(path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
    if (descriptor_ < 0 && errno != EEXIST) break;
  }
  if (descriptor_ < 0) fail(target_);
}

FreshFile::~FreshFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!in_place_) ::unlink(path_.c_str());
}

/// A signal may interrupt a write: the remaining bytes are written again.
void FreshFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t done = ::write(descriptor_, bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) fail(target_);
    bytes.remove_prefix(static_cast<std::size_t>(done));
  }
}

/// The order makes the replacement atomic: flush the bytes, rename, then flush the folder.
void FreshFile::take_place() {
  sync(descriptor_, target_);
  if (::close(std::exchange(descriptor_, -1)) != 0) fail(target_);
  if (::rename(path_.c_str(), target_.c_str()) != 0) fail(target_);
  in_place_ = true;
  sync_folder(target_.has_parent_path() ? target_.parent_path() : ".");
}

}  // namespace trilith
