// Output: a terminal with a last line that is redrawn, or plain lines.
#pragma once

#include <cstdio>
#include <string>

#include "base/unit_system.hpp"

namespace trilith::program {

class Screen {
 public:
  /// `out` is a terminal unless the environment variable TERM is dumb; colours unless NO_COLOR is set.
  explicit Screen(std::FILE* out);
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;
  ~Screen();

  [[nodiscard]] bool is_terminal() const { return terminal_; }
  /// Numbers with an SI unit are written in these units from now on.
  void show_in(const UnitSystem& units) { units_ = units; }
  /// A whole line, above the status if there is one; `strong`: in bold on a terminal with colours.
  void line(const std::string& text, bool strong = false);
  /// Redraws the status, cut to the terminal's width. Does nothing without a terminal.
  void status(const std::string& text);
  /// Removes the status before other output.
  void clear();

 private:
  std::FILE* out_;
  UnitSystem units_;
  bool terminal_, colours_, shown_ = false;
};

/// At most `columns` characters of UTF-8 text.
std::string cut_text(const std::string& text, std::size_t columns);

}  // namespace trilith::program
