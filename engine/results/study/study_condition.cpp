#include "results/study/study_condition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/error.hpp"

namespace trilith::results {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t from = text.find_first_not_of(' ');
  return from == std::string::npos ? "" : text.substr(from, text.find_last_not_of(' ') - from + 1);
}

/// Longer signs come first.
constexpr std::array signs{">=", "<=", "!=", "==", ">", "<", "="};

struct Comparison {
  std::string name, sign, value;  ///< sign "": a flag alone
};

Comparison parts_of(const std::string& condition) {
  for (std::size_t at = 0; at < condition.size(); ++at)
    for (const char* sign : signs) {
      const std::string s = sign;
      if (condition.compare(at, s.size(), s) != 0) continue;
      return {trimmed(condition.substr(0, at)), s == "==" ? "=" : s, trimmed(condition.substr(at + s.size()))};
    }
  return {trimmed(condition), "", ""};
}

template <class T>
bool compare(const T& a, const std::string& sign, const T& b) {
  if (sign == "=") return a == b;
  if (sign == "!=") return a != b;
  if (sign == ">") return a > b;
  if (sign == ">=") return a >= b;
  return sign == "<" ? a < b : a <= b;
}

const StudyColumn& named_column(const std::vector<StudyColumn>& columns, const std::string& name) {
  const StudyNames names = study_names(columns);
  std::vector<std::string> known = names.figures;
  known.insert(known.end(), names.parameters.begin(), names.parameters.end());
  known.emplace_back("status");
  return study_column(columns, name, known, "figure or parameter");
}

std::vector<Holds> flag_holds(const StudyColumn& column, bool wanted) {
  if (!is_flag(column))
    throw InputError(
        fmt::format("'{}' of the study is not a flag; compare it, as in '{} > 1'", column.name, column.name));
  std::vector<Holds> out;
  for (const double v : study_numbers(column))
    out.push_back(std::isnan(v) ? Holds::unknown : (v != 0) == wanted ? Holds::yes : Holds::no);
  return out;
}

double number_in(const std::string& text, const std::string& condition) {
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size())
    throw InputError(fmt::format("condition '{}': '{}' is not a number", condition, text));
  return value;
}

}  // namespace

std::vector<Holds> condition_of_cases(const std::vector<StudyColumn>& columns, const std::string& condition) {
  const Comparison c = parts_of(condition);
  if (c.sign.empty()) {
    const bool negated = c.name.starts_with("not ");
    return flag_holds(named_column(columns, negated ? trimmed(c.name.substr(4)) : c.name), !negated);
  }
  const StudyColumn& column = named_column(columns, c.name);
  if (is_flag(column) && (c.value == "true" || c.value == "false"))
    return flag_holds(column, (c.value == "true") == (c.sign == "="));
  std::vector<Holds> out;
  if (const auto* texts = std::get_if<std::vector<std::string>>(&column.values)) {
    if (c.sign != "=" && c.sign != "!=")
      throw InputError(fmt::format("condition '{}': '{}' has texts; give = or !=", condition, c.name));
    for (const std::string& t : *texts)
      out.push_back(t.empty() ? Holds::unknown : compare(t, c.sign, c.value) ? Holds::yes : Holds::no);
    return out;
  }
  const double limit = number_in(c.value, condition);
  for (const double v : study_numbers(column))
    out.push_back(std::isnan(v) ? Holds::unknown : compare(v, c.sign, limit) ? Holds::yes : Holds::no);
  return out;
}

}  // namespace trilith::results
