// A recorded motion as it is drawn for a report: three traces and the 5 % spectrum.
#include <doctest/doctest.h>

#include "load/motion_read.hpp"
#include "load/record_folder.hpp"
#include "record/motion_chart.hpp"
#include "record/sample_pictures.hpp"

using namespace trilith;

TEST_CASE("sample picture: El Centro 1940, traces and spectrum") {
  const GroundMotion ns = read_motion(testing::own_record("elcentro_1940_rest_ns.csv"));
  const GroundMotion up = read_motion(testing::own_record("elcentro_1940_rest_up.csv"));
  const std::vector<Chart> charts = {motion_chart(ns), spectrum_chart({ns})};
  for (const char* name : {"elcentro.png", "elcentro.svg", "elcentro.pdf"})
    draw_charts(charts, Arrangement::beside, sample::picture_path(name));
  CHECK(std::filesystem::file_size(sample::picture_path("elcentro.svg")) > 10000);
  draw_charts({spectrum_chart({ns, up, ns.scaled(1.5)})}, Arrangement::below,
              sample::picture_path("elcentro_spectra.png"));
}
