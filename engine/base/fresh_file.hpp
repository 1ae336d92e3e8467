// Files that are written completely or not at all: under a temporary name first, then renamed over the target.
#pragma once

#include <filesystem>
#include <string_view>

namespace trilith {

/// Resolves symbolic links at the end of `path`, whether or not the final file exists. A rename onto the name of a link
/// would replace the link; a rename onto the returned path keeps it.
std::filesystem::path past_links(std::filesystem::path path);

/// Returns `descriptor`, or a duplicate of it where it is one of the three standard streams; the original is then
/// closed. If a program starts with its standard output closed, the next opened file would get that number and receive
/// the printed text. -1 stays -1, and errno is unchanged.
int above_standard(int descriptor);

/// A new temporary file in the folder of its target. It is created exclusively, follows no link, and its name ends with
/// random letters and ".new". All members throw std::system_error.
class FreshFile {
 public:
  /// Creates the file in the folder of `target`; symbolic links of `target` are followed. Throws InputError where the
  /// target exists and is not a regular file, such as a device or a pipe, because the rename would remove it.
  explicit FreshFile(const std::filesystem::path& target);
  FreshFile(const FreshFile&) = delete;
  FreshFile& operator=(const FreshFile&) = delete;
  /// Removes the temporary file, unless take_place() has renamed it.
  ~FreshFile();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Open for reading and writing; this object closes it.
  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// Appends `bytes`.
  void write(std::string_view bytes);
  /// Flushes the file to the disk, renames it to `target`, which replaces an existing file, and flushes the folder's
  /// entry.
  void take_place();

 private:
  std::filesystem::path target_, path_;
  int descriptor_ = -1;
  bool in_place_ = false;
};

}  // namespace trilith
