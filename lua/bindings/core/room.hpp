// Restricts the folders that a script may read from and write to.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace trilith::script {

/// Open by default without restrictions: the module in a stock interpreter, and `--trust`. If closed, a path is checked
/// after its symbolic links and ".." are resolved; names that begin with a dot are inaccessible in every folder.
class Room {
 public:
  /// Closes the room: only files below `script_folder` can be read and written until add().
  void close(const std::filesystem::path& script_folder);
  /// Permits files below `folder` too, also if the folder does not exist yet.
  void add(const std::filesystem::path& folder);
  [[nodiscard]] bool closed() const { return closed_; }
  [[nodiscard]] const std::vector<std::filesystem::path>& folders() const { return folders_; }

  /// The resolved path of a file to read; `path` itself if the room is open. Throws InputError if it is rejected;
  /// `owner` ("io.open") begins the message.
  [[nodiscard]] std::filesystem::path readable(const std::filesystem::path& path, const std::string& owner) const;
  /// The resolved path of a file to write. Programs, Lua files and special files are never overwritten.
  [[nodiscard]] std::filesystem::path writable(const std::filesystem::path& path, const std::string& owner) const;

 private:
  [[nodiscard]] std::filesystem::path resolved(const std::filesystem::path& path, const std::string& owner,
                                               const char* act) const;
  bool closed_ = false;
  std::vector<std::filesystem::path> folders_;
};

}  // namespace trilith::script
