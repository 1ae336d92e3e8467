#include "report/html_text.hpp"

#include <cassert>

#include "base/markup.hpp"
#include "draw/picture_text.hpp"

namespace trilith::report {
namespace {

/// Valid UTF-8 with its line feeds and tabs.
std::string printable_lines(std::string_view text) {
  std::string out;
  while (true) {
    const std::size_t end = text.find_first_of("\n\t");
    out += draw::printable_utf8(text.substr(0, end));
    if (end == std::string_view::npos) return out;
    out += text[end];
    text.remove_prefix(end + 1);
  }
}

}  // namespace

std::string html_escaped(std::string_view text) {
  return markup_text(printable_lines(text));
}

HtmlText& HtmlText::open(std::string_view tag, std::string_view attributes) {
  out_ += '<';
  out_ += tag;
  if (!attributes.empty()) out_ += ' ';
  out_ += attributes;
  out_ += '>';
  open_.emplace_back(tag);
  return *this;
}

HtmlText& HtmlText::close() {
  assert(!open_.empty());
  out_ += "</" + open_.back() + ">";
  // Line feeds in the source where white space has no effect.
  if (open_.back() != "code" && open_.back() != "b" && open_.back() != "time" && open_.back() != "span") out_ += '\n';
  open_.pop_back();
  return *this;
}

HtmlText& HtmlText::text(std::string_view value) {
  return verbatim(units_.message(value));
}

HtmlText& HtmlText::verbatim(std::string_view value) {
  out_ += html_escaped(value);
  return *this;
}

HtmlText& HtmlText::element(std::string_view tag, std::string_view value, std::string_view attributes) {
  return open(tag, attributes).text(value).close();
}

HtmlText& HtmlText::raw(std::string_view elements) {
  out_ += elements;
  return *this;
}

HtmlText& HtmlText::table(const std::vector<std::string>& heading, const std::vector<std::vector<std::string>>& rows,
                          std::size_t numbers_from) {
  const auto look = [&](std::size_t column) {
    return column >= numbers_from ? std::string_view(R"(class="n")") : std::string_view();
  };
  open("table").open("thead").open("tr");
  for (std::size_t i = 0; i < heading.size(); ++i) element("th", heading[i], look(i));
  close().close().open("tbody");
  for (const std::vector<std::string>& row : rows) {
    assert(row.size() == heading.size());
    open("tr");
    for (std::size_t i = 0; i < row.size(); ++i) element("td", row[i], look(i));
    close();
  }
  return close().close();
}

std::string HtmlText::take() {
  assert(open_.empty());
  return std::move(out_);
}

}  // namespace trilith::report
