#include "build/space/check_solids.hpp"

#include <doctest/doctest.h>

#include <array>
#include <chrono>
#include <numbers>

#include "build/sound_parts.hpp"
#include "build/sound_solids.hpp"
#include "build/space/building.hpp"
#include "build/space/dome.hpp"
#include "build/space/drum.hpp"
#include "build/space/solid_block.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

SolidPart brick(const char* name, const Vec3& at, const Vec3& size = {1, 1, 1}) {
  return build_box({.name = name, .size = size, .at = at});
}

SolidFinding only(const std::vector<SolidFinding>& found) {
  REQUIRE(found.size() == 1);
  return found[0];
}

}  // namespace

TEST_CASE("models of the builders pass all checks") {
  std::vector<SolidPart> dome = build_dome({.rings = 6, .sectors = 20});
  CHECK(check_solids(dome).empty());
  std::vector<SolidPart> column =
      build_column({.drums = 6, .height = 5, .sides = 40, .radius = 0.5, .top_radius = 0.4});
  CHECK(check_solids(column).empty());
}

TEST_CASE("inverted solids are reversed, or reported if repair is off") {
  std::vector<SolidPart> parts{brick("a", {0, 0, 0}), brick("b", {1, 0, 0})};
  FaceLoops reversed;
  const FaceLoops right = parts[1].pieces[0].faces;
  for (int f = 0; f < 6; ++f) reversed.add(std::vector<int>(right[f].rbegin(), right[f].rend()));
  parts[1].pieces[0].faces = reversed;
  const SolidFinding told = check_solids(parts, {.repair = false, .touching = false}).at(0);
  CHECK(told.fault == SolidFault::inverted);
  CHECK_FALSE(told.repaired);
  CHECK(volume_of(parts[1]) < 0);
  const SolidFinding turned = only(check_solids(parts));
  CHECK(turned.repaired);
  CHECK(turned.text == "solid 'b' is inside out; they were reversed");
  CHECK(near(volume_of(parts[1]), 1, 1e-15));
  CHECK(check_solids(parts).empty());
}

TEST_CASE("open, hollow, degenerate and thin solids are reported") {
  std::vector<SolidPart> parts{brick("open", {0, 0, 0}), brick("flat", {1, 0, 0}),
                               brick("thin", {2, 0, 0}, {1, 1, 1e-4}), brick("ell", {3, 0, 0}),
                               brick("nan", {4, 0, 0})};
  parts[0].pieces[0].faces.corner.resize(20), parts[0].pieces[0].faces.start.pop_back();
  for (Vec3& p : parts[1].pieces[0].corners) p.z() = 0;
  parts[3].pieces = {
      extrusion(std::vector<Vec3>{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}, {0, 0, 1})};
  parts[4].pieces[0].corners[2].x() = NAN;
  const std::vector<SolidFinding> found = check_solids(parts, {.touching = false});
  REQUIRE(found.size() == 5);
  CHECK(found[0].fault == SolidFault::open);
  CHECK(found[0].value == 4);
  CHECK(found[1].fault == SolidFault::degenerate);
  CHECK(found[2].fault == SolidFault::sliver);
  CHECK(near(found[2].value, 1e-4, 1e-3));
  CHECK(found[3].fault == SolidFault::hollow);
  CHECK(near(found[3].value, 1, 1e-12));
  CHECK(found[4].text == "solid 'nan' has a corner that is not finite or beyond 1e12 m");
}

TEST_CASE("overlaps are reported with their volume, and touching faces, edges and corners are not overlaps") {
  std::vector<SolidPart> parts{brick("a", {0, 0, 0}), brick("b", {1, 0, 0}), brick("c", {0, 1, 1}),
                               brick("d", {1, 1, 2})};
  CHECK(check_solids(parts).empty());
  parts.push_back(brick("e", {0.5, 0.25, -0.9}));
  const std::vector<SolidFinding> found = check_solids(parts);
  REQUIRE(found.size() == 2);
  CHECK(found[0].fault == SolidFault::overlapping);
  CHECK(near(found[0].value, 0.5 * 0.75 * 0.1, 1e-12));
  CHECK(found[0].part == 4);
  CHECK(found[0].other == 0);
  CHECK(found[1].other == 1);
  CHECK(mentions(found[0].text, "solid 'e' shares 0.0375 m3, 0.0375 of the smaller, with solid 'a'"));
}

TEST_CASE("a part without contact is reported, one at the edge of the search distance is not") {
  std::vector<SolidPart> parts{brick("a", {0, 0, 0}), brick("b", {0, 0, 1 + 1e-7}), brick("c", {0, 0, 3})};
  const SolidFinding found = only(check_solids(parts));
  CHECK(found.text == "solid 'c' touches nothing");
  // bounding boxes overlap, solids do not: a brick rotated by 45 degrees next to the corner of another
  std::vector<SolidPart> turned{brick("a", {0, 0, 0}), build_box({.name = "t",
                                                                  .size = {1, 1, 1},
                                                                  .at = {1.5, 1.5, 0.5},
                                                                  .anchor = BoxAnchor::centre,
                                                                  .turn = {.angle = std::numbers::pi / 4}})};
  CHECK(check_solids(turned).size() == 2);
  CHECK(std::string(name_of(check_solids(turned)[0].fault)) == "touching nothing");
}

TEST_CASE("pieces of one part are checked too") {
  std::vector<SolidPart> parts{brick("a", {0, 0, 0})};
  parts[0].pieces.push_back(box_solid({0.5, 0, 0}, {1.5, 1, 1}));
  const SolidFinding found = only(check_solids(parts));
  CHECK(found.fault == SolidFault::overlapping);
  CHECK(mentions(found.text, "solid 'a', piece 2 shares 0.5 m3"));
}

TEST_CASE("100,000 faces are checked within seconds") {
  Building building{.walls = {{.start = {0, 0}, .end = {40, 0}},
                              {.start = {0, 0}, .end = {0, 30}},
                              {.start = {40, 0}, .end = {40, 30}},
                              {.start = {0, 30}, .end = {40, 30}}},
                    .storeys = {{.courses = 52}}};
  std::vector<SolidPart> parts = build_building(building).parts;
  CHECK(parts.size() * 6 > 100000);
  const auto before = std::chrono::steady_clock::now();
  CHECK(check_solids(parts).empty());
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  MESSAGE("checked ", parts.size(), " bricks in ", seconds, " s");
}

TEST_CASE("one solid of a hundred thousand faces is checked too") {
  SolidPart ball{"ball", {{}}, {}};
  Polyhedron& solid = ball.pieces[0];
  const int rings = 224, sectors = 224;
  for (int k = 1; k < rings; ++k)
    for (int j = 0; j < sectors; ++j) {
      const double t = std::numbers::pi * k / rings, p = 2 * std::numbers::pi * j / sectors;
      solid.corners.emplace_back(std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t));
    }
  solid.corners.emplace_back(0, 0, 1), solid.corners.emplace_back(0, 0, -1);
  const int top = (rings - 1) * sectors, bottom = top + 1;
  for (int k = 0; k + 2 < rings; ++k)
    for (int j = 0; j < sectors; ++j) {
      const int a = k * sectors + j, b = k * sectors + (j + 1) % sectors;
      solid.faces.add(std::array{a, a + sectors, b + sectors});
      solid.faces.add(std::array{a, b + sectors, b});
    }
  for (int j = 0; j < sectors; ++j) {
    solid.faces.add(std::array{top, j, (j + 1) % sectors});
    solid.faces.add(std::array{bottom, top - sectors + (j + 1) % sectors, top - sectors + j});
  }
  CHECK(solid.faces.count() > 99000);
  std::vector<SolidPart> parts{ball, ball};
  parts[1].name = "other";
  for (Vec3& p : parts[1].pieces[0].corners) p.z() += 1.5;
  const SolidFinding found = only(check_solids(parts));
  CHECK(found.fault == SolidFault::unchecked);
}
