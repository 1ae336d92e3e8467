// Figures of a report: the structure at key times, histories, energy.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/quantity_text.hpp"
#include "draw/results/results_picture.hpp"
#include "report/sections.hpp"
#include "results/reading/event_tree.hpp"
#include "results/reading/largest_value.hpp"

namespace trilith::report {
namespace {

constexpr std::size_t most_histories = 8;

/// An SVG as part of a page: without its head, and with ids that are unique to this figure.
std::string inline_svg(std::string svg, std::string_view figure) {
  svg.erase(0, svg.find("<svg"));
  for (const std::string mark : {"id=\"", "href=\"#", "url(#"})
    for (std::size_t at = svg.find(mark); at != std::string::npos; at = svg.find(mark, at + mark.size()))
      svg.insert(at + mark.size(), fmt::format("{}-", figure));
  return svg;
}

struct Moment {
  double time = 0;
  std::string why;
};

/// The ends of the `most` intervals with most events out of 40, no two of them neighbours.
std::vector<Moment> busy_moments(const std::vector<results::EventRow>& events, double begin, double end,
                                 std::size_t most) {
  constexpr int stretches = 40;
  std::vector<int> count(stretches);
  for (const results::EventRow& e : events)
    if (!e.type.starts_with("stage.") && e.time >= begin && e.time < end)
      ++count[static_cast<std::size_t>(stretches * (e.time - begin) / (end - begin))];
  std::vector<Moment> out;
  while (out.size() < most) {
    const auto fullest = std::max_element(count.begin(), count.end());
    if (*fullest < 2) break;
    const auto k = fullest - count.begin();
    const double from = begin + (end - begin) * static_cast<double>(k) / stretches;
    const double to = from + (end - begin) / stretches;
    out.push_back({to, fmt::format("after {} important events in {}", *fullest, shown_time(to - from))});
    for (auto i = std::max<std::ptrdiff_t>(0, k - 1); i <= std::min<std::ptrdiff_t>(stretches - 1, k + 1); ++i)
      count[i] = 0;
  }
  return out;
}

/// Sorted by time; of two nearly equal moments, the one listed first remains.
std::vector<Moment> key_moments(const ReportSource& source) {
  const std::vector<double>& times = source.reader.frame_times();
  double begin = times.front();
  const double end = times.back();
  for (const results::StageRow& stage : source.stages)
    if (stage.kind != "consolidation" && stage.begin <= end) {
      begin = std::max(begin, stage.begin);
      break;
    }
  std::vector<Moment> wanted{{begin, "the start"}, {end, "the end"}};
  const auto first = std::find_if(source.events.begin(), source.events.end(), results::is_failure);
  if (first != source.events.end()) wanted.push_back({std::clamp(first->time, begin, end), "the first failure"});
  if (end > begin)
    for (Moment& m : busy_moments(source.of_note, begin, end, 2)) wanted.push_back(std::move(m));
  std::vector<Moment> out;
  for (Moment& m : wanted)
    if (std::none_of(out.begin(), out.end(),
                     [&](const Moment& o) { return std::abs(o.time - m.time) <= 0.01 * (end - begin); }))
      out.push_back(std::move(m));
  std::stable_sort(out.begin(), out.end(), [](const Moment& a, const Moment& b) { return a.time < b.time; });
  return out;
}

/// Wide structures in one column, others in two.
int columns_for(const draw::Scene& scene) {
  double x0 = 1e300, x1 = -1e300, y0 = 1e300, y1 = -1e300;
  for (const draw::SceneBody& body : scene.bodies)
    for (const Vec2& p : body.outline)
      if (body.role == draw::BodyRole::free)
        x0 = std::min(x0, p.x()), x1 = std::max(x1, p.x()), y0 = std::min(y0, p.y()), y1 = std::max(y1, p.y());
  return x1 - x0 > 2 * (y1 - y0) ? 1 : 2;
}

double time_of_largest(const std::vector<double>& times, const std::vector<double>& values) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::abs(values[i]) > std::abs(values[at])) at = i;
  return times[at];
}

struct KeyHistory {
  const results::Quantity* quantity;
  std::vector<double> values;
  double most = 0;
};

/// The largest histories first, unit by unit.
std::vector<KeyHistory> key_histories(const ReportSource& source) {
  std::vector<KeyHistory> all;
  std::vector<std::string> units;
  for (const results::Quantity& q : source.header.histories) {
    all.push_back({&q, source.reader.history(q.name), 0});
    all.back().most = results::largest_value(all.back().values);
    if (std::find(units.begin(), units.end(), q.unit) == units.end()) units.push_back(q.unit);
  }
  const auto rank = [&](const KeyHistory& h) { return std::find(units.begin(), units.end(), h.quantity->unit); };
  std::stable_sort(all.begin(), all.end(), [&](const KeyHistory& a, const KeyHistory& b) {
    return rank(a) != rank(b) ? rank(a) < rank(b) : a.most > b.most;
  });
  if (all.size() > most_histories) all.resize(most_histories);
  return all;
}

/// The whole run, with the time origin of the report.
draw::PlotWindow window_of(const ReportSource& source) {
  draw::PlotWindow window;
  window.since = source.origin.name;
  return window;
}

}  // namespace

void write_figure(HtmlText& html, std::string_view name, const std::string& caption,
                  const std::function<draw::Canvas()>& draw) {
  std::string svg;
  try {
    svg = inline_svg(draw().bytes(draw::PictureFormat::svg), name);
  } catch (const std::runtime_error& e) {
    html.element("p", fmt::format("This figure could not be drawn: {}.", e.what()), R"(class="warning")");
    return;
  }
  html.open("figure").raw(svg).element("figcaption", caption).close();
}

void write_pictures(const ReportSource& source, HtmlText& html) {
  html.element("h2", "Pictures at key times");
  if (source.reader.frame_count() == 0) {
    html.element("p", "There is no frame yet.");
    return;
  }
  std::vector<std::string> words;
  if (source.header.dim == 3 && source.header.face_count() == 0 && source.header.sphere_vertex.empty()) {
    html.element("p", "The file contains no faces of solids, so there are no pictures.");
    return;
  }
  draw::SceneChoice choice;
  // In space joints are found from faces.
  choice.cracks =
      source.header.dim == 3 ||
      (!source.header.joints.empty() && std::any_of(source.header.fields.begin(), source.header.fields.end(),
                                                    [](const results::Field& f) { return f.name == "joint_damage"; }));
  choice.origin = source.origin;
  const std::vector<Moment> moments = key_moments(source);
  std::vector<double> times;
  for (const Moment& m : moments) times.push_back(m.time);
  const std::vector<draw::Scene> scenes = draw::results_scenes(source.reader, times, choice);
  for (const Moment& m : moments) {
    const std::string letter = moments.size() > 1 ? fmt::format("({}) ", static_cast<char>('a' + words.size())) : "";
    words.push_back(fmt::format("{}at {}, {}", letter, shown_time(*scenes[words.size()].time), m.why));
  }
  std::string caption = "The structure";
  for (std::size_t i = 0; i < words.size(); ++i) caption += (i == 0 ? " " : "; ") + words[i];
  draw::PictureStyle style;
  style.units = source.units;
  style.height = scenes.size() > 1 ? 625 : 0;  // fits on one printed page with its heading and text
  write_figure(html, "structure", caption + ".",
               [&] { return draw::scene_canvas(scenes, columns_for(scenes[0]), style); });
}

void write_histories(const ReportSource& source, HtmlText& html) {
  if (source.header.histories.empty()) return;
  html.element("h2", "Histories");
  const std::vector<double> times = source.reader.history_times();
  if (times.empty()) {
    html.element("p", "There is no sample of them yet.");
    return;
  }
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;
  for (const KeyHistory& h : key_histories(source)) {
    const std::string& unit = h.quantity->unit;
    names.push_back(h.quantity->name);
    rows.push_back({h.quantity->name, h.quantity->description, quantity_text(h.most, unit, source.units),
                    source.clock(time_of_largest(times, h.values)),
                    quantity_text(h.values.back(), unit, source.units)});
  }
  html.table({"History", "Description", "Largest", "At", "At the end"}, rows, 2);
  const std::size_t left = source.header.histories.size() - names.size();
  if (left > 0)
    html.element("p", fmt::format("The {} largest; {} further histories are in the results file.", names.size(), left),
                 R"(class="note")");
  write_figure(html, "histories", "Histories over time.", [&] {
    draw::Chart chart = draw::history_chart({{&source.reader, ""}}, names, window_of(source));
    chart.units = source.units;
    chart.marks = draw::event_marks(source.reader, window_of(source), source.units);
    return draw::chart_canvas({chart}, draw::Arrangement::below);
  });
}

void write_energy(const ReportSource& source, HtmlText& html) {
  const results::EnergyTable table = source.reader.energy();
  html.element("h2", "Energy");
  if (table.time.empty()) {
    html.element("p", "The file has no samples of the energy.");
    return;
  }
  std::vector<std::vector<std::string>> rows;
  std::size_t none = 0;
  double most = 0;
  const auto add = [&](const std::string& name, const std::string& text, const std::vector<double>& values) {
    const double last = std::abs(values.back()) < 1e-9 * most ? 0 : values.back();
    rows.push_back({name, text, quantity_text(last, "J", source.units),
                    quantity_text(results::largest_value(values), "J", source.units),
                    source.clock(time_of_largest(table.time, values))});
  };
  for (const std::vector<double>& term : table.terms) most = std::max(most, results::largest_value(term));
  for (std::size_t i = 0; i < table.terms.size(); ++i) {
    const results::Quantity& term = source.header.energy_terms[i];
    if (results::largest_value(table.terms[i]) > 0)
      add(term.name, term.description, table.terms[i]);
    else
      ++none;
  }
  add("residual", "error of the energy balance", table.residual);
  html.table({"Term", "Description", "At the end", "Largest", "At"}, rows, 2);
  std::string note;
  if (most > 0)
    note = fmt::format("The residual is at most {} of the largest term. ",
                       percent_text(results::largest_value(table.residual) / most));
  if (none > 0) note += fmt::format("{} terms that are zero throughout are left out.", none);
  if (!note.empty()) html.element("p", note, R"(class="note")");
  write_figure(html, "energy", "Energy by term and the input; below them the residual.", [&] {
    draw::Chart chart = draw::results_energy_chart({&source.reader, ""}, draw::EnergyView::stacked, window_of(source));
    std::vector<double> times = table.time;
    for (double& t : times) t -= source.origin.zero;
    chart.units = source.units;
    chart.panels.push_back({{"Residual", "J"}, {{"", times, table.residual}}});
    return draw::chart_canvas({chart}, draw::Arrangement::below);
  });
}

}  // namespace trilith::report
