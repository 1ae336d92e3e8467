// A recorded motion drawn as for a report: three traces and the 5 % spectrum.
#include <doctest/doctest.h>

#include <cmath>

#include "draw/chart/motion_chart.hpp"
#include "draw/sample_pictures.hpp"
#include "load/motion_read.hpp"
#include "load/record_folder.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::draw;
TEST_CASE("sample picture: El Centro 1940, traces and spectrum") {
  const GroundMotion ns = read_motion(testing::own_record("elcentro_1940_rest_ns.csv"));
  const GroundMotion up = read_motion(testing::own_record("elcentro_1940_rest_up.csv"));
  const std::vector<Chart> charts = {motion_chart(ns), spectrum_chart({ns})};
  for (const char* name : {"elcentro.png", "elcentro.svg", "elcentro.pdf"})
    draw_charts(charts, Arrangement::beside, testing::picture_path(name));
  CHECK(std::filesystem::file_size(testing::picture_path("elcentro.svg")) > 10000);
  draw_charts({spectrum_chart({ns, up, ns.scaled(1.5)})}, Arrangement::below,
              testing::picture_path("elcentro_spectra.png"));
}

TEST_CASE("the spectrum of a slow motion begins at its peak acceleration in g") {
  constexpr double step = 0.01, peak = 0.3;  // s, g
  std::vector<double> acceleration;
  for (int i = 0; i <= 2000; ++i)
    acceleration.push_back(peak * standard_gravity * std::pow(std::sin(M_PI * i / 2000), 2));
  const Chart chart = spectrum_chart({GroundMotion(acceleration, step)});
  const ChartSeries& series = chart.panels[0].series[0];
  CHECK(testing::near(series.x[0], 0.05, 1e-9));
  CHECK(testing::near(series.y[0], peak, 1e-2));
}
