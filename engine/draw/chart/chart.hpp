// Line charts for reports: panels over one x axis, several series, event marks, response spectra.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/unit_system.hpp"
#include "draw/canvas.hpp"

namespace trilith::draw {

enum class AxisScale { linear, logarithmic };

/// One axis. Ticks, decimals and the unit's engineering prefix follow from the values. `low`, `high`: fixed ends in the
/// values' own unit; free ends fit the data (x exactly, y with a margin).
struct ChartAxis {
  std::string label;
  std::string unit;
  AxisScale scale = AxisScale::linear;
  std::optional<double> low = std::nullopt, high = std::nullopt;
  /// Words instead of numbers: value i is labelled words[i], and the axis shows all words.
  std::vector<std::string> words = {};
};

/// One line through (x[i], y[i]). Points that are not finite, or not above zero on a logarithmic axis, are gaps. Series
/// with the same name share a colour and an entry in the legend; series without a name have the first colour and no
/// entry.
struct ChartSeries {
  std::string name;
  std::vector<double> x, y;
  Dash dash = Dash::solid;
  bool points = false;                          ///< circles at the points (for short series)
  bool stacked = false;                         ///< filled, and stacked on the sum of the panel's previous stacked
                                                ///< series
  std::optional<Colour> colour = std::nullopt;  ///< none: by order of first appearance of the name
  bool joined = true;                           ///< a line through the points; false: points only
  /// Not empty: a band between y and `to`, of as many values, painted below all lines.
  std::vector<double> to = {};
};

/// An event marked by a vertical line, at `x` in the x axis' unit.
struct ChartMark {
  double x = 0;
  std::string text;
};

/// One plot in the stack. `note`: a short text above the plot's right end, e.g. "peak 0.349 g at 3.14 s".
struct ChartPanel {
  ChartAxis y;
  std::vector<ChartSeries> series;
  std::string note = {};
};

/// A stack of panels over one x axis. `share`: width relative to neighbouring charts. Values are in the units of the
/// axes, and are shown in `units`.
struct Chart {
  std::string title;
  std::string subtitle;
  ChartAxis x;
  std::vector<ChartPanel> panels;
  std::vector<ChartMark> marks;
  double share = 1;
  UnitSystem units = {};
};

/// Page [pt] and type. `panel_height` 0: chosen by the number of panels.
struct ChartStyle {
  double width = 510;  ///< 180 mm, two columns of a journal
  double panel_height = 0;
  double font_size = 7.5;
  double pixels_per_inch = 220;
};

enum class Arrangement { beside, below };

/// Draws one or more charts, each next to or below the one before. Throws InputError (with panel and series) for no
/// panel, a panel without series, x and y of different length, or no point to draw. It also throws for stacked series
/// with different x or negative values, fixed ends in the wrong order, and a logarithmic end not above zero.
Canvas chart_canvas(const std::vector<Chart>& charts, Arrangement arrangement, const ChartStyle& style = {});

/// One chart to a .svg, .pdf or .png file. Throws InputError as chart_canvas and Canvas::save.
void draw_chart(const Chart& chart, const std::filesystem::path& path, const ChartStyle& style = {});

/// Several charts in one file, e.g. three traces and their spectrum.
void draw_charts(const std::vector<Chart>& charts, Arrangement arrangement, const std::filesystem::path& path,
                 const ChartStyle& style = {});

}  // namespace trilith::draw
