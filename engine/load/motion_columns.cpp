#include "load/motion_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/nearest.hpp"
#include "base/portable.hpp"

namespace trilith {
namespace {

constexpr std::string_view number_letters = "0123456789+-eE,; \t";

bool digit_at(std::string_view text, std::size_t at) {
  return at < text.size() && text[at] >= '0' && text[at] <= '9';
}

/// The first number with a decimal comma, if every comma of the file can be one: it is between two digits, and no
/// number has a point. If commas separate columns, some acceleration is negative, so that a sign follows a comma.
std::string decimal_comma_in(std::string_view text, int skip) {
  TextLines lines(text, "");
  std::string first;
  while (const auto given = lines.next()) {
    const std::string_view line = trimmed(*given);
    if (lines.number() <= skip || line.empty() || line[0] == '#' || line[0] == '%') continue;
    if (line.find_first_not_of(std::string(number_letters) + ".") != std::string_view::npos) continue;
    if (line.find('.') != std::string_view::npos) return "";
    for (std::size_t at = line.find(','); at != std::string_view::npos; at = line.find(',', at + 1)) {
      if (at == 0 || !digit_at(line, at - 1) || !digit_at(line, at + 1)) return "";
      if (!first.empty()) continue;
      const std::size_t begin = line.find_last_of(" \t;", at) + 1;  // 0 where there is none
      first = line.substr(begin, std::min(line.find_first_of(" \t;", at), line.size()) - begin);
    }
  }
  return first;
}

/// The smallest decimal of a number as written: 0.01 for "3.25", 1e-7 for "1.00e-5".
double resolution_of(std::string_view word) {
  const std::size_t mark = std::min(word.find_first_of("eEdD"), word.size());
  const std::size_t point = word.substr(0, mark).find('.');
  int decimals = point == std::string_view::npos ? 0 : static_cast<int>(mark - point) - 1, power = 0;
  if (mark < word.size()) {
    std::string_view exponent = word.substr(mark + 1);
    if (exponent.starts_with('+')) exponent.remove_prefix(1);
    std::from_chars(exponent.data(), exponent.data() + exponent.size(), power);
  }
  return portable::pow(10.0, power - decimals);
}

/// Names in a line of the head: split at commas, semicolons or tabs if it has any, otherwise at blanks; a unit in
/// brackets belongs to the name before it. Empty unless there are `width` names.
std::vector<std::string> names_in(std::string_view line, std::size_t width) {
  std::vector<std::string> names;
  if (line.find_first_of(",;\t") != std::string_view::npos) {
    for (std::size_t begin = 0; begin <= line.size();) {
      const std::size_t end = std::min(line.find_first_of(",;\t", begin), line.size());
      names.emplace_back(trimmed(line.substr(begin, end - begin)));
      begin = end + 1;
    }
    while (!names.empty() && names.back().empty()) names.pop_back();
  } else {
    for (const std::string_view word : words_of(line))
      if (!names.empty() && (word[0] == '(' || word[0] == '['))
        names.back() += " " + std::string(word);
      else
        names.emplace_back(word);
  }
  if (names.size() != width) names.clear();
  for (std::string& name : names) name = shown(name);
  return names;
}

class TableReader {
 public:
  TableReader(TextLines& lines, const PlainForm& form) : lines_(lines), comma_(form.decimal == ',') {}

  void read(std::string_view line) {
    if (line[0] == '#' || line[0] == '%') {
      if (table_.values.empty()) last_head_ = trimmed(line.substr(1));
      return;
    }
    const std::vector<std::string_view> words = words_of(line, comma_ ? ";" : ",;");
    if (table_.values.empty() && (words.empty() || !number(words[0]))) {
      table_.title += (table_.title.empty() ? "" : ", ") + shown(line);
      last_head_ = line;
      return;
    }
    add_row(words);
  }
  NumberTable take() && {
    if (table_.width > 1) table_.names = names_in(last_head_, table_.width);
    return std::move(table_);
  }

 private:
  std::optional<double> number(std::string_view word) {
    if (!comma_) return number_in(word);
    point_ = word;
    std::replace(point_.begin(), point_.end(), ',', '.');
    return number_in(point_);
  }
  void add_row(const std::vector<std::string_view>& words) {
    if (words.empty()) return;
    const bool first = table_.values.empty();
    if (first)
      table_.width = words.size(), table_.resolution.assign(words.size(), 1e300), first_line_ = lines_.number();
    if (words.size() > table_.width || table_.ragged()) fail_width(table_.ragged() ? last_size_ : words.size());
    for (std::size_t i = 0; i < words.size(); ++i) {
      const auto value = number(words[i]);
      if (!value)
        lines_.fail(
            fmt::format("value is '{}', must be a finite number; if it is part of the header, give the number of "
                        "header lines (skip = {})",
                        shown(words[i]), lines_.number()));
      table_.values.push_back(*value);
      table_.resolution[i] = std::min(table_.resolution[i], resolution_of(comma_ ? point_ : std::string(words[i])));
    }
    last_size_ = words.size(), last_line_ = lines_.number();
  }
  /// A short row must be the last one; rows after it have other columns.
  [[noreturn]] void fail_width(std::size_t size) {
    const int line = table_.ragged() ? last_line_ : lines_.number();
    lines_.fail(
        fmt::format("row of line {} has {} columns, the first row of numbers (line {}) has {}; if the lines above it "
                    "are a header, give their number (skip = {})",
                    line, size, first_line_, table_.width, line - 1));
  }

  TextLines& lines_;
  bool comma_;
  NumberTable table_;
  std::string last_head_, point_;
  std::size_t last_size_ = 0;
  int first_line_ = 0, last_line_ = 0;
};

/// True if a column increases like a time. A few numbers may increase by chance, so they must also be evenly spaced.
bool grows(const NumberTable& table, std::size_t column) {
  const std::size_t n = table.rows();
  if (n < 2 || !(table.at(n - 1, column) > table.at(0, column))) return false;
  const double first = table.at(0, column), step = (table.at(n - 1, column) - first) / static_cast<double>(n - 1);
  const double allowed = std::max(0.1 * step, 1.01 * table.resolution[column]);
  for (std::size_t i = 1; i < n; ++i) {
    if (table.at(i, column) < table.at(i - 1, column)) return false;
    if (n < 5 && std::abs(table.at(i, column) - first - static_cast<double>(i) * step) > allowed) return false;
  }
  return true;
}

std::size_t growing_column(const NumberTable& table, std::size_t but) {
  for (std::size_t c = 0; c < table.width; ++c)
    if (c != but && grows(table, c)) return c;
  return RecordColumns::none;
}

/// "1 't' (grows from 0 to 40, as a time does), 2 'ns' (up to 341.7)".
std::string listed(const NumberTable& table) {
  std::string text;
  for (std::size_t c = 0; c < table.width; ++c) {
    double peak = 0;
    for (std::size_t i = 0; i < table.rows(); ++i) peak = std::max(peak, std::abs(table.at(i, c)));
    const std::string about = grows(table, c) ? fmt::format("increases from {:g} to {:g}, like a time", table.at(0, c),
                                                            table.at(table.rows() - 1, c))
                                              : fmt::format("up to {:g}", peak);
    text += fmt::format("{}{}{} ({})", text.empty() ? "" : ", ", c + 1,
                        table.names.empty() ? "" : " '" + table.names[c] + "'", about);
  }
  return text;
}

/// With several columns, the script must specify the record.
[[noreturn]] void ask_column(const NumberTable& table, std::size_t time, const TextLines& lines) {
  const std::size_t proposed = time == 0 ? 1 : 0;
  const std::string by_name = table.names.empty() || table.names[proposed].empty()
                                  ? ""
                                  : fmt::format(" or column = \"{}\"", table.names[proposed]);
  lines.fail_whole(fmt::format("has {} columns: {}; name the column of the acceleration, as in column = {}{}{}",
                               table.width, listed(table), proposed + 1, by_name,
                               time == RecordColumns::none
                                   ? " with the step dt, or column = \"rows\" if samples continue from line to line"
                                   : ""));
}

/// Lower case, without a unit in brackets.
std::string plain_name(std::string_view name) {
  return lower_case(trimmed(name.substr(0, std::min(name.find_first_of("(["), name.size()))));
}

std::size_t column_named(const NumberTable& table, const std::string& given, const TextLines& lines) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(given.data(), given.data() + given.size(), number);
  if (error == std::errc() && end == given.data() + given.size()) {
    if (number >= 1 && number <= table.width) return number - 1;
    lines.fail_whole(fmt::format("column = {}, must be 1 to {}: {}", given, table.width, listed(table)));
  }
  for (std::size_t c = 0; c < table.names.size(); ++c)
    if (lower_case(table.names[c]) == lower_case(given) || plain_name(table.names[c]) == lower_case(given)) return c;
  if (table.names.empty())
    lines.fail_whole(
        fmt::format("column = \"{}\", but its columns have no names; give a number: {}", shown(given), listed(table)));
  lines.fail_whole(fmt::format("has no column '{}'{}", shown(given), name_hint(given, table.names)));
}

}  // namespace

std::vector<double> NumberTable::column(std::size_t index) const {
  std::vector<double> numbers;
  numbers.reserve(rows());
  for (std::size_t i = 0; i < rows(); ++i) numbers.push_back(at(i, index));
  return numbers;
}

NumberTable read_number_table(TextLines& lines, std::string_view text, const PlainForm& form) {
  const int skip = form.skip.value_or(0);
  if (form.decimal == 0)
    if (const std::string comma = decimal_comma_in(text, skip); !comma.empty())
      lines.fail_whole(
          fmt::format("has numbers like '{}': set decimal = \",\" for decimal commas, or decimal = \".\" if the comma "
                      "separates two columns",
                      shown(comma)));
  TableReader reader(lines, form);
  while (const auto line = lines.next()) {
    const std::string_view content = trimmed(*line);
    if (!content.empty() && lines.number() > skip) reader.read(content);
  }
  return std::move(reader).take();
}

RecordColumns find_record_columns(const NumberTable& table, const PlainForm& form, const TextLines& lines) {
  constexpr std::size_t none = RecordColumns::none;
  const std::string asked = lower_case(form.column);
  if (!asked.empty() && asked != "rows") {
    const std::size_t chosen = column_named(table, form.column, lines);
    const std::size_t time = growing_column(table, chosen);
    if (time == none && !form.step) lines.fail_whole("has no column of times; give the time step of the samples (dt)");
    if (table.ragged()) lines.fail("row has fewer columns than the first one");
    return {time, chosen};
  }
  const auto all = [&]() -> RecordColumns {
    if (!form.step)
      lines.fail_whole(
          fmt::format("has {} column(s) and no time; give the time step of the samples (dt)", table.width));
    return {};
  };
  if (asked == "rows" || table.width == 1 || table.ragged()) return all();
  const std::size_t time = growing_column(table, none);
  const bool second_alone = time == 1 && table.rows() >= 5;
  if (table.width == 2 && (time == 0 || (!second_alone && !form.step))) return {0, 1};
  if (time == none && table.names.empty() && table.width > 3) return all();
  ask_column(table, time, lines);
}

}  // namespace trilith
