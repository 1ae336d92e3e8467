#include "draw/chart/chart.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "draw/chart/chart_marks.hpp"
#include "draw/chart/chart_panel.hpp"
#include "draw/chart/plot_axis.hpp"
#include "draw/sample_pictures.hpp"

using namespace trilith;
using namespace trilith::draw;

namespace {

Chart one_line(std::vector<double> x, std::vector<double> y) {
  Chart chart;
  chart.title = "test";
  chart.x = {"Time", "s"};
  chart.panels = {{{"Force", "N"}, {{"pier 3", std::move(x), std::move(y)}}}};
  return chart;
}

void refused(const Chart& chart, const std::string& part) {
  try {
    chart_canvas({chart}, Arrangement::below);
    FAIL("not refused: " << part);
  } catch (const InputError& error) {
    CHECK_MESSAGE(std::string(error.what()).find(part) != std::string::npos, error.what());
  }
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("a chart without anything to draw is rejected by name") {
  refused(Chart{}, "no panel");
  Chart bare = one_line({}, {});
  refused(bare, "series 'pier 3' has no points");
  bare.panels[0].series.clear();
  refused(bare, "panel 'Force' has no series");
  refused(one_line({0, 1}, {0}), "2 values of x and 1 of y");
  refused(one_line({0, 1}, {not_a_number, infinite}), "no point that can be drawn");
  Chart log = one_line({-1, 0}, {1, 2});
  log.x.scale = AxisScale::logarithmic;
  refused(log, "logarithmic");
}

TEST_CASE("reversed axis ends and invalid styles are rejected") {
  Chart chart = one_line({0, 1}, {2, 3});
  chart.x.low = 3, chart.x.high = 1;
  refused(chart, "from 3 to 1");
  chart = one_line({0, 1}, {2, 3});
  chart.panels[0].y.low = not_a_number;
  refused(chart, "finite");
  chart = one_line({0, 1}, {2, 3});
  chart.panels[0].y.scale = AxisScale::logarithmic;
  chart.panels[0].y.low = 0;
  refused(chart, "above 0");
  ChartStyle narrow;
  narrow.width = 10;
  CHECK_THROWS_AS(chart_canvas({one_line({0, 1}, {2, 3})}, Arrangement::below, narrow), InputError);
  CHECK_THROWS_AS(draw_chart(one_line({0, 1}, {2, 3}), "a.gif"), InputError);
}

TEST_CASE("gaps of NaN and infinity never reach the file") {
  const Chart chart = one_line({0, 1, 2, 3, not_a_number, 5, 6, 7}, {1, 2, not_a_number, 4, 5, infinite, 7, 1e300});
  const std::string svg = chart_canvas({chart}, Arrangement::below).bytes(PictureFormat::svg);
  CHECK(svg.find("nan") == std::string::npos);
  CHECK(svg.find("inf") == std::string::npos);
}

TEST_CASE("the file of a long series stays small") {
  std::vector<double> x(1000000), y(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = 1e-4 * static_cast<double>(i);
    y[i] = std::sin(300 * x[i]) + 0.3 * std::sin(7777 * x[i]);
  }
  CHECK(chart_canvas({one_line(x, y)}, Arrangement::below).bytes(PictureFormat::svg).size() < 300000);
}

TEST_CASE("the same chart gives the same bytes") {
  const Chart chart = one_line({0, 1, 2}, {5e6, 2e6, 3e6});
  for (const PictureFormat format : {PictureFormat::svg, PictureFormat::pdf, PictureFormat::png})
    CHECK(chart_canvas({chart}, Arrangement::below).bytes(format) ==
          chart_canvas({chart}, Arrangement::below).bytes(format));
}

TEST_CASE("constant, tiny, huge and single values still give an axis") {
  for (const double v : {0.0, 5.0, -3e-14, 4e18, 1e120}) {
    CHECK_NOTHROW(chart_canvas({one_line({0, 1}, {v, v})}, Arrangement::below));
    CHECK_NOTHROW(chart_canvas({one_line({v}, {v})}, Arrangement::below));
  }
  CHECK_NOTHROW(chart_canvas({one_line({0, 1}, {1e17, 1e17 + 16})}, Arrangement::below));
  for (const double low : {0.0, 7.0}) {
    Chart chart = one_line({0, 1}, {1, 2});
    chart.panels[0].y.low = low;
    chart.x.high = -4;
    CHECK_NOTHROW(chart_canvas({chart}, Arrangement::below));
  }
}

TEST_CASE("stacked series need one x and no negative values") {
  Chart chart = one_line({0, 1}, {1, 2});
  chart.panels[0].series.push_back({"second", {0, 2}, {1, 1}});
  for (ChartSeries& series : chart.panels[0].series) series.stacked = true;
  refused(chart, "x differs");
  chart.panels[0].series[1] = {"second", {0, 1}, {1, -1}, Dash::solid, false, true};
  refused(chart, "below 0");
}

TEST_CASE("an axis shows its values in the engineering unit") {
  ValueRange range;
  range.add(0), range.add(1.3e6);
  const PlotAxis axis = plot_axis({"Force", "N"}, range, 0.05, 6, "test");
  CHECK(axis.title == "Force (MN)");
  CHECK(axis.low == 0);
  CHECK(axis.high > 1.3e6);
  CHECK(axis.texts.front() == "0.0");
  CHECK(axis.share(axis.low) == 0);
  CHECK(axis.share(axis.high) == 1);
}

TEST_CASE("a negligible range of values gets an axis around its value") {
  for (const double tiny : {5e-324, 1e-310, 1e-200}) {
    ValueRange range;
    range.add(0), range.add(tiny);
    const PlotAxis axis = plot_axis({"Force", "N"}, range, 0.05, 6, "test");
    CHECK(axis.low < 0);
    CHECK(axis.high > 0.5);
    CHECK(axis.ticks.size() >= 2);
  }
}

TEST_CASE("no name of a mark crosses another mark's line or name") {
  const TextStyle style;
  for (int seed = 0; seed < 50; ++seed) {
    std::vector<PlacedMark> marks;
    for (int i = 0; i < 3 + seed / 5; ++i)
      marks.push_back({static_cast<double>((seed * 131 + i * i * 57 + i * 17) % 330), 0, "event " + std::to_string(i)});
    const PlacedMarks placed = place_marks(marks, style, 400);
    for (const PlacedMark& a : placed.marks)
      for (const PlacedMark& b : placed.marks) {
        if (&a == &b || a.text.empty() || b.text.empty() || a.x > b.x) continue;
        const double end = a.x + text_width(a.text, style);
        if (b.x < end && b.x > a.x) CHECK(a.row > b.row);
      }
    CHECK(placed.rows <= 6);
    CHECK((placed.key.empty() || placed.key.size() == marks.size()));
  }
}

TEST_CASE("a stacked series begins at the sum of those before it") {
  Chart chart = one_line({0, 1}, {1, 2});
  chart.panels[0].series.push_back({"second", {0, 1}, {3, 5}});
  chart.panels[0].series.push_back({"third", {0, 1}, {10, 20}});
  for (ChartSeries& series : chart.panels[0].series) series.stacked = true;
  const ChartPanel panel = checked_panel(chart.panels[0], AxisScale::linear, "test");
  CHECK(panel.series[0].y == std::vector<double>{1, 2});
  CHECK(panel.series[1].y == std::vector<double>{4, 7});
  CHECK(panel.series[2].y == std::vector<double>{14, 27});
}
