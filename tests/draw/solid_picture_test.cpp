// Pictures of models in space, for inspection after a run (in `pictures` next to the test program), and checks:
// complete labels, and no hidden part is visible.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "draw/results/results_picture.hpp"
#include "draw/sample_pictures.hpp"
#include "draw/scene/scene_faces.hpp"
#include "draw/scene/scene_legend.hpp"
#include "draw/scene/scene_view.hpp"
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

/// Width of a body in the picture [m].
double width_of(const SceneBody& body) {
  double low = body.outline[0].x(), high = low;
  for (const Vec2& p : body.outline) low = std::min(low, p.x()), high = std::max(high, p.x());
  return high - low;
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

TEST_CASE("the ground far below airborne bodies is in the picture") {
  const testing::Folder folder;
  const std::vector<FlyingBox> boxes{{{3, 3, 0.5}, {0, 0, -0.5}, Vec3::Zero(), Vec3::Zero(), "ground", "fixed"},
                                     {{2, 2, 0.5}, {40, 0, -9}, Vec3::Zero(), Vec3::Zero(), "aside", "fixed"},
                                     {{0.2, 0.2, 0.2}, {0, 0, 12}}};
  record_boxes(folder / "falls.h5", boxes, 2, 0.05, false);
  const Scene scene = results_scene(results::ResultsReader(folder / "falls.h5"), 0, seen_from("front"));
  REQUIRE(scene.bodies.size() == 2);  // without bodies aside of the cut
  double low = 0;
  for (const SceneBody& body : scene.bodies)
    for (const Vec2& p : body.outline) low = std::min(low, p.y());
  CHECK(low < 0);
}

TEST_CASE("ground in space ends at one place in all panels and none of it is cut off by them") {
  const testing::Folder folder;
  record_boxes(folder / "wall.h5", falling_wall(), 21, 0.05, false);
  const std::vector<Scene> scenes =
      results_scenes(results::ResultsReader(folder / "wall.h5"), {0, 1}, seen_from("-60,20"));
  REQUIRE(scenes[0].bodies[0].role == BodyRole::fixed_ground);
  CHECK(scenes[0].bodies[0].outline == scenes[1].bodies[0].outline);
  CHECK(width_of(scenes[0].bodies[0]) < 10);  // of 60 m
  const SceneView view = scene_view(scenes, {});
  for (const Scene& scene : scenes)
    for (const Vec2& p : scene.bodies[0].outline) CHECK(view.world.contains(p));
}

TEST_CASE("supports near free bodies are drawn completely unless they extend far beyond") {
  const testing::Folder folder;
  const double half = 0.5, size = std::sqrt(3.0);  // of the box of the free body
  const auto drawn = [&](double beyond) {
    const std::vector<FlyingBox> boxes{
        {{half, half, half}, {0, 0, half}},
        {{half + beyond / 2, 0.4, 0.1}, {beyond / 2, 0, -0.1}, Vec3::Zero(), Vec3::Zero(), "rail", "fixed"}};
    record_boxes(folder / "rail.h5", boxes, 1, 1, false);
    return width_of(results_scene(results::ResultsReader(folder / "rail.h5"), 0, seen_from("front")).bodies[1]);
  };
  CHECK(near(drawn(1.9 * size), 1 + 1.9 * size, 1e-9));
  CHECK(near(drawn(2.1 * size), 1 + 0.08 * size, 1e-9));
}

TEST_CASE("axes of the world are drawn in an empty corner, and ground has one colour in the legend") {
  const testing::Folder folder;
  const std::vector<FlyingBox> boxes{
      {{5, 1, 0.5}, {0, 0, 0}, Vec3::Zero(), Vec3::Zero(), "", "fixed"},
      {{0.5, 1, 1}, {4.5, 0, 2.5}, Vec3::Zero(), Vec3::Zero(), "", "fixed"},
      {{5, 1, 0.5}, {0, 0, 1}},
  };
  record_boxes(folder / "corner.h5", boxes, 1, 1, false);
  const Scene scene = results_scene(results::ResultsReader(folder / "corner.h5"), 0, seen_from("front"));
  const SceneView view = scene_view({scene}, {});
  const double scale = 40;
  const PageView page{view.world, {0, 0, scale * view.world.width(), scale * view.world.height()}, scale};
  CHECK(corner_for_axes({scene}, page) == PanelCorner::upper_left);
  const std::vector<LegendItem> legend = scene_legend({scene}, view, scale, {});
  REQUIRE(legend.size() == 3);  // after the scale
  CHECK(legend[1].text == "stone 0, stone 1");
  CHECK(legend[2].text == "stones");
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
