#include "build/plane/running_bond.hpp"

#include <doctest/doctest.h>

#include <utility>

#include "build/sound_parts.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Pairs of axis-parallel rectangles that share a part of a face (coordinates equal to the bit, positive length).
int touching_pairs(const std::vector<Part>& parts) {
  int pairs = 0;
  std::vector<Box2> boxes;
  for (const Part& part : parts) boxes.push_back(bounding_box(part.outline));
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      const Vec2 shared = boxes[i].high.cwiseMin(boxes[j].high) - boxes[i].low.cwiseMax(boxes[j].low);
      if ((shared.x() == 0 && shared.y() > 0) || (shared.y() == 0 && shared.x() > 0)) ++pairs;
    }
  return pairs;
}

std::string course_pattern(const std::vector<Part>& parts, int course, double width) {
  std::string pattern;
  for (const Part& part : parts)
    if (std::count(part.groups.begin(), part.groups.end(), "course " + std::to_string(course))) {
      const Box2 box = bounding_box(part.outline);
      pattern += box.high.x() - box.low.x() > 0.75 * width ? '1' : 'h';
    }
  return pattern;
}

}  // namespace

TEST_CASE("panel W1 has odd courses h1111h, even ones 11111 and 33 blocks, panel W2 has 55") {
  const RunningBond w1{
      .columns = 5, .courses = 6, .unit_height = 0.175, .half_courses = HalfCourses::odd, .base_height = 0.3};
  const std::vector<Part> parts = build_running_bond(w1);
  check_sound(parts);
  check_one_grid(parts, 1e-6);
  CHECK(count_in_group(parts, "units") == 33);
  CHECK(course_pattern(parts, 1, 0.4) == "h1111h");
  CHECK(course_pattern(parts, 2, 0.4) == "11111");
  CHECK(near(total_area(parts), 2.0 * (6 * 0.175 + 0.3), 1e-14));
  CHECK(count_in_group(build_running_bond({.courses = 10, .unit_height = 0.175, .half_courses = HalfCourses::odd}),
                       "units") == 55);
}

TEST_CASE("panels W3 and W4 begin with a full course and have 55 and 42 blocks") {
  const std::vector<Part> w3 = build_running_bond({.name = "wall", .columns = 5, .courses = 10});
  CHECK(w3.size() == 55);
  CHECK(course_pattern(w3, 1, 0.4) == "11111");
  CHECK(course_pattern(w3, 10, 0.4) == "h1111h");
  CHECK(w3[0].name == "wall.c1.u1");
  CHECK(named(w3, "wall.c2.u6").groups == std::vector<std::string>{"units", "course 2"});
  CHECK(build_running_bond({.columns = 3, .courses = 12}).size() == 42);
}

TEST_CASE("panel W5 with its opening and lintel has 57 blocks, cut at the opening's edges") {
  const RunningBond w5{.columns = 6,
                       .courses = 10,
                       .at = {0.1, 0.7},
                       .base_height = 0.4,
                       .base_margin = 0.2,
                       .openings = {{.from = 0.8, .to = 1.6, .first_course = 4, .last_course = 7}},
                       .lintels = {{.from = 0.6, .to = 1.8, .first_course = 8, .last_course = 8}}};
  const std::vector<Part> parts = build_running_bond(w5);
  check_sound(parts);
  check_one_grid(parts, 1e-6);
  CHECK(parts.size() == 58);
  CHECK(count_in_group(parts, "units") + count_in_group(parts, "lintels") == 57);
  CHECK(course_pattern(parts, 4, 0.4) == "h1hh1h");
  CHECK(course_pattern(parts, 5, 0.4) == "1111");
  CHECK(course_pattern(parts, 8, 0.4) == "h11h1");  // the lintel counts as 1 and is last
  CHECK(near(total_area(parts), 2.4 * 2.0 - 0.8 * 0.8 + 2.8 * 0.4, 1e-14));
  const Box2 lintel = bounding_box(named(parts, "lintel1").outline);
  CHECK(lintel.low.isApprox(Vec2(0.7, 2.1), 1e-15));
  CHECK(lintel.high.isApprox(Vec2(1.9, 2.3), 1e-15));
  CHECK(bounding_box(named(parts, "base").outline).high.y() == named(parts, "c1.u1").outline[0].y());
}

TEST_CASE("the walls for measuring have 444 and 1752 units and 1266 and 5124 pairs in touch, the base's among them") {
  for (const auto& [courses, units, pairs] : {std::tuple(24, 444, 1266), std::tuple(48, 1752, 5124)}) {
    const std::vector<Part> wall = build_bench_wall(courses);
    CHECK(static_cast<int>(wall.size()) == units + 1);
    CHECK(count_in_group(wall, "units") == units);
    CHECK(touching_pairs(wall) == pairs);
  }
  check_sound(build_bench_wall(24));
  check_one_grid(build_bench_wall(24), 1e-6);
  CHECK(build_bench_wall(1).size() == 2);
}

TEST_CASE("panels that cannot be built are rejected, fields off the grid with the nearest lines") {
  const auto with_opening = [](PanelField field) {
    return refusal_of([=] { build_running_bond({.name = "w", .columns = 6, .courses = 10, .openings = {field}}); });
  };
  CHECK(with_opening({0.8, 1.6, 4, 7}) == "accepted");
  CHECK(mentions(with_opening({0.85, 1.6, 4, 7}),
                 "running bond 'w', opening 1: left edge is 0.85 m, must be a multiple of half a unit: 0.8 or 1 m"));
  CHECK(mentions(with_opening({0.8, 2.6, 4, 7}), "right edge is 2.6 m, must lie within the panel's 0 to 2.4 m"));
  CHECK(mentions(with_opening({1.6, 0.8, 4, 7}), "right edge 0.8 m must lie right of left edge 1.6 m"));
  CHECK(mentions(with_opening({0.8, 1.6, 0, 7}), "first course is 0"));
  CHECK(mentions(with_opening({0.8, 1.6, 4, 11}), "last course is 11, must be a whole number from 4 to 10"));
  CHECK(mentions(refusal_of([] {
                   build_running_bond(
                       {.columns = 6, .courses = 10, .openings = {{0.8, 1.6, 4, 7}}, .lintels = {{0.6, 1.8, 7, 7}}});
                 }),
                 "lintel 1: overlaps an earlier opening or lintel"));
  CHECK(mentions(refusal_of([] { build_running_bond({.columns = 0}); }), "columns is 0"));
  CHECK(
      mentions(refusal_of([] { build_running_bond({.columns = 2000, .courses = 2000}); }), "more than 1000000 units"));
  CHECK(mentions(refusal_of([] { build_running_bond({.unit_width = 0}); }), "unit width is 0 m"));
  CHECK(mentions(refusal_of([] { build_running_bond({.base_height = -1}); }), "base height is -1 m"));
  CHECK(mentions(refusal_of([] { build_bench_wall(0); }), "bench wall: number of courses is 0"));
}
