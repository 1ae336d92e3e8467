#include "draw/chart/chart_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "draw/chart/decimate.hpp"

namespace trilith::draw {
namespace {

constexpr double tick_length = 2.5, line_width = 0.8, dense_width = 0.55, column = 0.4;

std::string series_name(const std::string& where, const ChartSeries& series, std::size_t number) {
  return fmt::format("{}, series {}", where,
                     series.name.empty() ? std::to_string(number + 1) : "'" + series.name + "'");
}

bool shows(double value, AxisScale scale) {
  PlotAxis axis;
  axis.scale = scale;
  return axis.can_show(value);
}

void check_series(const ChartSeries& series, AxisScale x_scale, AxisScale y_scale, const std::string& where) {
  if (series.x.size() != series.y.size())
    throw InputError(fmt::format("{}: {} values of x and {} of y, must be equal in number", where, series.x.size(),
                                 series.y.size()));
  if (series.x.empty()) throw InputError(where + " has no points; leave it out or record it first");
  if (!series.to.empty() && series.to.size() != series.y.size())
    throw InputError(fmt::format("{}: a band from {} values to {}, must be equal in number", where, series.y.size(),
                                 series.to.size()));
  for (std::size_t i = 0; i < series.x.size(); ++i)
    if (shows(series.x[i], x_scale) && shows(series.y[i], y_scale)) return;
  throw InputError(where + " has no point that can be drawn: all are not finite, or not above 0 on a logarithmic axis");
}

void stack_on(ChartSeries& series, const ChartSeries& below, const std::string& where) {
  if (series.x != below.x) throw InputError(where + " is stacked but its x differs from the stacked series before it");
  for (std::size_t i = 0; i < series.y.size(); ++i) series.y[i] += below.y[i];
}

/// Runs of showable points, on the page.
std::vector<std::vector<PagePoint>> page_lines(const ChartSeries& series, const PanelDrawing& d) {
  std::vector<std::vector<PagePoint>> runs(1);
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (d.x->can_show(series.x[i]) && d.y->can_show(series.y[i]))
      runs.back().emplace_back(d.box.x0 + d.x->share(series.x[i]) * d.box.width(),
                               d.box.y1 - d.y->share(series.y[i]) * d.box.height());
    else if (!runs.back().empty())
      runs.emplace_back();
  }
  if (runs.back().empty()) runs.pop_back();
  return runs;
}

void draw_line(Canvas& canvas, const std::vector<PagePoint>& run, const ChartSeries& series, const Stroke& stroke) {
  // A lone point between gaps has no length; a dot keeps it visible.
  if (run.size() == 1 && !series.points && series.joined)
    canvas.circle(run[0], stroke.width, stroke.colour, std::nullopt);
  const std::vector<PagePoint> kept = decimate(run, column);
  // A noisy line needs a thinner pen than a smooth or short one.
  const bool dense = static_cast<double>(kept.size()) > 2 * std::abs(run.back().x() - run.front().x());
  if (kept.size() > 1 && series.joined)
    canvas.polyline(kept, {stroke.colour, dense ? dense_width : stroke.width, stroke.dash});
  if (!series.points) return;
  for (const PagePoint& p : run) canvas.circle(p, 1.7, palette().paper, Stroke{stroke.colour, 0.8});
}

void draw_filled(Canvas& canvas, std::vector<PagePoint> run, double base, const Colour& colour) {
  run = decimate(run, column);
  std::vector<PagePoint> area = run;
  area.emplace_back(run.back().x(), base);
  area.emplace_back(run.front().x(), base);
  canvas.polygon(std::move(area), blend(colour, palette().paper, 0.45), std::nullopt);
  if (run.size() > 1) canvas.polyline(run, {colour, 0.5});
}

/// The area between the two lines of a band, on the page.
void draw_band(Canvas& canvas, const ChartSeries& series, const PanelDrawing& d, const Colour& colour) {
  std::vector<PagePoint> there, back;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (!d.x->can_show(series.x[i]) || !d.y->can_show(series.y[i]) || !d.y->can_show(series.to[i])) continue;
    const double x = d.box.x0 + d.x->share(series.x[i]) * d.box.width();
    there.emplace_back(x, d.box.y1 - d.y->share(series.y[i]) * d.box.height());
    back.emplace_back(x, d.box.y1 - d.y->share(series.to[i]) * d.box.height());
  }
  if (there.size() < 2) return;
  there.insert(there.end(), back.rbegin(), back.rend());
  canvas.polygon(std::move(there), blend(colour, palette().paper, 0.8), std::nullopt);
}

void draw_series(Canvas& canvas, const ChartPanel& panel, const PanelDrawing& d, const SeriesLooks& looks) {
  for (const ChartSeries& series : panel.series)
    if (!series.to.empty()) draw_band(canvas, series, d, looks.colour(series));
  const double base = d.box.y1 - (d.y->can_show(0) ? d.y->share(0) : 0) * d.box.height();
  // Each stacked area extends down to zero, so the last sum is painted first.
  for (auto series = panel.series.rbegin(); series != panel.series.rend(); ++series)
    if (series->stacked)
      for (const auto& run : page_lines(*series, d)) draw_filled(canvas, run, base, looks.colour(*series));
  for (const ChartSeries& series : panel.series)
    if (!series.stacked && series.to.empty())
      for (const auto& run : page_lines(series, d))
        draw_line(canvas, run, series, {looks.colour(series), line_width, looks.dash(series)});
}

void draw_grid(Canvas& canvas, const PanelDrawing& d) {
  const Palette& p = palette();
  const auto upright = [&](double value, const Stroke& stroke) {
    const double x = d.box.x0 + d.x->share(value) * d.box.width();
    canvas.line({x, d.box.y0}, {x, d.box.y1}, stroke);
  };
  const auto level = [&](double value, const Stroke& stroke) {
    const double y = d.box.y1 - d.y->share(value) * d.box.height();
    canvas.line({d.box.x0, y}, {d.box.x1, y}, stroke);
  };
  for (const double tick : d.x->minor_ticks) upright(tick, {p.grid, 0.25});
  for (const double tick : d.y->minor_ticks) level(tick, {p.grid, 0.25});
  for (const double tick : d.x->ticks) upright(tick, {p.grid, 0.5});
  for (const double tick : d.y->ticks) level(tick, {p.grid, 0.5});
  if (d.y->can_show(0) && d.y->low < 0 && d.y->high > 0) level(0, {p.zero_line, 0.7});
}

void draw_figures(Canvas& canvas, const PanelDrawing& d, const ChartStyle& style) {
  const Palette& p = palette();
  const TextStyle right{style.font_size, false, p.ink, Align::right},
      middle{style.font_size, false, p.ink, Align::centre};
  canvas.rectangle(d.box, std::nullopt, Stroke{p.axis, 0.5});
  for (std::size_t i = 0; i < d.y->ticks.size(); ++i) {
    const double y = d.box.y1 - d.y->share(d.y->ticks[i]) * d.box.height();
    canvas.line({d.box.x0 - tick_length, y}, {d.box.x0, y}, {p.axis, 0.5});
    canvas.text({d.box.x0 - tick_length - 2, y + 0.36 * style.font_size}, d.y->texts[i], right);
  }
  for (std::size_t i = 0; i < d.x->ticks.size(); ++i) {
    const double x = d.box.x0 + d.x->share(d.x->ticks[i]) * d.box.width();
    canvas.line({x, d.box.y1}, {x, d.box.y1 + tick_length}, {p.axis, 0.5});
    if (d.x_figures) canvas.text({x, d.box.y1 + tick_length + 1.1 * style.font_size}, d.x->texts[i], middle);
  }
}

void draw_titles(Canvas& canvas, const ChartPanel& panel, const PanelDrawing& d, const ChartStyle& style) {
  TextStyle text{style.font_size, false, palette().ink, Align::centre};
  const double middle_x = (d.box.x0 + d.box.x1) / 2, middle_y = (d.box.y0 + d.box.y1) / 2;
  if (d.x_figures) canvas.text({middle_x, d.box.y1 + tick_length + 2.6 * style.font_size}, d.x->title, text);
  text.upward = true;
  double x = d.box.x0 - d.label_room + 0.85 * style.font_size;
  for (const std::string& line : wrap_text(d.y->title, text, d.box.height() + 6)) {
    canvas.text({x, middle_y}, line, text);
    x += 1.2 * style.font_size;
  }
  if (panel.note.empty()) return;
  const TextStyle note{style.font_size - 0.5, false, palette().quiet_ink, Align::right};
  const double wide = text_width(panel.note, note);
  const PageBox patch{d.box.x1 - wide - 2, d.box.y0 - 1.35 * note.size, d.box.x1, d.box.y0 - 0.3};
  canvas.rectangle(patch, palette().paper, std::nullopt);
  canvas.text({d.box.x1, d.box.y0 - 0.4 * note.size}, panel.note, note);
}

}  // namespace

SeriesLooks::SeriesLooks(const std::vector<Chart>& charts) {
  for (const Chart& chart : charts)
    for (const ChartPanel& panel : chart.panels)
      for (const ChartSeries& series : panel.series)
        if (!series.name.empty() && index(series.name) == names_.size()) names_.push_back(series.name);
}

std::size_t SeriesLooks::index(const std::string& name) const {
  if (name.empty()) return 0;
  return static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin());
}

Colour SeriesLooks::colour(const ChartSeries& series) const {
  return series.colour.value_or(series_colour(index(series.name)));
}

Dash SeriesLooks::dash(const ChartSeries& series) const {
  if (series.dash != Dash::solid) return series.dash;
  // When all colours are used, the dash distinguishes the next round.
  static constexpr Dash rounds[] = {Dash::solid, Dash::dashed, Dash::dotted, Dash::dash_dot};
  return rounds[(index(series.name) / series_colour_count) % std::size(rounds)];
}

ChartPanel checked_panel(const ChartPanel& panel, AxisScale x_scale, const std::string& where) {
  if (panel.series.empty()) throw InputError(where + " has no series to draw");
  ChartPanel out = panel;
  const ChartSeries* below = nullptr;
  for (std::size_t i = 0; i < out.series.size(); ++i) {
    ChartSeries& series = out.series[i];
    const std::string name = series_name(where, series, i);
    check_series(series, x_scale, panel.y.scale, name);
    if (!series.stacked) continue;
    if (std::any_of(series.y.begin(), series.y.end(), [](double v) { return v < 0; }))
      throw InputError(name + " is stacked but has values below 0; draw it as a line");
    if (below != nullptr) stack_on(series, *below, name);
    below = &series;
  }
  return out;
}

void draw_panel(Canvas& canvas, const ChartPanel& panel, const PanelDrawing& drawing,
                const std::vector<double>& mark_lines, const SeriesLooks& looks, const ChartStyle& style) {
  draw_grid(canvas, drawing);
  const PageBox inside = drawing.box;
  canvas.clipped(inside, [&] {
    for (const double x : mark_lines) canvas.line({x, inside.y0}, {x, inside.y1}, {palette().event, 0.5, Dash::dashed});
    draw_series(canvas, panel, drawing, looks);
  });
  draw_figures(canvas, drawing, style);
  draw_titles(canvas, panel, drawing, style);
}

}  // namespace trilith::draw
