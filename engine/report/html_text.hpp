// Private to report/: HTML, written sequentially.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/unit_system.hpp"

namespace trilith::report {

/// `text` for use between tags or within a quoted attribute: & < > " ' as entities, control characters except tab and
/// line feed as blanks, invalid UTF-8 bytes as '?'.
std::string html_escaped(std::string_view text);

/// Every text is escaped and every element closed; the caller must match begins and ends (asserted). Tags and
/// attributes are internal. Numbers with an SI unit are written in the units of the report; UnitSystem::message of a
/// converted number is the same number.
class HtmlText {
 public:
  explicit HtmlText(UnitSystem units = {}) : units_(std::move(units)) {}

  /// `attributes` in the syntax of the tag, e.g. R"(class="wide")".
  HtmlText& open(std::string_view tag, std::string_view attributes = {});
  HtmlText& close();  ///< the innermost element
  HtmlText& text(std::string_view value);
  /// A text of the user, such as a name or a script: numbers in it stay as they are.
  HtmlText& verbatim(std::string_view value);
  /// <tag attributes>value</tag>
  HtmlText& element(std::string_view tag, std::string_view value, std::string_view attributes = {});
  /// Writes complete, well-formed elements without escaping.
  HtmlText& raw(std::string_view elements);

  /// A table: its heading, then rows with one cell for each heading. Columns from `numbers_from` on are right-aligned.
  HtmlText& table(const std::vector<std::string>& heading, const std::vector<std::vector<std::string>>& rows,
                  std::size_t numbers_from);

  /// Returns the text; all elements must have been closed.
  std::string take();

 private:
  UnitSystem units_;
  std::string out_;
  std::vector<std::string> open_;
};

}  // namespace trilith::report
