// The line of thrust in pictures.
#include <doctest/doctest.h>

#include "draw/results/results_picture.hpp"
#include "results/sample_run.hpp"

using namespace trilith;
using namespace trilith::draw;
using namespace trilith::testing;

TEST_CASE("the line of thrust runs from springing to springing and skips bodies that rest on its ends") {
  const Folder folder;
  results::Header header = sample_header(4);
  header.bodies[0].groups = header.bodies[3].groups = "ends";
  header.bodies[1].groups = header.bodies[2].groups = "ring";
  results::ResultsWriter writer(folder / "run.h5", header);
  writer.begin_stage("rest", "dynamic", 0);
  SampleRow row(header, 0);
  row.contacts = {{{1, 0, 0}, {6, 8, 0}, 0, 1, results::ContactState::sticking},
                  {{2, 1, 0}, {6, 0, 0}, 1, 2, results::ContactState::sticking},
                  {{3, 0, 0}, {6, -8, 0}, 2, 3, results::ContactState::sticking},
                  {{1.5, 2, 0}, {0, 1, 0}, 1, 3, results::ContactState::sticking}};
  row.frame.contacts = row.contacts;
  row.append_to(writer);
  writer.finish();
  SceneChoice choice;
  choice.thrust = "ring";
  const Scene scene = results_scene(results::ResultsReader(folder / "run.h5"), 0, choice);
  REQUIRE(scene.lines.size() == 1);
  REQUIRE(scene.lines[0].size() == 3);
  CHECK((scene.lines[0][0] - Vec2(1, 0)).norm() < 1e-12);
  CHECK((scene.lines[0][1] - Vec2(2, 1)).norm() < 1e-12);
  CHECK((scene.lines[0][2] - Vec2(3, 0)).norm() < 1e-12);
}
