#include "draw/chart/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "draw/chart/chart_marks.hpp"
#include "draw/chart/chart_panel.hpp"
#include "draw/chart/plot_axis.hpp"
#include "draw/legend.hpp"

namespace trilith::draw {
namespace {

constexpr double right_room = 10, panel_gap = 8, note_room = 11, block_gap = 14;

/// A chart with all sizes, except its position on the page.
struct Block {
  const Chart* chart = nullptr;
  PlotAxis x;
  std::vector<PlotAxis> y;
  std::vector<ChartPanel> panels;
  std::vector<std::string> title, subtitle;
  PlacedMarks marks;            // x from the plot's left side
  std::vector<LegendItem> key;  // below the plot, if numbers represent the marks' texts
  double width = 0, left = 0, head = 0, foot = 0;

  double plot_width() const { return width - left - right_room; }
};

TextStyle title_style(const ChartStyle& s) {
  return {s.font_size + 1.5, true};
}
TextStyle subtitle_style(const ChartStyle& s) {
  return {s.font_size, false, palette().quiet_ink};
}
TextStyle small_style(const ChartStyle& s) {
  return {s.font_size - 0.8, false, palette().quiet_ink};
}

std::string panel_name(const Chart& chart, std::size_t i) {
  const std::string& label = chart.panels[i].y.label;
  const std::string name = label.empty() ? std::to_string(i + 1) : "'" + label + "'";
  return chart.title.empty() ? "chart panel " + name : fmt::format("chart '{}', panel {}", chart.title, name);
}

double panel_height(const Chart& chart, const ChartStyle& style) {
  if (style.panel_height > 0) return style.panel_height;
  return chart.panels.size() == 1 ? 190 : chart.panels.size() == 2 ? 120 : 88;
}

ValueRange x_range(const std::vector<ChartPanel>& panels, const ChartAxis& axis) {
  PlotAxis probe;
  probe.scale = axis.scale;
  ValueRange range;
  for (const ChartPanel& panel : panels)
    for (const ChartSeries& series : panel.series)
      for (const double v : series.x)
        if (probe.can_show(v)) range.add(v);
  return range;
}

ValueRange y_range(const ChartPanel& panel, const PlotAxis& x) {
  PlotAxis probe;
  probe.scale = panel.y.scale;
  ValueRange range, all;
  for (const ChartSeries& series : panel.series) {
    if (series.stacked && probe.can_show(0)) range.add(0);
    for (std::size_t i = 0; i < series.y.size(); ++i) {
      if (!x.can_show(series.x[i]) || !probe.can_show(series.y[i])) continue;
      all.add(series.y[i]);
      if (series.x[i] < x.low || series.x[i] > x.high) continue;
      range.add(series.y[i]);
      if (!series.to.empty() && probe.can_show(series.to[i])) range.add(series.to[i]);
    }
  }
  return range.any ? range : all;
}

int tick_count(double length, double room) {
  return std::clamp(static_cast<int>(length / room), 2, 10);
}

void measure_left(Block& block, double height, const ChartStyle& style) {
  for (const PlotAxis& y : block.y) {
    double figures = 0;
    for (const std::string& text : y.texts) figures = std::max(figures, text_width(text, {style.font_size}));
    const auto lines = static_cast<double>(wrap_text(y.title, {style.font_size}, height + 6).size());
    block.left = std::max(block.left, figures + 8 + lines * 1.2 * style.font_size);
  }
}

void measure_marks(Block& block, const ChartStyle& style) {
  std::vector<PlacedMark> marks;
  for (const ChartMark& mark : block.chart->marks) {
    require_finite(mark.x, fmt::format("chart mark '{}'", mark.text));
    if (!block.x.can_show(mark.x) || mark.x < block.x.low || mark.x > block.x.high) continue;
    marks.push_back({block.x.share(mark.x) * block.plot_width(), 0, mark.text});
  }
  block.marks = place_marks(std::move(marks), small_style(style), block.plot_width() + right_room);
  block.key.clear();
  for (std::size_t i = 0; i < block.marks.key.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    TextStyle bold = small_style(style);
    bold.bold = true;
    block.key.push_back(
        {text_width(number, bold),
         [=](Canvas& c, const PagePoint& at) { c.text(at + PagePoint(0, 0.36 * bold.size), number, bold); },
         block.marks.key[i]});
  }
}

void measure_head(Block& block, const ChartStyle& style) {
  block.title = wrap_text(block.chart->title, title_style(style), block.width);
  block.subtitle = wrap_text(block.chart->subtitle, subtitle_style(style), block.width);
  block.head = 1.25 * title_style(style).size * static_cast<double>(block.title.size()) +
               1.3 * style.font_size * static_cast<double>(block.subtitle.size()) + 4 +
               1.3 * small_style(style).size * block.marks.rows + (block.panels[0].note.empty() ? 0 : note_room);
  block.foot = 3.4 * style.font_size + legend_height(block.key, small_style(style), block.width - right_room);
}

Block measure(const Chart& chart, double width, double height, const ChartStyle& style) {
  if (chart.panels.empty()) throw InputError(fmt::format("chart '{}' has no panel to draw", chart.title));
  Block block;
  block.chart = &chart;
  block.width = width;
  for (std::size_t i = 0; i < chart.panels.size(); ++i)
    block.panels.push_back(checked_panel(chart.panels[i], chart.x.scale, panel_name(chart, i)));
  block.x = plot_axis(chart.x, x_range(block.panels, chart.x), 0, tick_count(width, 40), "chart x axis", chart.units);
  for (std::size_t i = 0; i < block.panels.size(); ++i)
    block.y.push_back(plot_axis(block.panels[i].y, y_range(block.panels[i], block.x), 0.06,
                                std::min(7, tick_count(height, 13)), panel_name(chart, i), chart.units));
  measure_left(block, height, style);
  if (block.plot_width() < 40)
    throw InputError(fmt::format("chart '{}' has only {:.0f} pt of width left, needs 40; widen the picture",
                                 chart.title, block.plot_width()));
  measure_marks(block, style);
  measure_head(block, style);
  return block;
}

/// Height between the panels of a stack, notes included.
double gaps_height(const Block& block) {
  double gaps = 0;
  for (std::size_t i = 1; i < block.panels.size(); ++i)
    gaps += panel_gap + (block.panels[i].note.empty() ? 0 : note_room);
  return gaps;
}

double plots_height(const Block& block, const ChartStyle& style) {
  return panel_height(*block.chart, style) * static_cast<double>(block.panels.size()) + gaps_height(block);
}

void draw_head(Canvas& canvas, const Block& block, const PagePoint& corner, const ChartStyle& style) {
  double y = corner.y();
  for (const std::string& line : block.title) {
    canvas.text({corner.x(), y + title_style(style).size}, line, title_style(style));
    y += 1.25 * title_style(style).size;
  }
  for (const std::string& line : block.subtitle) {
    canvas.text({corner.x(), y + style.font_size}, line, subtitle_style(style));
    y += 1.3 * style.font_size;
  }
}

/// Names of the marks above the plot whose upper left corner is `plot`, with their lines down to it.
void draw_marks(Canvas& canvas, const Block& block, const PagePoint& plot, const ChartStyle& style) {
  const TextStyle text = small_style(style);
  const double base = plot.y() - (block.panels[0].note.empty() ? 0 : note_room);
  for (const PlacedMark& mark : block.marks.marks) {
    const double x = plot.x() + mark.x, y = base - 1.3 * text.size * mark.row;
    if (mark.text.empty()) continue;  // part of a range: its line remains within the plot
    canvas.line({x, y - 1.1 * text.size}, {x, plot.y()}, {palette().event, 0.5});
    canvas.text({x + 2, y - 0.4 * text.size}, mark.text, text);
  }
}

/// Draws with the upper left corner of the first plot at `plot`.
void draw_block(Canvas& canvas, const Block& block, const PagePoint& plot, double height, const SeriesLooks& looks,
                const ChartStyle& style) {
  draw_marks(canvas, block, plot, style);
  const double each = (height - gaps_height(block)) / static_cast<double>(block.panels.size());
  std::vector<double> mark_lines;
  for (const PlacedMark& mark : block.marks.marks) mark_lines.push_back(plot.x() + mark.x);
  double y = plot.y();
  for (std::size_t i = 0; i < block.panels.size(); ++i) {
    if (i > 0) y += panel_gap + (block.panels[i].note.empty() ? 0 : note_room);
    const PanelDrawing drawing{{plot.x(), y, plot.x() + block.plot_width(), y + each},
                               &block.x,
                               &block.y[i],
                               i + 1 == block.panels.size(),
                               block.left};
    draw_panel(canvas, block.panels[i], drawing, mark_lines, looks, style);
    y += each;
  }
  draw_legend(canvas, block.key, small_style(style), {plot.x() - block.left, y + 3.4 * style.font_size},
              block.width - right_room);
}

/// One entry per named series; none where the figure shows a single name.
std::vector<LegendItem> legend_items(const std::vector<Chart>& charts, const SeriesLooks& looks) {
  std::vector<LegendItem> items;
  for (const Chart& chart : charts)
    for (const ChartPanel& panel : chart.panels)
      for (const ChartSeries& series : panel.series) {
        const auto same = [&](const LegendItem& item) { return item.text == series.name; };
        if (series.name.empty() || std::any_of(items.begin(), items.end(), same)) continue;
        const Stroke stroke{looks.colour(series), 1.1, looks.dash(series)};
        const bool stacked = series.stacked, points = series.points, joined = series.joined, band = !series.to.empty();
        items.push_back({18,
                         [=](Canvas& c, const PagePoint& at) {
                           const PageBox box{at.x() + 3, at.y() - 3.5, at.x() + 15, at.y() + 3.5};
                           if (band)
                             c.rectangle(box, blend(stroke.colour, palette().paper, 0.8), std::nullopt);
                           else if (stacked)
                             c.rectangle(box, blend(stroke.colour, palette().paper, 0.45), Stroke{stroke.colour, 0.5});
                           else if (joined)
                             c.line(at, at + PagePoint(18, 0), stroke);
                           if (points) c.circle(at + PagePoint(9, 0), 1.7, palette().paper, Stroke{stroke.colour, 0.8});
                         },
                         series.name});
      }
  return items.size() > 1 ? items : std::vector<LegendItem>{};
}

void check_style(const ChartStyle& style) {
  if (!(style.width >= 150 && style.width <= 5000))
    throw InputError(fmt::format("chart width is {:g} pt, must be 150 to 5000", style.width));
  if (!(style.font_size >= 4 && style.font_size <= 40))
    throw InputError(fmt::format("chart font size is {:g} pt, must be 4 to 40", style.font_size));
  if (!(style.panel_height == 0 || (style.panel_height >= 30 && style.panel_height <= 5000)))
    throw InputError(
        fmt::format("chart panel height is {:g} pt, must be 30 to 5000, or 0 for automatic", style.panel_height));
}

struct Measured {
  std::vector<Block> blocks;
  double head = 0, foot = 0, plots = 0;  // maximum over all blocks
};

Measured measure_all(const std::vector<Chart>& charts, Arrangement arrangement, const ChartStyle& style) {
  const double width = style.width - 2 * page_margin;
  double shares = 0;
  for (const Chart& chart : charts) shares += require_positive(chart.share, "chart share of the width", "");
  Measured out;
  for (const Chart& chart : charts) {
    const double part = arrangement == Arrangement::below
                            ? width
                            : (width - block_gap * static_cast<double>(charts.size() - 1)) * chart.share / shares;
    out.blocks.push_back(measure(chart, part, panel_height(chart, style), style));
  }
  if (arrangement == Arrangement::below) {
    double left = 0;
    for (const Block& block : out.blocks) left = std::max(left, block.left);
    // All plots share one left side; the marks are measured again with the new width.
    for (Block& block : out.blocks) block.left = left, measure_marks(block, style), measure_head(block, style);
  }
  for (const Block& block : out.blocks) {
    out.head = std::max(out.head, block.head);
    out.foot = std::max(out.foot, block.foot);
    out.plots = std::max(out.plots, plots_height(block, style));
  }
  return out;
}

}  // namespace

Canvas chart_canvas(const std::vector<Chart>& charts, Arrangement arrangement, const ChartStyle& style) {
  check_style(style);
  if (charts.empty()) throw InputError("a picture of charts needs at least one chart");
  const SeriesLooks looks(charts);
  const Measured all = measure_all(charts, arrangement, style);
  const std::vector<LegendItem> legend = legend_items(charts, looks);
  const TextStyle legend_text{style.font_size};
  const double inner = style.width - 2 * page_margin, legend_tall = legend_height(legend, legend_text, inner);
  const bool beside = arrangement == Arrangement::beside;
  double tall = beside ? all.head + all.plots + all.foot : -block_gap;
  if (!beside)
    for (const Block& b : all.blocks) tall += b.head + plots_height(b, style) + b.foot + block_gap;

  const double legend_gap = legend.empty() ? 0 : 3;
  Canvas canvas(style.width, tall + legend_gap + legend_tall + 2 * page_margin);
  PagePoint at(page_margin, page_margin);
  for (const Block& block : all.blocks) {
    const double head = beside ? all.head : block.head, plots = beside ? all.plots : plots_height(block, style);
    draw_head(canvas, block, at, style);
    draw_block(canvas, block, at + PagePoint(block.left, head), plots, looks, style);
    if (beside)
      at.x() += block.width + block_gap;
    else
      at.y() += head + plots + block.foot + block_gap;
  }
  draw_legend(canvas, legend, legend_text, {page_margin, page_margin + tall + legend_gap}, inner);
  return canvas;
}

void draw_chart(const Chart& chart, const std::filesystem::path& path, const ChartStyle& style) {
  draw_charts({chart}, Arrangement::below, path, style);
}

void draw_charts(const std::vector<Chart>& charts, Arrangement arrangement, const std::filesystem::path& path,
                 const ChartStyle& style) {
  picture_format(path);  // reports a wrong extension before any work
  chart_canvas(charts, arrangement, style).save(path, style.pixels_per_inch);
}

}  // namespace trilith::draw
