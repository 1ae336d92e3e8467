#include "draw/scene/scene_picture.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <random>

#include "base/error.hpp"
#include "draw/scene/scene_labels.hpp"
#include "draw/scene/scene_legend.hpp"
#include "draw/scene/scene_marks.hpp"
#include "draw/scene/scene_view.hpp"

using namespace trilith;
using namespace trilith::draw;

namespace {

std::vector<Vec2> box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Scene block_on_ground() {
  Scene scene;
  scene.title = "Block";
  scene.bodies.push_back({"ground", box(-1e5, -1e5, 1e5, 0), BodyRole::fixed_ground});
  scene.bodies.push_back({"block", box(0, 0, 2, 1)});
  return scene;
}

void refused(const Scene& scene, const std::string& part, const PictureStyle& style = {}) {
  try {
    scene_canvas({scene}, 1, style);
    FAIL("not refused: " << part);
  } catch (const InputError& error) {
    CHECK_MESSAGE(std::string(error.what()).find(part) != std::string::npos, error.what());
  }
}

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("times in pictures have two decimals, and three digits where these would show zero") {
  CHECK(time_label(12.345) == "12.35 s");
  CHECK(time_label(0) == "0.00 s");
  CHECK(time_label(0.0333) == "0.03 s");
  CHECK(time_label(0.0045) == "0.0045 s");
  CHECK(time_label(-2.34567e-5) == "-2.35e-05 s");
}

TEST_CASE("the view fits the free bodies and a border of a large ground") {
  const SceneView view = scene_view({block_on_ground()}, {});
  CHECK(view.world.x0 < 0);
  CHECK(view.world.x1 > 2);
  CHECK(view.world.y1 > 1);
  CHECK(view.world.width() < 4);
  CHECK(view.world.height() < 3);
}

TEST_CASE("the view takes in the tips of the arrows, and a small ground whole") {
  Scene scene = block_on_ground();
  scene.bodies[0].outline = box(-0.1, -0.1, 2.1, 0);
  scene.forces = {{{2, 0.5}, {5e3, 0}}, {{0, 0.5}, {-1e3, 0}}};
  const SceneView view = scene_view({scene}, {});
  CHECK(view.largest_force == 5e3);
  CHECK(view.world.x1 > 2 + view.longest_arrow);
  CHECK(view.world.y0 < -0.1);
}

TEST_CASE("panels share one view, that holds every scene") {
  Scene far = block_on_ground();
  far.bodies[1].outline = box(30, 10, 32, 11);
  const SceneView view = scene_view({block_on_ground(), far}, {});
  CHECK(view.world.x0 < 0);
  CHECK(view.world.x1 > 32);
  CHECK(view.world.y1 > 11);
}

TEST_CASE("one distant stone of a hundred does not shrink the picture, a fifth of them does") {
  for (const int flown : {1, 20}) {
    Scene scene = block_on_ground();
    for (int i = 1; i < 100; ++i)
      scene.bodies.push_back(
          {"stone", i < flown ? box(200, 0, 202, 1) : box(2 * (i % 10), i / 10, 2 * (i % 10) + 2, i / 10 + 1)});
    scene.bodies[1].outline = box(200, 0, 202, 1);
    const SceneView view = scene_view({scene}, {});
    CHECK((view.world.x1 > 202) == (flown == 20));
    CHECK(view.world.x1 > 20);
  }
}

TEST_CASE("scenes that cannot be drawn are rejected by name") {
  refused(Scene{}, "no body");
  Scene scene = block_on_ground();
  scene.bodies[1].outline[2].y() = nowhere;
  refused(scene, "scene 'Block', body 'block': point 3");
  scene = block_on_ground();
  scene.bodies[1].outline.resize(2);
  refused(scene, "2 points");
  scene = block_on_ground();
  scene.bodies[1].value = nowhere;
  refused(scene, "value");
  scene = block_on_ground();
  scene.forces.push_back({{0, 0}, {0, nowhere}});
  refused(scene, "contact force");
  scene = block_on_ground();
  scene.bearings.push_back({{0, 0}, {2e9, 0}});
  refused(scene, "bearing");
  CHECK_THROWS_AS(scene_canvas({}, 1), InputError);
  CHECK_THROWS_AS(scene_canvas({block_on_ground()}, 0), InputError);
}

TEST_CASE("invalid picture styles are rejected") {
  PictureStyle style;
  style.view = WorldBox{0, 0, -1, 1};
  refused(block_on_ground(), "view of the picture", style);
  style = {};
  style.width = 1;
  refused(block_on_ground(), "picture width", style);
  style = {};
  style.font_size = 400;
  refused(block_on_ground(), "font size", style);
  CHECK_THROWS_AS(draw_scene(block_on_ground(), {}, "a.tiff"), InputError);
}

TEST_CASE("the same scene gives the same bytes in every format") {
  Scene scene = block_on_ground();
  scene.bearings.push_back({{0, 0}, {0, 0}, BearingMark::failed});
  scene.forces.push_back({{1, 0}, {1e3, 2e4}});
  for (const PictureFormat format : {PictureFormat::svg, PictureFormat::pdf, PictureFormat::png})
    CHECK(scene_canvas({scene}, 1).bytes(format) == scene_canvas({scene}, 1).bytes(format));
}

TEST_CASE("pictures of very small, large, wide and tall structures fit the page") {
  for (const double size : {1e-4, 1.0, 1e6})
    for (const double aspect : {1e-3, 1.0, 1e3}) {
      Scene scene;
      scene.title = "A title that is rather long for a picture that is as narrow as a tower";
      scene.bodies.push_back({"", box(0, 0, size, size * aspect)});
      scene.bodies.push_back({"", box(-8e8, -8e8, 8e8, 0), BodyRole::moved_ground});
      const Canvas canvas = scene_canvas({scene}, 1);
      CHECK(canvas.width() <= 510 + 1e-9);
      CHECK(canvas.height() <= 470);
      CHECK(canvas.height() >= 60);
      CHECK(canvas.bytes(PictureFormat::svg).size() < 600000);  // the hatch of a ground of 1e9 m stays within the page
      for (const PageBox& text : canvas.text_boxes()) {
        CHECK(text.x0 >= 0);
        CHECK(text.x1 <= canvas.width());
        CHECK(text.y1 <= canvas.height());
      }
    }
}

TEST_CASE("signs of bearings at one place are moved apart and keep their order") {
  const std::vector<PagePoint> apart = spread({{10, 5}, {10.5, 5}, {100, 5}, {10, 5}}, 6);
  for (std::size_t i = 0; i < apart.size(); ++i)
    for (std::size_t j = i + 1; j < apart.size(); ++j) CHECK((apart[i] - apart[j]).norm() > 5.5);
  CHECK(apart[0].x() < apart[1].x());
  CHECK(apart[2] == PagePoint(100, 5));
}

TEST_CASE("labels cover no other body, mark or label") {
  std::mt19937 random(11);
  int written = 0;
  for (int trial = 0; trial < 20; ++trial) {
    Scene scene;
    for (int i = 0; i < 14; ++i) {
      const double x = 3 * i + static_cast<double>(random() % 100) / 50,
                   wide = 0.2 + static_cast<double>(random() % 60) / 10;
      scene.bodies.push_back({fmt::format("pier {}", i), box(x, 0, x + wide, 1 + static_cast<double>(random() % 4))});
    }
    const SceneView view = scene_view({scene}, {});
    const PageView page{
        view.world, {0, 0, 500, 500 * view.world.height() / view.world.width()}, 500 / view.world.width()};
    Canvas canvas(500, 500);
    const PageBox mark{100, 0, 140, 500};
    draw_labels(canvas, scene, view, page, {mark}, {7});
    written += static_cast<int>(canvas.text_boxes().size());
    for (const PageBox& text : canvas.text_boxes()) {
      CHECK_FALSE(text.overlaps(mark));
      for (const SceneBody& body : scene.bodies) {
        const std::vector<PagePoint> o = page_outline(page, body.outline);
        const PageBox b{o[0].x(), o[2].y(), o[2].x(), o[0].y()};
        if (b.overlaps(text)) CHECK((text.x0 >= b.x0 && text.x1 <= b.x1 && text.y0 >= b.y0 && text.y1 <= b.y1));
      }
      for (const PageBox& other : canvas.text_boxes())
        if (&other != &text) CHECK_FALSE(other.overlaps(text));
    }
  }
  CHECK(written > 100);
}

TEST_CASE("the legend has exactly the items that occur") {
  Scene scene = block_on_ground();
  scene.bearings = {{{0, 0}, {0, 0}, BearingMark::failed}, {{2, 0}, {2, 0}, BearingMark::intact}};
  scene.forces.push_back({{1, 0}, {0, 1.23e6}});
  std::vector<std::string> texts;
  PictureStyle style;
  for (const LegendItem& item : scene_legend({scene}, scene_view({scene}, style), 200, style))
    texts.push_back(item.text);
  CHECK(texts == std::vector<std::string>{"0.2 m", "fixed ground", "free body", "bearing intact", "bearing failed",
                                          "contact force 1 MN (largest 1.23 MN)"});
  style.units = UnitSystem("kip ft");
  texts.clear();
  for (const LegendItem& item : scene_legend({scene}, scene_view({scene}, style), 200, style))
    texts.push_back(item.text);
  CHECK(texts.front() == "1 ft");
  CHECK(texts.back() == "contact force 200 kip (largest 277 kip)");
}

TEST_CASE("a label keeps its position relative to its body in all panels") {
  Scene scene;
  scene.bodies.push_back({"deck", box(0, 0, 6, 1)});
  scene.bodies.push_back({"pier", box(2, -5, 4, 0)});
  for (SceneBody& body : scene.bodies) body.start = body.outline;
  const PageView page{{-5, -6, 20, 6}, {0, 0, 500, 240}, 20};
  const auto place_of = [&](double moved, const std::vector<PageBox>& marks) {
    Scene now = scene;
    for (SceneBody& body : now.bodies)
      for (Vec2& p : body.outline) p.x() += moved;
    Canvas canvas(500, 240);
    draw_labels(canvas, now, scene_view({now}, {}), page, marks, {7});
    REQUIRE(canvas.text_boxes().size() == 2);
    return canvas.text_boxes()[0].x0 - page.scale * moved;
  };
  const double at_start = place_of(0, {});
  CHECK(std::abs(place_of(3, {}) - at_start) < 1e-9);
  CHECK(std::abs(place_of(3, {{400, 0, 420, 240}}) - at_start) < 1e-9);
}

TEST_CASE("a scale of colours covers its values, with 0 in the middle colour where they have both signs") {
  Scene scene = block_on_ground();
  scene.bodies.push_back({"tile", box(3, 0, 4, 1)});
  scene.bodies[1].value = -100, scene.bodies[2].value = 2;
  const SceneView view = scene_view({scene}, {});
  CHECK(view.low == -100);
  CHECK(view.high == 2);
  Scene even = scene;
  even.bodies[2].value = 100;
  const SceneView both = scene_view({even}, {});
  CHECK(value_colour(view, 0).red == value_colour(both, 0).red);
  CHECK(std::abs(value_colour(view, 100. / 102).red - value_colour(both, 0.5).red) < 1e-12);
}

TEST_CASE("a picture of a falling body includes the ground below") {
  Scene scene;
  scene.bodies.push_back({"ground", box(-10, -3, 10, -2), BodyRole::fixed_ground});
  scene.bodies.push_back({"block", box(0, 0, 4, 1)});
  CHECK(scene_view({scene}, {}).world.y0 < -2);
  scene.bodies[0].outline = box(-10, -30, 10, -20);  // too far away to be drawn
  CHECK(scene_view({scene}, {}).world.y0 > -2);
}
