// Private to report/: HTML, written piece by piece in order.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trilith::report {

/// `text` as it stands between tags or within a quoted attribute: & < > " ' written as entities, control characters
/// but tab and line feed as blanks, bytes that are no part of valid UTF-8 as '?'.
std::string html_escaped(std::string_view text);

/// Every text is escaped and every element closed; that ends fit beginnings is the caller's business (asserted). Tags
/// and attributes are our own words.
class HtmlText {
 public:
  /// `attributes` as they stand in the tag, e.g. R"(class="wide")".
  HtmlText& open(std::string_view tag, std::string_view attributes = {});
  HtmlText& close();  ///< the innermost element
  HtmlText& text(std::string_view value);
  /// <tag attributes>value</tag>
  HtmlText& element(std::string_view tag, std::string_view value, std::string_view attributes = {});
  /// As it is: whole elements that are known to be well-formed.
  HtmlText& raw(std::string_view elements);

  /// A table: its heading, then each row; every row as many cells as there are headings. Columns from `numbers_from` on
  /// are set to the right.
  HtmlText& table(const std::vector<std::string>& heading, const std::vector<std::vector<std::string>>& rows,
                  std::size_t numbers_from);

  /// What was written; all elements must have been closed.
  std::string take();

 private:
  std::string out_;
  std::vector<std::string> open_;
};

}  // namespace trilith::report
