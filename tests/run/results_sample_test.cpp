// A small collapse, recorded and drawn for inspection, with checks of the pictures' labels.
#include <doctest/doctest.h>

#include "draw/results/results_picture.hpp"
#include "draw/sample_pictures.hpp"
#include "run/falling_span.hpp"

using namespace trilith;

TEST_CASE("sample picture: a recorded span that loses its seat, drawn from its results") {
  const std::filesystem::path file = testing::picture_path("falling_span.h5");
  testing::record_falling_span(file);
  const results::ResultsReader reader(file);
  std::vector<draw::Scene> scenes;
  for (const double t : {0.0, 0.9, 1.4, 3.0}) scenes.push_back(draw::results_scene(reader, t, {false, true}));
  draw::draw_panels(scenes, 2, {}, testing::picture_path("falling_span.png"));
  draw::draw_scene(draw::results_scene(reader, 0.5, {true, false}), {},
                   testing::picture_path("falling_span_forces.png"));
  draw::Chart chart = draw::history_chart({{&reader, ""}}, {});
  chart.marks = draw::event_marks(reader);
  draw::draw_charts({chart, draw::results_energy_chart({&reader, ""}, draw::EnergyView::stacked)},
                    draw::Arrangement::below, testing::picture_path("falling_span_histories.png"));

  CHECK(scenes[0].title == "consolidation");
  CHECK(scenes[0].ghosts.empty());
  REQUIRE(scenes[2].bearings.size() == 2);
  CHECK(scenes[1].bearings[0].state == draw::BearingMark::intact);
  CHECK(scenes[2].bearings[1].state == draw::BearingMark::failed);
  CHECK_FALSE(scenes[3].ghosts.empty());
  CHECK_FALSE(scenes[3].event.empty());
  CHECK(scenes[0].bodies[0].role == draw::BodyRole::fixed_ground);
  CHECK(scenes[0].bodies[2].group == "piers");
}
