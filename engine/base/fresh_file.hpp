// Files written whole or not at all: under a name of their own first, then renamed over the one they replace.
#pragma once

#include <filesystem>
#include <string_view>

namespace trilith {

/// Where a file of this name lies: symbolic links at its end are followed, whether it is there or not. What is renamed
/// over the name of a link replaces the link; what is renamed over this keeps it.
std::filesystem::path past_links(std::filesystem::path path);

/// `descriptor`, or another one of the same file where it is one of the three standard ones, which is then closed.
/// Where a program begins with its output closed, the next file it opens would take its place, and what is printed
/// would go into it. -1 stays -1, with errno as it was.
int above_standard(int descriptor);

/// A new file beside the one it is to become. Nobody else has it: it is created exclusively, follows no link, and its
/// name ends with random letters and ".new". All members throw std::system_error.
class FreshFile {
 public:
  /// Creates it beside `target`, or beside what `target` leads to where that is a symbolic link. Throws InputError
  /// where something is there that is no regular file, as a device or a pipe: it would be gone.
  explicit FreshFile(const std::filesystem::path& target);
  FreshFile(const FreshFile&) = delete;
  FreshFile& operator=(const FreshFile&) = delete;
  /// Removes it, unless it took its place.
  ~FreshFile();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Open for reading and writing; closed by this.
  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// Appends `bytes`.
  void write(std::string_view bytes);
  /// Brings it and its folder's entry to the disk, and gives it the name of `target`, replacing what has that name.
  void take_place();

 private:
  std::filesystem::path target_, path_;
  int descriptor_ = -1;
  bool in_place_ = false;
};

}  // namespace trilith
