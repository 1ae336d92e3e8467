// Scenes for inspection; checked: they are drawn, and their texts stay on the page without overlap.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <random>
#include <string>

#include "draw/sample_pictures.hpp"
#include "draw/scene/scene_picture.hpp"

using namespace trilith;
using namespace trilith::draw;

namespace {

constexpr double ft = 0.3048;

std::vector<Vec2> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

/// Rotated by `degrees` about its point `pivot`, then moved.
std::vector<Vec2> moved(std::vector<Vec2> outline, const Vec2& pivot, double degrees, const Vec2& shift) {
  const double a = degrees * std::acos(-1.0) / 180;
  for (Vec2& p : outline) {
    const Vec2 d = p - pivot;
    p = pivot + shift + Vec2(std::cos(a) * d.x() - std::sin(a) * d.y(), std::sin(a) * d.x() + std::cos(a) * d.y());
  }
  return outline;
}

void show(const std::vector<Scene>& scenes, int columns, const PictureStyle& style, const char* name) {
  testing::check_texts(scene_canvas(scenes, columns, style));
  for (const char* ending : {".png", ".svg", ".pdf"})
    draw_panels(scenes, columns, style, testing::picture_path((std::string(name) + ending).c_str()));
}

constexpr double spans[] = {30, 60, 80, 80, 80, 60, 30};
constexpr double depths[] = {2.5, 4, 5, 5, 5, 4, 2.5};
constexpr double heights[] = {40, 50, 60, 60, 50, 40};

std::vector<Vec2> pier(double x, double height) {
  const double footing = height > 45 ? 12 : 10, foot = -height;
  std::vector<Vec2> out = {{-footing, foot}, {footing, foot}, {footing, foot + 4}, {2, foot + 4},
                           {2, 0},           {-2, 0},         {-2, foot + 4},      {-footing, foot + 4}};
  for (Vec2& p : out) p = Vec2((p.x() + x) * ft, p.y() * ft);
  return out;
}

std::vector<Vec2> scaled(std::vector<Vec2> points) {
  for (Vec2& p : points) p *= ft;
  return points;
}

/// The valley bridge: level deck at y = 0, ground stepped below it; large ground blocks.
Scene bridge() {
  Scene scene;
  scene.title = "Seven-span bridge";
  scene.bodies.push_back({"left ground",
                          scaled({{-1000, -800}, {15, -800}, {15, -40}, {8, -40}, {8, -20}, {-1000, -20}}),
                          BodyRole::moved_ground, "left ground"});
  scene.bodies.push_back({"right ground",
                          scaled({{15, -800},
                                  {1400, -800},
                                  {1400, -20},
                                  {412, -20},
                                  {412, -40},
                                  {375, -40},
                                  {375, -50},
                                  {310, -50},
                                  {310, -60},
                                  {110, -60},
                                  {110, -50},
                                  {45, -50},
                                  {45, -40},
                                  {15, -40}}),
                          BodyRole::moved_ground, "right ground"});
  scene.bodies.push_back({"A0", scaled(rectangle(-12, -20, 0, 0)), BodyRole::free, "abutment"});
  scene.bodies.push_back({"A7", scaled(rectangle(420, -20, 432, 0)), BodyRole::free, "abutment"});
  double x = 0;
  for (int i = 0; i < 7; ++i) {
    const double start = x;
    x += spans[i];
    if (i < 6) scene.bodies.push_back({fmt::format("P{}", i + 1), pier(x, heights[i]), BodyRole::free, "pier"});
    scene.bodies.push_back({fmt::format("span {}", i + 1), scaled(rectangle(start + 0.08, 0, x - 0.08, depths[i])),
                            BodyRole::free, "deck"});
    const bool fixed_left = i % 2 == 0;
    const Vec2 at = Vec2(fixed_left ? start + 1 : x - 1, 0) * ft;
    scene.bearings.push_back({at, at, BearingMark::intact});
  }
  return scene;
}

SceneBody& body(Scene& scene, const std::string& name) {
  for (SceneBody& b : scene.bodies)
    if (b.name == name) return b;
  throw std::runtime_error(name);
}

std::vector<Scene> collapse() {
  Scene a = bridge();
  a.title = "At rest";
  a.time = 0;
  a.stage = "shaking begins";
  Scene b = bridge();
  b.title = "Seat lost";
  b.time = 14.4;
  b.event = "expansion end of span 3 loses its support";
  SceneBody& span = body(b, "span 3");
  span.outline = moved(span.outline, Vec2(170, 0) * ft, 9, Vec2(-1.4, -0.3) * ft);
  b.bearings[2] = {Vec2(91, 0) * ft, span.outline[0], BearingMark::failed};
  Scene c = bridge();
  c.title = "Impact";
  c.time = 15.9;
  c.event = "span 3 hits the ground; impact breaks the bearings of spans 1 and 2";
  SceneBody& fallen = body(c, "span 3");
  fallen.outline = moved(fallen.outline, Vec2(170, 0) * ft, 48, Vec2(-0.5, -0.5) * ft);
  c.bearings[2] = {Vec2(91, 0) * ft, fallen.outline[0], BearingMark::failed};
  c.bearings[0].state = BearingMark::yielded;
  c.bearings[1].state = BearingMark::changed;
  Scene d = c;
  d.title = "Final rest";
  d.time = 80.3;
  d.event = "all velocities below 1e-5 in/s";
  SceneBody& flat = body(d, "span 3");
  flat.outline = scaled(rectangle(112, -56, 192, -51));
  flat.outline = moved(flat.outline, flat.outline[0], -3, Vec2(-30, -4) * ft);
  flat.outline = moved(scaled(rectangle(103, -60, 155, -55)), Vec2(103, -60) * ft, 0, Vec2(0, 0));
  d.bearings[2] = {Vec2(91, 0) * ft, flat.outline[3], BearingMark::failed};
  SceneBody& first = body(d, "span 1");
  first.outline = moved(first.outline, Vec2(30, 0) * ft, 52, Vec2(-5, -17) * ft);
  d.bearings[0] = {Vec2(1, 0) * ft, first.outline[0], BearingMark::failed};
  return {a, b, c, d};
}

}  // namespace

TEST_CASE("sample picture: the bridge, one span fallen, with contact forces") {
  Scene scene = collapse()[2];
  const Scene before = bridge();
  for (const SceneBody& b : before.bodies)
    if (b.name == "span 3") scene.ghosts.push_back(b.outline);
  scene.ghost_label = "span 3 at rest";
  double x = 0;
  for (int i = 0; i < 6; ++i) {
    x += spans[i];
    scene.forces.push_back({Vec2(x - 6, -heights[i]) * ft, Vec2(3e4 * (i - 2), 1.4e6 + 2e5 * (i % 3))});
    scene.forces.push_back({Vec2(x + 6, -heights[i]) * ft, Vec2(-2e4 * (i - 2), 1.1e6 + 1e5 * (i % 2))});
  }
  scene.forces.push_back({body(scene, "span 3").outline[0], Vec2(7e5, 4.1e6)});
  show({scene}, 1, {}, "bridge");
  PictureStyle us;
  us.units = UnitSystem("kip ft");
  show({scene}, 1, us, "bridge_us");
  us.view = WorldBox{60 * ft, -70 * ft, 200 * ft, 15 * ft};
  show({scene}, 1, us, "bridge_near");
}

TEST_CASE("sample picture: four configurations of a collapse") {
  PictureStyle style;
  style.units = UnitSystem("kip ft");
  show(collapse(), 1, style, "collapse_column");
  show(collapse(), 2, style, "collapse_square");
}

TEST_CASE("sample picture: a masonry stack with contact forces") {
  Scene scene;
  scene.title = "Stack of five blocks";
  scene.time = 2.34;
  scene.stage = "shaking";
  scene.event = "block 4 slides";
  scene.bodies.push_back({"base", rectangle(-1.2, -0.4, 1.2, 0), BodyRole::fixed_ground});
  const double shift[] = {0, 0.01, 0.03, 0.16, 0.2}, width[] = {1, 0.9, 0.8, 0.7, 0.6};
  for (int i = 0; i < 5; ++i) {
    const double x0 = shift[i] - width[i] / 2, x1 = shift[i] + width[i] / 2, y = 0.4 * i, weight = 4e3 * (5 - i);
    scene.bodies.push_back({fmt::format("block {}", i + 1), rectangle(x0, y, x1, y + 0.4), BodyRole::free, "block"});
    const double lean = 0.2 + 0.1 * i;
    scene.forces.push_back({{x0 + 0.08, y}, {0.2 * weight, (0.5 - lean) * weight}});
    scene.forces.push_back({{x1 - 0.08, y}, {0.2 * weight, (0.5 + lean) * weight}});
  }
  show({scene}, 1, {}, "stack");
}

TEST_CASE("sample picture: a wall of 444 bricks coloured by speed, forces as bars") {
  Scene scene;
  scene.title = "Running-bond wall, 444 bricks";
  scene.time = 1.25;
  scene.stage = "shaking";
  scene.value_label = "speed";
  scene.value_unit = "m/s";
  scene.bodies.push_back({"", rectangle(-0.5, -0.3, 8.5, 0), BodyRole::moved_ground});
  std::mt19937 random(3);
  for (int row = 0, count = 0; count < 444; ++row)
    for (int column = 0; column < (row % 2 == 0 ? 20 : 21) && count < 444; ++column, ++count) {
      const double y = 0.2 * row, middle = 0.4 * column + (row % 2 == 0 ? 0.2 : 0);
      const double x0 = std::max(middle - 0.2, 0.0), x1 = std::min(middle + 0.2, 8.0);
      const double speed = 0.004 * y * y * (1 + 0.1 * static_cast<double>(random() % 10));
      scene.bodies.push_back({"", moved(rectangle(x0, y, x1, y + 0.2), {x0, y}, 0.4 * speed * 100, {8 * speed, 0}),
                              BodyRole::free, "", speed});
      const double weight = 1800 * (22 - row);
      for (const double x : {x0 + 0.05, x1 - 0.05})
        scene.forces.push_back(
            {{x + 8 * speed, y}, {0.15 * weight * std::sin(x), weight * (1 + 0.3 * std::sin(9 * x + y))}});
    }
  show({scene}, 1, {}, "wall");
  for (SceneBody& b : scene.bodies)
    if (b.value) *b.value -= 0.05;
  scene.forces.clear();
  show({scene}, 1, {}, "wall_signed");
}

TEST_CASE("sample picture: a slender tower next to its first place") {
  Scene scene;
  scene.title = "Column of eight drums rocking on a wide base, the tallest of the series";
  scene.time = 7.7;
  scene.bodies.push_back({"", rectangle(-200, -100, 200, 0), BodyRole::fixed_ground});
  for (int i = 0; i < 8; ++i) {
    const std::vector<Vec2> drum = rectangle(-0.5, 1.2 * i, 0.5, 1.2 * i + 1.2);
    scene.ghosts.push_back(drum);
    scene.bodies.push_back({"", moved(drum, {0.5, 0}, -7, {0.02 * i, 0}), BodyRole::free, "drum"});
  }
  show({scene}, 1, {}, "tower");
}
