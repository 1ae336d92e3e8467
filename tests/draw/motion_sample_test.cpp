// A recorded motion drawn as for a report: three traces and the 5 % spectrum.
#include <doctest/doctest.h>

#include "draw/chart/motion_chart.hpp"
#include "draw/sample_pictures.hpp"
#include "load/motion_read.hpp"
#include "load/record_folder.hpp"

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
