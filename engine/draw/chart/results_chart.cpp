// Histories, energy and events of a results file as charts.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "draw/results/results_picture.hpp"
#include "model/energy.hpp"
#include "model/event/event_list.hpp"
#include "results/reading/event_units.hpp"
#include "results/reading/largest_value.hpp"

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

/// "displacement along x" of "displacement along x of body 'slab'"; "" where the description names no owner.
std::string quantity_of(const Quantity& history) {
  for (const char* owner : {" of body '", " of bearing '", " of seat '", " of storey "})
    if (const std::size_t at = history.description.find(owner); at != std::string::npos)
      return history.description.substr(0, at);
  return "";
}

/// Label of an axis with this history alone: "slab 3, displacement along x".
std::string label_of(const Quantity& history) {
  const std::string quantity = quantity_of(history);
  if (quantity.find(history.name) != std::string::npos) return quantity;
  return quantity.empty() ? history.name : history.name + ", " + quantity;
}

/// Label of an axis with several histories: their common quantity, otherwise empty; the legend distinguishes them.
std::string common_label(const std::string& label, const Quantity& history) {
  const std::string quantity = quantity_of(history);
  const bool shared = !quantity.empty() && (label == quantity || label.ends_with(", " + quantity));
  return shared ? quantity : "";
}

ChartPanel& panel_for(Chart& chart, const Quantity& history) {
  for (ChartPanel& panel : chart.panels)
    if (panel.y.unit == history.unit) return panel;
  chart.panels.push_back({{label_of(history), history.unit}, {}});
  return chart.panels.back();
}

/// A window in the times of a run [s], and the time it counts from.
struct RunWindow {
  double from, to, zero;
};

results::TimeOrigin origin_of(const ResultsReader& reader, const PlotWindow& window) {
  return results::time_origin(reader, window.since.empty() ? window.stage : window.since);
}

RunWindow run_window(const ResultsReader& reader, const PlotWindow& window) {
  constexpr double forever = std::numeric_limits<double>::infinity();
  double first = -forever, last = forever;
  if (!window.stage.empty()) {
    const results::StageRow row = results::find_stage(reader, window.stage);
    first = row.begin, last = row.ended ? row.end : forever;
  }
  const double zero = origin_of(reader, window).zero;
  // A sample at the border belongs to the window despite rounding.
  const double hair = 1e-9 * std::max(1.0, std::abs(zero));
  return {(window.from ? zero + *window.from : first) - hair,
          std::min(window.to ? zero + *window.to : forever, last) + hair, zero};
}

/// Indices and times of the samples of a run in the window.
struct Samples {
  std::vector<std::size_t> rows;
  std::vector<double> time;
  [[nodiscard]] std::vector<double> of(const std::vector<double>& all) const {
    std::vector<double> out;
    for (const std::size_t row : rows) out.push_back(all[row]);
    return out;
  }
};

Samples samples_at(const ResultsReader& reader, const std::vector<double>& times, const PlotWindow& window,
                   const char* what) {
  if (window.from && window.to && *window.from >= *window.to)
    throw InputError(fmt::format("--from is {:g} s, must be before --to, {:g} s", *window.from, *window.to));
  const RunWindow of_run = run_window(reader, window);
  Samples samples;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] < of_run.from || times[i] > of_run.to) continue;
    samples.rows.push_back(i);
    samples.time.push_back(times[i] - of_run.zero);
  }
  if (!samples.rows.empty()) return samples;
  if (times.empty()) throw InputError(fmt::format("'{}' has no samples of {} yet", reader.path().string(), what));
  throw InputError(fmt::format("'{}' has no samples of {} in that part of the run; they go from {:g} to {:g} s",
                               reader.path().string(), what, times.front() - of_run.zero, times.back() - of_run.zero));
}

Samples samples_in(const ResultsReader& reader, const PlotWindow& window) {
  return samples_at(reader, reader.history_times(), window, "its histories");
}

/// Adds a margin for a line that spans the whole width, such as a loop.
void give_room(Chart& chart) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const ChartPanel& panel : chart.panels)
    for (const ChartSeries& series : panel.series)
      for (const double x : series.x)
        if (std::isfinite(x)) low = std::min(low, x), high = std::max(high, x);
  if (!(low < high)) return;
  const double room = 0.05 * (high - low);
  chart.x.low = low == 0 ? 0 : low - room, chart.x.high = high == 0 ? 0 : high + room;
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

/// Merges very small terms into one, the last; terms that are zero throughout are omitted.
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

/// More marks than this of one type are not useful.
constexpr std::size_t most_marks_of_a_type = 8;

/// Time axis from the start of the run, or of a stage or an event, which the label then names.
ChartAxis time_axis(const ResultsReader& reader, const PlotWindow& window) {
  return {"Time" + origin_of(reader, window).text(), "s"};
}

}  // namespace

Chart history_chart(const std::vector<NamedResults>& results, const std::vector<std::string>& names,
                    const PlotWindow& window, const std::string& against) {
  std::vector<std::string> wanted = names;
  if (wanted.empty())
    for (const Quantity& q : results.front().reader->header().histories)
      if (q.name != against) wanted.push_back(q.name);
  if (wanted.empty())
    throw InputError(fmt::format("'{}' has no histories to plot", results.front().reader->path().string()));
  Chart chart;
  chart.x = against.empty() ? time_axis(*results.front().reader, window)
                            : ChartAxis{label_of(find_history(*results.front().reader, against)),
                                        find_history(*results.front().reader, against).unit};
  for (const std::string& name : wanted)
    for (const NamedResults& result : results) {
      const Quantity& history = find_history(*result.reader, name);
      ChartPanel& panel = panel_for(chart, history);
      if (panel.y.label != label_of(history)) panel.y.label = common_label(panel.y.label, history);
      const std::string run = result.name.empty() ? "" : fmt::format(" ({})", result.name);
      const Samples samples = samples_in(*result.reader, window);
      if (!against.empty()) find_history(*result.reader, against);
      panel.series.push_back({name + run, against.empty() ? samples.time : samples.of(result.reader->history(against)),
                              samples.of(result.reader->history(name))});
    }
  if (!against.empty()) give_room(chart);
  for (ChartPanel& panel : chart.panels)
    if (panel.series.size() == 1) panel.series[0].name.clear();
  return chart;
}

Chart results_energy_chart(const NamedResults& result, EnergyView view, const PlotWindow& window) {
  results::EnergyTable table = result.reader->energy();
  const Samples samples = samples_at(*result.reader, table.time, window, "the energy");
  for (std::vector<double>& term : table.terms) term = samples.of(term);
  table.time = samples.time;
  const std::vector<Quantity>& terms = result.reader->header().energy_terms;
  std::vector<EnergyCurve> curves;
  EnergyCurve supplied{"input by ground, loads and weight", std::vector<double>(table.time.size(), 0.0), true};
  double start = 0;  // energy stored at the first sample counts as supplied
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
  chart.x = time_axis(*result.reader, window);
  for (ChartSeries& s : chart.panels[0].series)
    if (s.name == small_terms) s.colour = palette().no_value;
  if (!result.name.empty()) chart.title += ", " + result.name;
  return chart;
}

std::vector<ChartMark> event_marks(const ResultsReader& reader, const PlotWindow& window, const UnitSystem& units) {
  const RunWindow of_run = run_window(reader, window);
  std::map<std::string, std::vector<results::EventRow>> by_type;
  for (results::EventRow& e : events_of_note(reader)) {
    if (e.time < of_run.from || e.time > of_run.to) continue;
    e.time -= of_run.zero;
    by_type[e.type].push_back(std::move(e));
  }
  std::vector<ChartMark> marks;
  for (const auto& [type, events] : by_type) {
    if (events.size() <= most_marks_of_a_type) {
      for (const results::EventRow& e : events) marks.push_back({e.time, results::text_in(e, units)});
      continue;
    }
    const bool impacts = type == info_of(EventType::impact).name;
    const auto slower = [](const results::EventRow& a, const results::EventRow& b) {
      return a.first.value < b.first.value;
    };
    const results::EventRow& one = impacts ? *std::max_element(events.begin(), events.end(), slower) : events.front();
    marks.push_back({one.time, fmt::format("{} ({} of {})", results::text_in(one, units), impacts ? "fastest" : "first",
                                           events.size())});
  }
  std::stable_sort(marks.begin(), marks.end(), [](const ChartMark& a, const ChartMark& b) { return a.x < b.x; });
  return marks;
}

}  // namespace trilith::draw
