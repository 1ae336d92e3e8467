// Access to the columns of a study's table.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "results/study/study_table.hpp"

namespace trilith::results {

StudyNames study_names(const std::vector<StudyColumn>& columns) {
  StudyNames names;
  for (const StudyColumn& c : columns) {
    if (c.description == parameter_text) names.parameters.push_back(c.name);
    if (c.description == figure_text) names.figures.push_back(c.name);
  }
  return names;
}

const StudyColumn& study_column(const std::vector<StudyColumn>& columns, const std::string& name,
                                const std::vector<std::string>& known, const char* kind) {
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw InputError(fmt::format("the study has no {} '{}'{}", kind, name, name_hint(name, known)));
  return *std::find_if(columns.begin(), columns.end(), [&](const StudyColumn& c) { return c.name == name; });
}

const std::vector<double>& study_numbers(const StudyColumn& column) {
  const auto* numbers = std::get_if<std::vector<double>>(&column.values);
  if (numbers == nullptr) throw InputError(fmt::format("'{}' of the study has texts, not numbers", column.name));
  return *numbers;
}

std::string study_text(const StudyColumn& column, std::size_t row) {
  if (const auto* texts = std::get_if<std::vector<std::string>>(&column.values)) return (*texts)[row];
  if (const auto* whole = std::get_if<std::vector<std::int32_t>>(&column.values)) return std::to_string((*whole)[row]);
  const double value = std::get<std::vector<double>>(column.values)[row];
  if (std::isnan(value)) return "";
  if (is_flag(column)) return value != 0 ? "true" : "false";
  return fmt::format("{:.6g}", value);
}

}  // namespace trilith::results
