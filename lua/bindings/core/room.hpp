// The folders that a script may read from and write to.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace trilith::script {

/// Open by default, so that nothing is refused: the module in a stock interpreter, and `--trust`. Once closed, a path
/// is decided on after its symbolic links and ".." are resolved; names that begin with a dot are out of reach below
/// every folder.
class Room {
 public:
  /// Closes the room: what lies below `script_folder` can be read and written, and nothing else until add().
  void close(const std::filesystem::path& script_folder);
  /// What lies below `folder` can be read and written too; a folder that is not there yet counts as well.
  void add(const std::filesystem::path& folder);
  [[nodiscard]] bool closed() const { return closed_; }
  [[nodiscard]] const std::vector<std::filesystem::path>& folders() const { return folders_; }

  /// The resolved path of a file to read; `path` itself where the room is open. Throws InputError where it is refused;
  /// `owner` ("io.open") begins the message.
  [[nodiscard]] std::filesystem::path readable(const std::filesystem::path& path, const std::string& owner) const;
  /// The same for a file to write. Programs, Lua files and what is no plain file are never written over.
  [[nodiscard]] std::filesystem::path writable(const std::filesystem::path& path, const std::string& owner) const;

 private:
  [[nodiscard]] std::filesystem::path resolved(const std::filesystem::path& path, const std::string& owner,
                                               const char* act) const;
  bool closed_ = false;
  std::vector<std::filesystem::path> folders_;
};

}  // namespace trilith::script
