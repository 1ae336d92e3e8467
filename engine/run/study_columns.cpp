#include "run/study_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/error.hpp"

namespace trilith {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

results::StudyColumn parameter_column(const StudyPlan& plan, std::size_t k) {
  results::StudyColumn column{plan.names[k], plan.units[k], "parameter", {}};
  const bool numbers = std::all_of(plan.cases.begin(), plan.cases.end(),
                                   [k](const auto& row) { return std::holds_alternative<double>(row[k]); });
  if (numbers) {
    std::vector<double> values;
    for (const auto& row : plan.cases) values.push_back(std::get<double>(row[k]));
    column.values = std::move(values);
  } else {
    std::vector<std::string> values;
    for (const auto& row : plan.cases) values.push_back(text_of(row[k]));
    column.values = std::move(values);
  }
  return column;
}

/// Of each name the first figure that has it.
std::vector<const StudyFigure*> known_figures(const std::vector<StudyOutcome>& outcomes) {
  std::vector<const StudyFigure*> known;
  for (const StudyOutcome& o : outcomes)
    for (const StudyFigure& f : o.figures)
      if (std::none_of(known.begin(), known.end(), [&](const StudyFigure* k) { return k->name == f.name; }))
        known.push_back(&f);
  return known;
}

const StudyFigure* find_figure(const StudyOutcome& outcome, const std::string& name) {
  for (const StudyFigure& f : outcome.figures)
    if (f.name == name) return &f;
  return nullptr;
}

/// Numbers where all that have the figure give numbers, else texts.
results::StudyColumn figure_column(const StudyFigure& figure, const std::vector<StudyOutcome>& outcomes) {
  std::vector<double> numbers;
  std::vector<std::string> texts;
  bool is_number = true;
  for (const StudyOutcome& o : outcomes) {
    const StudyFigure* f = find_figure(o, figure.name);
    const auto* number = f == nullptr ? nullptr : std::get_if<double>(&f->value);
    is_number = is_number && (f == nullptr || number != nullptr);
    numbers.push_back(number == nullptr ? none : *number);
    texts.push_back(f == nullptr ? "" : number != nullptr ? fmt::format("{}", *number) : std::get<1>(f->value));
  }
  results::StudyColumn column{figure.name, figure.unit, "figure that the case gave", {}};
  if (is_number)
    column.values = std::move(numbers);
  else
    column.values = std::move(texts);
  return column;
}

template <class T, class Get>
results::StudyColumn outcome_column(const char* name, const char* unit, const char* description,
                                    const std::vector<StudyOutcome>& outcomes, Get&& get) {
  std::vector<T> values;
  for (const StudyOutcome& o : outcomes) values.push_back(get(o));
  return {name, unit, description, std::move(values)};
}

}  // namespace

void check_figure_names(const StudyPlan& plan, const std::vector<StudyFigure>& figures) {
  std::vector<std::string> taken = plan.names;
  taken.insert(taken.end(), study_columns().begin(), study_columns().end());
  for (const StudyFigure& f : figures) {
    if (std::find(taken.begin(), taken.end(), f.name) != taken.end())
      throw InputError(
          fmt::format("figure '{}' has the name of a parameter or of another column; give it its own", f.name));
    taken.push_back(f.name);
  }
}

std::vector<results::StudyColumn> study_table_columns(const StudyPlan& plan,
                                                      const std::vector<StudyOutcome>& outcomes) {
  std::vector<results::StudyColumn> columns;
  std::vector<std::int32_t> numbers;
  for (std::size_t i = 0; i < outcomes.size(); ++i) numbers.push_back(static_cast<std::int32_t>(i) + 1);
  columns.push_back({"case", "1", "number of the case, from 1", numbers});
  for (std::size_t k = 0; k < plan.names.size(); ++k) columns.push_back(parameter_column(plan, k));
  for (const StudyFigure* f : known_figures(outcomes)) columns.push_back(figure_column(*f, outcomes));
  columns.push_back(outcome_column<std::string>("status", "", "finished, failed or not run", outcomes,
                                                [](const auto& o) { return std::string(name_of(o.status)); }));
  columns.push_back(outcome_column<std::int32_t>("exit", "1", "exit code; -1: ended by a signal", outcomes,
                                                 [](const auto& o) { return o.exit; }));
  columns.push_back(outcome_column<double>("seconds", "s", "wall clock of the case", outcomes,
                                           [](const auto& o) { return o.seconds; }));
  columns.push_back(
      outcome_column<std::string>("message", "", "why it failed", outcomes, [](const auto& o) { return o.message; }));
  columns.push_back(outcome_column<std::string>("folder", "", "results, log and errors of the case", outcomes,
                                                [](const auto& o) { return o.folder.string(); }));
  return columns;
}

}  // namespace trilith
