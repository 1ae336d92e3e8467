// Reads lines: edited, with history and completion, from a terminal; plainly from other input.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "line_history.hpp"

namespace trilith::program {

/// Completions at Tab: names that can replace the text from byte `from` on.
struct Completion {
  std::size_t from = 0;
  std::vector<std::string> names;
};

class LineEditor {
 public:
  enum class Read { line, end, cancelled };  ///< cancelled: Ctrl-C dropped the typed text

  LineEditor();
  LineEditor(const LineEditor&) = delete;
  LineEditor& operator=(const LineEditor&) = delete;
  ~LineEditor();

  /// True for an interactive terminal: both stdin and stdout are terminals.
  [[nodiscard]] bool terminal() const { return terminal_; }
  /// Sets the function that completes `before`, the line up to the cursor.
  void complete_with(std::function<Completion(const std::string& before)> complete);
  /// The next line, without its end. The prompt is shown only on a terminal.
  Read read(const std::string& prompt, std::string& line);

 private:
  class Edited;
  Read read_plain(const std::string& prompt, std::string& line) const;

  bool terminal_, shown_;
  LineHistory history_;
  std::unique_ptr<Edited> edited_;
};

/// The common beginning of all names.
std::string common_start(const std::vector<std::string>& names);

/// Names in columns, for a screen of `width` letters; at most 200 names.
std::string in_columns(const std::vector<std::string>& names, std::size_t width);

}  // namespace trilith::program
