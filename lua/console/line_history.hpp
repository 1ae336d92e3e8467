// The lines typed at the console, kept between sessions in a file of plain text.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace trilith::program {

/// Path of the history file: $TRILITH_HISTORY if set ("": none), otherwise $XDG_STATE_HOME/trilith/console_history,
/// otherwise ~/.local/state/trilith/console_history; "" without a home folder.
std::filesystem::path history_path();

class LineHistory {
 public:
  /// Reads the file, at most its last 2000 lines. A missing file is not an error.
  explicit LineHistory(std::filesystem::path path);

  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }
  /// Adds a line, here and in the file, unless it is empty, begins with a blank or repeats the last one. False if it
  /// was not added. A file that cannot be written is ignored from then on.
  bool add(const std::string& line);
  /// Reason for which the file cannot be written, returned once; "" otherwise.
  [[nodiscard]] std::string take_complaint();

 private:
  std::filesystem::path path_;
  std::vector<std::string> lines_;
  std::string complaint_;
};

}  // namespace trilith::program
