#include "run/study/study_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/error.hpp"

namespace trilith {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A number, a flag as 1 or 0, or NaN for a text.
template <class Value>
double number_of_value(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? 1 : 0;
  return none;
}

/// Column of numbers or flags, or of texts if the values are of different kinds. `all[i]` is nullptr if case i has no
/// value.
template <class Value, class Text>
results::StudyColumn value_column(results::StudyColumn column, const std::vector<const Value*>& all, Text&& text) {
  const auto every = [&](auto&& is) {
    return std::all_of(all.begin(), all.end(), [&](const Value* v) { return v == nullptr || is(*v); });
  };
  const bool flags = every([](const Value& v) { return std::holds_alternative<bool>(v); });
  if (flags || every([](const Value& v) { return std::holds_alternative<double>(v); })) {
    std::vector<double> values;
    for (const Value* v : all) values.push_back(v == nullptr ? none : number_of_value(*v));
    column.values = std::move(values);
    if (flags) column.unit = results::flag_unit;
    return column;
  }
  std::vector<std::string> values;
  for (std::size_t i = 0; i < all.size(); ++i) values.push_back(all[i] == nullptr ? "" : text(i));
  column.values = std::move(values);
  return column;
}

results::StudyColumn parameter_column(const StudyPlan& plan, std::size_t k) {
  std::vector<const StudyValue*> all;
  for (const auto& row : plan.cases) all.push_back(&row[k]);
  return value_column({plan.names[k], plan.units[k], results::parameter_text, {}}, all,
                      [&](std::size_t i) { return text_of(plan.cases[i][k]); });
}

/// For each name, the first figure with this name.
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

results::StudyColumn figure_column(const StudyFigure& figure, const std::vector<StudyOutcome>& outcomes) {
  using Value = decltype(StudyFigure::value);
  std::vector<const Value*> all;
  for (const StudyOutcome& o : outcomes) {
    const StudyFigure* f = find_figure(o, figure.name);
    all.push_back(f == nullptr ? nullptr : &f->value);
  }
  return value_column({figure.name, figure.unit, results::figure_text, {}}, all,
                      [&](std::size_t i) { return figure_value_text(*find_figure(outcomes[i], figure.name)); });
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
  columns.push_back(outcome_column<std::string>("status", "", "finished, failed, not run, or passed over", outcomes,
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
