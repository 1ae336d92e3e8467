// Pictures of models in space, to be looked at after a run (in `pictures` beside the test program), and what is checked
// of them: that they say what they should, and that nothing shows through what is before it.
#include <doctest/doctest.h>

#include <algorithm>

#include "base/error.hpp"
#include "draw/results_picture.hpp"
#include "draw/sample_pictures.hpp"
#include "draw/solid_samples.hpp"
#include "near.hpp"
#include "results/sample_run.hpp"

using namespace trilith;
using namespace trilith::draw;
using namespace trilith::testing;

namespace {

void save_and_check(const std::vector<Scene>& scenes, int columns, const char* name) {
  const Canvas canvas = scene_canvas(scenes, columns);
  check_texts(canvas);
  canvas.save(picture_path(name));
}

SceneChoice seen_from(const char* view) {
  SceneChoice choice;
  choice.from = view_direction(view);
  return choice;
}

}  // namespace

TEST_CASE("a wall of 200 bricks falls, in panels, as svg and pdf") {
  const testing::Folder folder;
  record_boxes(folder / "wall.h5", falling_wall(), 21, 0.05, false);
  const results::ResultsReader reader(folder / "wall.h5");
  const SceneChoice choice = seen_from("-60,20");
  const std::vector<Scene> scenes{results_scene(reader, 0, choice), results_scene(reader, 0.6, choice),
                                  results_scene(reader, 0.8, choice), results_scene(reader, 1, choice)};
  CHECK(scenes[0].faces.size() >= 600);
  save_and_check(scenes, 2, "solid-wall.png");
  save_and_check({scenes[2]}, 1, "solid-wall.svg");
  save_and_check({scenes[2]}, 1, "solid-wall.pdf");
  SceneChoice moved = choice;
  moved.colour = "displacement";
  moved.ghost = true;
  save_and_check({results_scene(reader, 1, moved)}, 1, "solid-wall-moved.png");
}

TEST_CASE("the ground far below what is in the air is in the picture") {
  const testing::Folder folder;
  const std::vector<FlyingBox> boxes{{{3, 3, 0.5}, {0, 0, -0.5}, Vec3::Zero(), Vec3::Zero(), "ground", "fixed"},
                                     {{2, 2, 0.5}, {40, 0, -9}, Vec3::Zero(), Vec3::Zero(), "aside", "fixed"},
                                     {{0.2, 0.2, 0.2}, {0, 0, 12}}};
  record_boxes(folder / "falls.h5", boxes, 2, 0.05, false);
  const Scene scene = results_scene(results::ResultsReader(folder / "falls.h5"), 0, seen_from("front"));
  REQUIRE(scene.bodies.size() == 2);  // not what lies aside of it
  double low = 0;
  for (const SceneBody& body : scene.bodies)
    for (const Vec2& p : body.outline) low = std::min(low, p.y());
  CHECK(low < 0);
}

TEST_CASE("a dome opens: whole, from above, and cut through its middle") {
  const testing::Folder folder;
  record_boxes(folder / "dome.h5", opening_dome(), 11, 0.1, false);
  const results::ResultsReader reader(folder / "dome.h5");
  SceneChoice cut = seen_from("front");
  cut.cut = CutPlane{Vec3::UnitY(), 0};
  save_and_check({results_scene(reader, 0, {}), results_scene(reader, 1, {}),
                  results_scene(reader, 1, seen_from("top")), results_scene(reader, 1, cut)},
                 2, "solid-dome.png");
  cut.from = view_direction("-70,20");
  cut.colour = "speed";
  cut.forces = true;
  save_and_check({results_scene(reader, 1, cut)}, 1, "solid-dome-cut.png");
}
