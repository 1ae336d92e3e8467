#include "draw/study_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.hpp"
#include "base/nearest.hpp"

namespace trilith::draw {
namespace {

using results::StudyColumn;

const std::vector<double>& numbers(const StudyColumn& column) {
  return std::get<std::vector<double>>(column.values);
}

bool is_parameter(const StudyColumn& column) {
  return column.description == "parameter";
}
bool is_figure(const StudyColumn& column) {
  return column.description == "figure that the case gave";
}

const StudyColumn& column_called(const std::vector<StudyColumn>& columns, const std::string& name,
                                 const std::vector<std::string>& known, const char* kind) {
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw InputError(fmt::format("the study has no {} '{}'{}", kind, name, name_hint(name, known)));
  return *std::find_if(columns.begin(), columns.end(), [&](const StudyColumn& c) { return c.name == name; });
}

std::string first_varied(const std::vector<StudyColumn>& columns) {
  for (const StudyColumn& c : columns) {
    if (!is_parameter(c)) continue;
    const auto [low, high] = std::minmax_element(numbers(c).begin(), numbers(c).end());
    if (*low < *high) return c.name;
  }
  throw InputError("no parameter of the study takes several values, so there is nothing to draw over");
}

/// What the cases of one value of the parameter gave.
struct Spread {
  double sum = 0, low = 0, high = 0;
  int count = 0;
  void add(double value) {
    low = count == 0 ? value : std::min(low, value);
    high = count == 0 ? value : std::max(high, value);
    sum += value;
    ++count;
  }
};

std::map<double, Spread> spread_over(const StudyColumn& over, const StudyColumn& figure) {
  std::map<double, Spread> spreads;
  for (std::size_t i = 0; i < numbers(over).size(); ++i)
    if (std::isfinite(numbers(figure)[i])) spreads[numbers(over)[i]].add(numbers(figure)[i]);
  return spreads;
}

void add_series(const StudyColumn& over, const StudyColumn& figure, ChartPanel& panel) {
  ChartSeries mean{figure.name, {}, {}}, low{figure.name, {}, {}, Dash::dashed},
      high{figure.name, {}, {}, Dash::dashed};
  mean.points = true;
  for (const auto& [x, s] : spread_over(over, figure)) {
    for (ChartSeries* series : {&mean, &low, &high}) series->x.push_back(x);
    mean.y.push_back(s.sum / s.count), low.y.push_back(s.low), high.y.push_back(s.high);
  }
  if (mean.x.empty()) return;
  for (ChartSeries* series : {&mean, &low, &high}) panel.series.push_back(std::move(*series));
}

AxisScale scale_of(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *low > 0 && *high >= 100 * *low ? AxisScale::logarithmic : AxisScale::linear;
}

}  // namespace

StudyNames study_names(const std::vector<StudyColumn>& columns) {
  StudyNames names;
  for (const StudyColumn& c : columns) {
    if (is_parameter(c)) names.parameters.push_back(c.name);
    if (is_figure(c)) names.figures.push_back(c.name);
  }
  return names;
}

Chart study_chart(const std::vector<StudyColumn>& columns, const std::string& over,
                  const std::vector<std::string>& figures) {
  const StudyNames names = study_names(columns);
  if (names.figures.empty() || columns.empty() || numbers(columns[0]).empty())
    throw InputError("the study has no case with a figure yet");
  const StudyColumn& x =
      column_called(columns, over.empty() ? first_varied(columns) : over, names.parameters, "parameter");
  Chart chart;
  chart.x = {x.name, x.unit, scale_of(numbers(x))};
  for (const std::string& name : figures.empty() ? names.figures : figures) {
    const StudyColumn& figure = column_called(columns, name, names.figures, "figure");
    auto panel = std::find_if(chart.panels.begin(), chart.panels.end(),
                              [&](const ChartPanel& p) { return p.y.unit == figure.unit; });
    if (panel == chart.panels.end()) {
      chart.panels.push_back({{"figures, mean and range", figure.unit}, {}});
      panel = chart.panels.end() - 1;
    }
    add_series(x, figure, *panel);
  }
  std::erase_if(chart.panels, [](const ChartPanel& p) { return p.series.empty(); });
  return chart;
}

}  // namespace trilith::draw
