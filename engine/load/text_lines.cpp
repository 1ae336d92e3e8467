#include "load/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/error.hpp"

namespace trilith {

namespace {
constexpr std::string_view blanks = " \t\r";
}

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string_view without_padding(std::string_view text) {
  constexpr std::string_view padding("\x1a\0", 2);
  const std::size_t last = text.find_last_not_of(std::string(padding) + " \t\r\n");
  const std::size_t mark = text.find_first_of(padding, last == std::string_view::npos ? 0 : last);
  return text.substr(0, std::min(mark, text.size()));
}

std::vector<std::string_view> words_of(std::string_view text, std::string_view separators) {
  const std::string between = std::string(blanks) + std::string(separators);
  std::vector<std::string_view> words;
  for (std::size_t begin = text.find_first_not_of(between); begin != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(between, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(between, end);
  }
  return words;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

/// All of the text must be the number, and a finite one.
std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<std::string_view> TextLines::next() {
  if (rest_.empty()) return std::nullopt;
  const std::size_t end = std::min(rest_.find('\n'), rest_.size());
  std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  ++number_;
  return line;
}

void TextLines::fail(const std::string& message) const {
  throw InputError(fmt::format("motion file '{}' line {}: {}", name_, number_, message));
}

void TextLines::fail_whole(const std::string& message) const {
  throw InputError(fmt::format("motion file '{}': {}", name_, message));
}

double TextLines::require_number(std::string_view text, std::string_view what) const {
  const auto value = number_in(text);
  std::string pointed(text);
  if (!value && std::count(text.begin(), text.end(), ',') == 1) {
    std::replace(pointed.begin(), pointed.end(), ',', '.');
    if (number_in(pointed))
      fail(fmt::format("{} is '{}', must have a decimal point, as {}", what, shown(text), pointed));
  }
  if (!value) fail(fmt::format("{} is '{}', must be a finite number", what, shown(text)));
  return *value;
}

std::size_t TextLines::require_count(std::string_view text, std::string_view what) const {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 1)
    fail(fmt::format("{} is '{}', must be a whole number above 0", what, shown(text)));
  return value;
}

/// For messages: no control characters, and not the whole of a long line.
std::string shown(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string clean(text.substr(0, longest));
  for (char& c : clean)
    if (c < ' ' || c > '~') c = '?';
  return text.size() > longest ? clean + "..." : clean;
}

}  // namespace trilith
