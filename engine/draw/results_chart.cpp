// Histories, energy and events of a results file as charts.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "draw/results_picture.hpp"
#include "results/largest_value.hpp"
#include "world/energy.hpp"
#include "world/event.hpp"

namespace trilith::draw {

using results::largest_value;
using results::Quantity;
using results::ResultsReader;

namespace {

const Quantity& find_history(const ResultsReader& reader, const std::string& name) {
  std::vector<std::string> known;
  for (const Quantity& q : reader.header().histories) {
    if (q.name == name) return q;
    known.push_back(q.name);
  }
  const std::string hint = known.empty() ? "; it has none" : name_hint(name, known);
  throw InputError(fmt::format("'{}' has no history '{}'{}", reader.path().string(), name, hint));
}

ChartPanel& panel_for(Chart& chart, const Quantity& history) {
  for (ChartPanel& panel : chart.panels)
    if (panel.y.unit == history.unit) return panel;
  chart.panels.push_back({{history.name, history.unit}, {}});
  return chart.panels.back();
}

const EnergyTermInfo* find_term(const std::string& name) {
  const auto found = std::find_if(energy_term_info.begin(), energy_term_info.end(),
                                  [&](const EnergyTermInfo& t) { return t.name == name; });
  return found == energy_term_info.end() ? nullptr : &*found;
}

void add(std::vector<double>& sum, const std::vector<double>& values, double factor) {
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += factor * values[k];
}

constexpr const char* small_terms = "the rest";

/// Terms too small to be seen become one, the last; those that are zero throughout are left out.
std::vector<EnergyCurve> without_small(std::vector<EnergyCurve> curves) {
  constexpr double least_share = 0.01;
  double most = 0;
  for (const EnergyCurve& c : curves) most = std::max(most, largest_value(c.energy));
  EnergyCurve rest{small_terms, {}, false};
  std::vector<EnergyCurve> out;
  for (EnergyCurve& c : curves) {
    if (rest.energy.empty()) rest.energy.assign(c.energy.size(), 0.0);
    if (largest_value(c.energy) < least_share * most)
      add(rest.energy, c.energy, 1);
    else
      out.push_back(std::move(c));
  }
  if (largest_value(rest.energy) > 0) out.push_back(std::move(rest));
  return out;
}

/// More marks than these of one type say nothing.
constexpr std::size_t most_marks_of_a_type = 8;

}  // namespace

Chart history_chart(const std::vector<NamedResults>& results, const std::vector<std::string>& names) {
  Chart chart;
  chart.x = {"Time", "s"};
  std::vector<std::string> wanted = names;
  if (wanted.empty())
    for (const Quantity& q : results.front().reader->header().histories) wanted.push_back(q.name);
  if (wanted.empty())
    throw InputError(fmt::format("'{}' has no histories to plot", results.front().reader->path().string()));
  for (const std::string& name : wanted)
    for (const NamedResults& result : results) {
      ChartPanel& panel = panel_for(chart, find_history(*result.reader, name));
      if (panel.y.label != name) panel.y.label.clear();  // several: the legend tells them apart
      const std::string run = result.name.empty() ? "" : fmt::format(" ({})", result.name);
      panel.series.push_back({name + run, result.reader->history_times(), result.reader->history(name)});
      if (panel.series.back().x.empty())
        throw InputError(fmt::format("'{}' has no samples of its histories yet", result.reader->path().string()));
    }
  for (ChartPanel& panel : chart.panels) {
    if (!panel.y.label.empty())
      for (ChartSeries& s : panel.series) s.name = s.name == panel.y.label ? "" : s.name;
  }
  return chart;
}

Chart results_energy_chart(const NamedResults& result, EnergyView view) {
  const results::EnergyTable table = result.reader->energy();
  if (table.time.empty())
    throw InputError(fmt::format("'{}' has no samples of the energy", result.reader->path().string()));
  const std::vector<Quantity>& terms = result.reader->header().energy_terms;
  std::vector<EnergyCurve> curves;
  EnergyCurve supplied{"put in by ground, loads and weight", std::vector<double>(table.time.size(), 0.0), true};
  double start = 0;  // what was held at the first sample counts as put in
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const EnergyTermInfo* info = find_term(terms[i].name);
    if (info == nullptr || (info->sign > 0 && info->name != "gravity")) {
      start += table.terms[i].front();
      curves.push_back({terms[i].description, table.terms[i], false});
      continue;
    }
    const double sign = info->sign < 0 ? 1 : -1;
    add(supplied.energy, table.terms[i], sign);
    start -= sign * table.terms[i].front();
  }
  for (double& e : supplied.energy) e += start;
  curves = without_small(std::move(curves));
  curves.push_back(std::move(supplied));
  Chart chart = energy_chart(table.time, curves, view);
  for (ChartSeries& s : chart.panels[0].series)
    if (s.name == small_terms) s.colour = palette().no_value;
  if (!result.name.empty()) chart.title += ", " + result.name;
  return chart;
}

std::vector<ChartMark> event_marks(const ResultsReader& reader) {
  std::map<std::string, std::vector<results::EventRow>> by_type;
  for (results::EventRow& e : events_of_note(reader)) by_type[e.type].push_back(std::move(e));
  std::vector<ChartMark> marks;
  for (const auto& [type, events] : by_type) {
    if (events.size() <= most_marks_of_a_type) {
      for (const results::EventRow& e : events) marks.push_back({e.time, e.text});
      continue;
    }
    const bool impacts = type == event_type_info[static_cast<std::size_t>(EventType::impact)].name;
    const auto slower = [](const results::EventRow& a, const results::EventRow& b) {
      return a.first.value < b.first.value;
    };
    const results::EventRow& one = impacts ? *std::max_element(events.begin(), events.end(), slower) : events.front();
    marks.push_back({one.time, fmt::format("{} ({} of {})", one.text, impacts ? "fastest" : "first", events.size())});
  }
  std::stable_sort(marks.begin(), marks.end(), [](const ChartMark& a, const ChartMark& b) { return a.x < b.x; });
  return marks;
}

}  // namespace trilith::draw
