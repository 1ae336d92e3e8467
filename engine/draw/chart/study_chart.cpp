#include "draw/chart/study_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.hpp"
#include "draw/palette.hpp"
#include "results/study/study_statistics.hpp"

namespace trilith::draw {
namespace {

using results::StudyColumn;

bool is_number_column(const StudyColumn& column) {
  return !std::holds_alternative<std::vector<std::string>>(column.values);
}

std::string first_varied(const std::vector<StudyColumn>& columns, const std::vector<std::string>& parameters) {
  for (const std::string& name : parameters) {
    const StudyColumn& c = results::study_column(columns, name, parameters, "parameter");
    const std::size_t rows = std::visit([](const auto& v) { return v.size(); }, c.values);
    for (std::size_t i = 1; i < rows; ++i)
      if (results::study_text(c, i) != results::study_text(c, 0)) return name;
  }
  throw InputError("no parameter of the study takes several values, so there is no axis to draw over");
}

/// Positions of the cases on the x axis, and the words of an axis without numbers.
struct CasePlaces {
  std::vector<double> x;
  std::vector<std::string> words;
};

CasePlaces places_over(const StudyColumn& over) {
  if (is_number_column(over) && !results::is_flag(over)) return {results::study_numbers(over), {}};
  CasePlaces places;
  const std::size_t rows = std::visit([](const auto& v) { return v.size(); }, over.values);
  for (std::size_t i = 0; i < rows; ++i) {
    const std::string word = results::study_text(over, i);
    const auto found = std::find(places.words.begin(), places.words.end(), word);
    places.x.push_back(static_cast<double>(found - places.words.begin()));
    if (found == places.words.end()) places.words.push_back(word);
  }
  return places;
}

/// A short vertical line: an interval at one x.
ChartSeries upright(const std::string& name, double x, double low, double high) {
  return {name, {x, x}, {low, high}};
}

void add_share(const std::string& name, double x, const results::Tally& tally, ChartSeries& shares, ChartPanel& panel) {
  shares.x.push_back(x);
  shares.y.push_back(static_cast<double>(tally.hits) / tally.count);
  const results::Confidence c = results::wilson_interval(tally.hits, tally.count);
  panel.series.push_back(upright(name, x, c.low, c.high));
}

void add_flag(const CasePlaces& places, const StudyColumn& figure, ChartPanel& panel) {
  std::map<double, results::Tally> tallies;
  const std::vector<double>& values = results::study_numbers(figure);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i])) tallies[places.x[i]].add(values[i] != 0 ? results::Holds::yes : results::Holds::no);
  ChartSeries shares{figure.name, {}, {}};
  shares.points = true;
  for (const auto& [x, tally] : tallies) add_share(figure.name, x, tally, shares, panel);
  if (!shares.x.empty()) panel.series.push_back(std::move(shares));
}

void add_figure(const CasePlaces& places, const StudyColumn& figure, ChartPanel& panel) {
  std::map<double, std::vector<double>> by_place;
  const std::vector<double>& values = results::study_numbers(figure);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i])) by_place[places.x[i]].push_back(values[i]);
  ChartSeries median{figure.name, {}, {}}, low{figure.name, {}, {}, Dash::dashed}, high = low, band = median;
  median.points = true;
  for (const auto& [x, of_place] : by_place) {
    const results::Spread s = results::spread_of(of_place);
    for (ChartSeries* series : {&median, &low, &high, &band}) series->x.push_back(x);
    median.y.push_back(s.median), low.y.push_back(s.low), high.y.push_back(s.high);
    band.y.push_back(s.lower), band.to.push_back(s.upper);
  }
  if (median.x.empty()) return;
  for (ChartSeries* series : {&median, &low, &high, &band}) panel.series.push_back(std::move(*series));
}

AxisScale scale_of(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *low > 0 && *high >= 100 * *low ? AxisScale::logarithmic : AxisScale::linear;
}

ChartPanel& panel_of_unit(Chart& chart, const StudyColumn& figure) {
  for (ChartPanel& panel : chart.panels)
    if (panel.y.unit == (results::is_flag(figure) ? "" : figure.unit)) return panel;
  if (results::is_flag(figure)) {
    chart.panels.push_back({{"share of the cases, 95 %", "", AxisScale::linear, -0.04, 1.04}, {}});
  } else {
    chart.panels.push_back({{"median, 16 to 84 %, range", figure.unit}, {}});
  }
  return chart.panels.back();
}

constexpr int curve_points = 200;

/// Intensities at which the curve is drawn: from 0 to slightly beyond the highest one in the study.
std::vector<double> curve_places(const results::StudyFragility& f) {
  std::vector<double> x;
  const double last = 1.1 * f.stripes.back().intensity;
  for (int i = 1; i <= curve_points; ++i) x.push_back(last * i / curve_points);
  return x;
}

/// One record's line of an incremental analysis.
ChartSeries ida_line(const results::RecordCases& record, const std::vector<double>& im, const std::vector<double>& edp,
                     const std::vector<results::Holds>& stopped, double beyond) {
  ChartSeries line{"records", {0}, {0}};
  line.colour = palette().axis;
  for (const std::size_t row : record.rows) {
    if (stopped[row] == results::Holds::yes) {
      const double between = 0.5 * (line.y.back() + im[row]);  // estimate of its capacity
      line.x.push_back(line.x.back()), line.y.push_back(between);
      line.x.push_back(beyond), line.y.push_back(between);
      break;
    }
    if (std::isfinite(edp[row])) line.x.push_back(edp[row]), line.y.push_back(im[row]);
  }
  return line;
}

/// The quantile `p` of the response at each intensity; a stopped record counts as above all others there and at higher
/// intensities.
ChartSeries ida_quantile(const std::string& name, double p, Dash dash, const std::vector<results::RecordCases>& records,
                         const std::vector<double>& im, const std::vector<double>& edp,
                         const std::vector<results::Holds>& stopped) {
  std::map<double, std::vector<double>> at;
  for (const double v : im) at[v];
  constexpr double unbounded_response = 1e300;
  for (const results::RecordCases& record : records) {
    double down = unbounded_response;
    for (const std::size_t row : record.rows) {
      if (stopped[row] == results::Holds::yes) down = std::min(down, im[row]);
      if (im[row] < down && std::isfinite(edp[row])) at[im[row]].push_back(edp[row]);
    }
    for (auto& [value, list] : at)
      if (value >= down) list.push_back(unbounded_response);
  }
  ChartSeries line{name, {0}, {0}, dash};
  for (auto& [value, list] : at)
    if (!list.empty())
      if (const double q = results::quantile(list, p); q < 0.1 * unbounded_response)
        line.x.push_back(q), line.y.push_back(value);
  return line;
}

}  // namespace

Chart study_chart(const std::vector<StudyColumn>& columns, const std::string& over,
                  const std::vector<std::string>& figures) {
  const results::StudyNames names = results::study_names(columns);
  if (names.figures.empty()) throw InputError("the study has no case with a figure yet");
  const StudyColumn& x = results::study_column(columns, over.empty() ? first_varied(columns, names.parameters) : over,
                                               names.parameters, "parameter");
  const CasePlaces places = places_over(x);
  if (places.x.empty()) throw InputError("the study has no case with a figure yet");
  Chart chart;
  chart.x = {x.name, results::is_flag(x) ? "" : x.unit, AxisScale::linear};
  chart.x.words = places.words;
  if (places.words.empty()) chart.x.scale = scale_of(places.x);
  if (places.words.empty() && chart.x.scale == AxisScale::linear) {
    const auto [low, high] = std::minmax_element(places.x.begin(), places.x.end());
    const double room = 0.04 * (*high - *low);
    if (room > 0) chart.x.low = *low == 0 ? 0 : *low - room, chart.x.high = *high + room;
  }
  for (const std::string& name : figures.empty() ? names.figures : figures) {
    const StudyColumn& figure = results::study_column(columns, name, names.figures, "figure");
    if (figures.empty() && !is_number_column(figure)) continue;
    ChartPanel& panel = panel_of_unit(chart, figure);
    results::is_flag(figure) ? add_flag(places, figure, panel) : add_figure(places, figure, panel);
  }
  std::erase_if(chart.panels, [](const ChartPanel& p) { return p.series.empty(); });
  if (chart.panels.empty()) throw InputError("the study has no figure with numbers to draw");
  return chart;
}

Chart fragility_chart(const results::StudyFragility& f, const std::string& condition) {
  Chart chart;
  chart.subtitle = fragility_text(f);
  chart.x = {f.intensity, f.unit};
  chart.x.low = 0;
  ChartPanel panel{{fmt::format("probability of '{}'", condition), "", AxisScale::linear, -0.04, 1.04}, {}};
  ChartSeries curve{"lognormal curve", curve_places(f), {}}, band{"its band of 95 %", curve.x, {}};
  for (const double x : curve.x) {
    const results::Confidence c = f.curve.band(x);
    curve.y.push_back(f.curve.probability(x)), band.y.push_back(c.low), band.to.push_back(c.high);
  }
  curve.colour = band.colour = series_colour(0);
  const std::string seen = f.incremental ? "records down, 95 %" : "cases, 95 %";
  ChartSeries shares{seen, {}, {}};
  shares.points = true, shares.joined = false, shares.colour = palette().ink;
  panel.series = {band, curve};
  for (const results::Stripe& s : f.stripes) add_share("", s.intensity, s.seen, shares, panel);
  for (ChartSeries& s : panel.series)
    if (s.name.empty()) s.colour = palette().ink;
  panel.series.push_back(std::move(shares));
  chart.panels.push_back(std::move(panel));
  return chart;
}

Chart ida_chart(const std::vector<StudyColumn>& columns, const std::string& figure, const std::string& over,
                const std::string& stop) {
  const results::StudyNames names = results::study_names(columns);
  const StudyColumn &response = results::study_column(columns, figure, names.figures, "figure"),
                    &intensity = results::study_column(columns, over, names.parameters, "parameter");
  const std::vector<double>&im = results::study_numbers(intensity), &edp = results::study_numbers(response);
  std::vector<results::Holds> stopped(im.size(), results::Holds::no);
  if (!stop.empty()) stopped = results::condition_of_cases(columns, stop);
  double most = 0;
  for (std::size_t i = 0; i < edp.size(); ++i)
    if (std::isfinite(edp[i]) && stopped[i] != results::Holds::yes) most = std::max(most, std::abs(edp[i]));
  if (!(most > 0)) throw InputError(fmt::format("no case gives a '{}' to draw", figure));
  std::vector<double> size = edp;
  for (double& v : size) v = std::abs(v);
  const std::vector<results::RecordCases> records = results::cases_by_record(columns, over);
  Chart chart;
  chart.x = {figure, response.unit};
  chart.x.low = 0, chart.x.high = 1.1 * most;
  ChartPanel panel{{intensity.name, intensity.unit}, {}};
  panel.y.low = 0;
  for (const results::RecordCases& record : records) {
    panel.series.push_back(ida_line(record, im, size, stopped, 2 * most));
    if (panel.series.back().x.size() < 2) panel.series.pop_back();
  }
  panel.series.push_back(ida_quantile("median", 0.5, Dash::solid, records, im, size, stopped));
  panel.series.push_back(ida_quantile("16 and 84 %", 0.16, Dash::dashed, records, im, size, stopped));
  panel.series.push_back(ida_quantile("16 and 84 %", 0.84, Dash::dashed, records, im, size, stopped));
  for (std::size_t i = panel.series.size() - 3; i < panel.series.size(); ++i) panel.series[i].colour = series_colour(0);
  chart.panels.push_back(std::move(panel));
  return chart;
}

}  // namespace trilith::draw
