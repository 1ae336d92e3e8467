// The lines typed at the console, kept between sessions in a file of plain text.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace trilith::program {

/// Where the lines are kept: $TRILITH_HISTORY where it is set ("" there: nowhere), else
/// $XDG_STATE_HOME/trilith/console_history, else ~/.local/state/trilith/console_history; "" where there is no home.
std::filesystem::path history_path();

class LineHistory {
 public:
  /// Reads what is there; at most the last 2000 lines are kept. Nothing goes wrong where there is no such file.
  explicit LineHistory(std::filesystem::path path);

  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }
  /// Adds a line, here and in the file, unless it is empty, begins with a blank or repeats the last one. False where
  /// it was not new. A file that cannot be written is left alone from then on.
  bool add(const std::string& line);
  /// Why the file is not written, once; "" where it is.
  [[nodiscard]] std::string take_complaint();

 private:
  std::filesystem::path path_;
  std::vector<std::string> lines_;
  std::string complaint_;
};

}  // namespace trilith::program
