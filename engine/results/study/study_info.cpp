#include "results/study/study_info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "results/study/study_condition.hpp"
#include "results/study/study_statistics.hpp"

namespace trilith::results {
namespace {

std::string with_unit(const StudyColumn& column) {
  return column.unit.empty() || column.unit == "1" || is_flag(column)
             ? column.name
             : fmt::format("{} ({})", column.name, column.unit);
}

const StudyColumn* column_if(const std::vector<StudyColumn>& columns, const std::string& name) {
  const auto found = std::find_if(columns.begin(), columns.end(), [&](const auto& c) { return c.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

std::size_t row_count_of(const std::vector<StudyColumn>& columns) {
  return columns.empty() ? 0 : std::visit([](const auto& v) { return v.size(); }, columns[0].values);
}

/// Values of a parameter, in the order of the cases; for many values the first and the last.
std::string values_text(const StudyColumn& column, std::size_t rows) {
  constexpr std::size_t most = 12;
  std::vector<std::string> seen;
  for (std::size_t i = 0; i < rows; ++i) {
    const std::string text = study_text(column, i);
    if (std::find(seen.begin(), seen.end(), text) == seen.end()) seen.push_back(text);
  }
  if (seen.size() <= most) return fmt::format("{}", fmt::join(seen, ", "));
  if (const auto* numbers = std::get_if<std::vector<double>>(&column.values)) {
    const auto [low, high] = std::minmax_element(numbers->begin(), numbers->end());
    return fmt::format("{} values from {:.6g} to {:.6g}", seen.size(), *low, *high);
  }
  return fmt::format("{} values: {}, {}, ... {}", seen.size(), seen[0], seen[1], seen.back());
}

std::string probability_words(const Tally& tally) {
  const Confidence c = wilson_interval(tally.hits, tally.count);
  if (tally.count == 0) return "no case has a result";
  return fmt::format("{} of {}, probability {:.3g}, 95 % between {:.3g} and {:.3g} (Wilson)", tally.hits, tally.count,
                     static_cast<double>(tally.hits) / tally.count, c.low, c.high);
}

std::string number_words(const std::vector<double>& values) {
  const Spread s = spread_of(values);
  if (s.count == 0) return "no case has a value";
  if (s.count == 1) return fmt::format("{:.4g} (one case)", s.median);
  std::string text = fmt::format("median {:.4g}, 16 to 84 % {:.4g} to {:.4g}, range {:.4g} to {:.4g}", s.median,
                                 s.lower, s.upper, s.low, s.high);
  if (std::isfinite(s.dispersion)) text += fmt::format(", dispersion {:.3g}", s.dispersion);
  return text + fmt::format(" ({} cases)", s.count);
}

std::string text_words(const std::vector<std::string>& values) {
  std::map<std::string, int> counts;
  for (const std::string& v : values)
    if (!v.empty()) ++counts[v];
  std::string text;
  for (const auto& [value, count] : counts) text += fmt::format("{}{} of {}", text.empty() ? "" : ", ", count, value);
  return text.empty() ? "no case has a value" : text;
}

std::string figure_words(const StudyColumn& column) {
  if (const auto* texts = std::get_if<std::vector<std::string>>(&column.values)) return text_words(*texts);
  const auto& numbers = std::get<std::vector<double>>(column.values);
  if (!is_flag(column)) return number_words(numbers);
  Tally tally;
  for (const double v : numbers) tally.add(std::isnan(v) ? Holds::unknown : v != 0 ? Holds::yes : Holds::no);
  return probability_words(tally);
}

std::string status_lines(const std::vector<StudyColumn>& columns, std::size_t rows) {
  const StudyColumn *status = column_if(columns, "status"), *message = column_if(columns, "message");
  std::string text = fmt::format("study of {} case{}", rows, rows == 1 ? "" : "s");
  if (status == nullptr) return text + "\n";
  std::map<std::string, int> counts;
  std::string failures;
  constexpr int most_told = 5;
  for (std::size_t i = 0; i < rows; ++i) {
    const std::string word = study_text(*status, i);
    if (++counts[word] > most_told || word != "failed" || message == nullptr) continue;
    failures += fmt::format("case {}: {}\n", i + 1, study_text(*message, i));
  }
  for (const auto& [word, count] : counts) text += fmt::format(", {} {}", count, word);
  text += "\n" + failures;
  if (counts["failed"] > most_told) text += fmt::format("and {} more that failed\n", counts["failed"] - most_told);
  return text;
}

}  // namespace

std::string study_info_text(const std::vector<StudyColumn>& columns) {
  const std::size_t rows = row_count_of(columns);
  std::string text = status_lines(columns, rows);
  const StudyNames names = study_names(columns);
  for (const char* head : {"parameters", "figures"}) {
    const bool figures = std::string(head) == "figures";
    const auto& list = figures ? names.figures : names.parameters;
    if (!list.empty()) text += fmt::format("{}:\n", head);
    for (const std::string& name : list) {
      const StudyColumn& c = *column_if(columns, name);
      text += fmt::format("  {}: {}\n", with_unit(c), figures ? figure_words(c) : values_text(c, rows));
    }
  }
  return text;
}

std::string study_probability_text(const std::vector<StudyColumn>& columns, const std::string& condition,
                                   const std::string& over) {
  const std::vector<Holds> holds = condition_of_cases(columns, condition);
  if (over.empty()) {
    Tally all;
    for (const Holds h : holds) all.add(h);
    return fmt::format("{}: {}\n", condition, probability_words(all));
  }
  const StudyColumn& x = study_column(columns, over, study_names(columns).parameters, "parameter");
  std::vector<std::string> order;
  std::map<std::string, Tally> tallies;
  for (std::size_t i = 0; i < holds.size(); ++i) {
    const std::string value = study_text(x, i);
    if (!tallies.contains(value)) order.push_back(value);
    tallies[value].add(holds[i]);
  }
  std::string text;
  const std::string unit = x.unit.empty() || x.unit == "1" || is_flag(x) ? "" : " " + x.unit;
  for (const std::string& value : order)
    text += fmt::format("{} {}{}, {}: {}\n", x.name, value, unit, condition, probability_words(tallies[value]));
  const StudyColumn* status = column_if(columns, "status");
  int passed = 0;
  for (std::size_t i = 0; status != nullptr && i < holds.size(); ++i)
    passed += study_text(*status, i) == "passed over" ? 1 : 0;
  if (passed > 0)
    text += fmt::format("not counted: {} cases that were passed over; trilith plot --fragility counts them\n", passed);
  return text;
}

}  // namespace trilith::results
