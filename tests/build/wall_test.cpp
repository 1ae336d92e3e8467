#include "build/plane/wall.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <random>

#include "base/units.hpp"
#include "build/plain_wall.hpp"
#include "build/plane/bond_pattern.hpp"
#include "build/sound_parts.hpp"
#include "geometry/plane/random_convex.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double foot = 0.3048, inch = 0.0254;

/// The wall of the paper with the figures of VALIDATION 2.2.
Wall paper_wall() {
  Wall wall;
  wall.name = "wall", wall.length = 16 * foot;
  wall.unit_length = 16 * inch, wall.unit_height = 8 * inch;
  wall.slab_height = 8 * inch, wall.base_height = 2 * foot;
  wall.storeys.assign(3, {.height = 8 * foot});
  wall.lintel_height = 8 * inch, wall.lintel_bearing = 8 * inch;
  const double sill = 2 * foot + 8 * inch, side = 4 * foot;
  wall.openings = {{.storey = 1, .x = 2 * foot + 8 * inch, .width = side, .height = 6 * foot + 8 * inch},
                   {.storey = 1, .x = 9 * foot + 4 * inch, .sill = sill, .width = side, .height = side}};
  for (const int storey : {2, 3})
    for (const double x : {2 * foot + 8 * inch, 10 * foot + 8 * inch})
      wall.openings.push_back({.storey = storey, .x = x, .sill = sill, .width = side, .height = side});
  return wall;
}

/// Lengths of the units of a course from left to right, in quarters of a stretcher of 0.4 m.
std::string quarters(const std::vector<Part>& parts, const std::string& course) {
  std::string text;
  for (const Part& part : parts)
    if (part.name.find(fmt::format("{}.u", course)) != std::string::npos) {
      const Box2 box = bounding_box(part.outline);
      const double size = (box.high.x() - box.low.x()) / 0.1;
      CHECK(near(size, std::round(size), 1e-9));
      text += fmt::format("{}", std::lround(size));
    }
  return text;
}

}  // namespace

TEST_CASE("the wall of the paper has 293 units, 6 lintels, 3 slabs and a base, on one grid") {
  const std::vector<Part> parts = build_wall(paper_wall()).parts;
  check_sound(parts);
  check_one_grid(parts, 1e-7);
  CHECK(parts.size() == 303);
  CHECK(count_in_group(parts, "units") == 293);
  CHECK(count_in_group(parts, "lintels") == 6);
  CHECK(count_in_group(parts, "slabs") == 3);
  CHECK(count_in_group(parts, "base") == 1);
  CHECK(count_in_group(parts, "wall") == 303);
  for (const Part& part : parts) {
    const Box2 box = bounding_box(part.outline);
    const double width = (box.high.x() - box.low.x()) / inch, height = (box.high.y() - box.low.y()) / inch;
    const bool unit = part.groups[0] == "units";
    if (unit) CHECK((std::abs(width - 16) < 1e-9 || std::abs(width - 8) < 1e-9));
    if (part.groups[0] == "lintels") CHECK(near(width, 64, 1e-12));
    if (part.groups[0] != "base") CHECK(near(height, 8, 1e-12));
  }
}

TEST_CASE("the wall of the paper has the weight of its outline less its openings: 19.6 kip of masonry") {
  const std::vector<Part> parts = build_wall(paper_wall()).parts;
  double masonry = 0, slabs = 0;
  for (const Part& part : parts) {
    if (part.groups[0] == "units" || part.groups[0] == "lintels") masonry += signed_area(part.outline);
    if (part.groups[0] == "slabs") slabs += signed_area(part.outline);
  }
  const double square_feet = 16 * 3 * 88. / 12 - 4 * (6 + 8. / 12) - 5 * 4 * 4;
  CHECK(near(masonry, square_feet * foot * foot, 1e-13));
  CHECK(near(slabs, 3 * 16 * 8. / 12 * foot * foot, 1e-13));
  // 120 pcf, 8 in thick: 80 lbf for a square foot of wall
  CHECK(near(square_feet * 80, 19626.667, 1e-6));
}

TEST_CASE("the paper's wall leaves its openings empty and stands 24 ft high") {
  const std::vector<Part> parts = build_wall(paper_wall()).parts;
  const auto covered = [&](double x_inch, double y_inch) {
    return std::any_of(parts.begin(), parts.end(), [&](const Part& part) {
      const Box2 box = bounding_box(part.outline);
      const Vec2 p(x_inch * inch, y_inch * inch);
      return (p.array() > box.low.array()).all() && (p.array() < box.high.array()).all();
    });
  };
  struct Hole {
    double x0, y0, x1, y1;
  };
  for (const Hole& hole : {Hole{32, 0, 80, 80}, Hole{112, 32, 160, 80}, Hole{32, 128, 80, 176},
                           Hole{128, 128, 176, 176}, Hole{32, 224, 80, 272}, Hole{128, 224, 176, 272}}) {
    CAPTURE(hole.x0);
    const double x = (hole.x0 + hole.x1) / 2 + 1, y = (hole.y0 + hole.y1) / 2 + 1;  // on no joint
    for (const auto& [px, py] : {std::pair(x, y), std::pair(hole.x0 + 0.1, y), std::pair(hole.x1 - 0.1, y),
                                 std::pair(x, hole.y0 + 0.1), std::pair(x, hole.y1 - 0.1)})
      CHECK_FALSE(covered(px, py));
    for (const auto& [px, py] : {std::pair(hole.x0 - 0.1, y), std::pair(hole.x1 + 0.1, y), std::pair(x, hole.y0 - 0.1),
                                 std::pair(x, hole.y1 + 0.1)})
      CHECK(covered(px, py));
  }
  CHECK(near(bounding_box(named(parts, "wall.s3.slab").outline).high.y(), 24 * foot, 1e-14));
}

TEST_CASE("units are grouped by storey, course, pier and spandrel") {
  const std::vector<Part> parts = build_wall(paper_wall()).parts;
  using Groups = std::vector<std::string>;
  CHECK(named(parts, "wall.s1.c1.u1").groups == Groups{"units", "storey 1", "course 1", "piers", "pier 1", "wall"});
  CHECK(named(parts, "wall.s1.c11.u1").groups == Groups{"units", "storey 1", "course 11", "piers", "pier 1", "wall"});
  CHECK(named(parts, "wall.s1.lintel2").groups ==
        Groups{"lintels", "storey 1", "course 11", "spandrels", "spandrel 2", "wall"});
  CHECK(named(parts, "wall.s2.slab").groups == Groups{"slabs", "storey 2", "wall"});
  // below the first window of storey 2, x = 32 to 80 in
  CHECK(named(parts, "wall.s2.c1.u3").groups ==
        Groups{"units", "storey 2", "course 1", "spandrels", "spandrel 1", "wall"});
  for (int course = 5; course <= 10; ++course)
    for (const Part& part : parts)
      if (part.name.find(fmt::format("wall.s3.c{}.", course)) == 0)
        CHECK(std::count(part.groups.begin(), part.groups.end(), "piers") == 1);
  CHECK(count_in_group(build_wall(plain_wall()).parts, "piers") == 0);
}

TEST_CASE("each bond lays its courses as handbooks draw them") {
  const auto course = [](const std::string& bond, int number, double length) {
    Wall wall = plain_wall(bond);
    wall.length = length;
    return quarters(build_wall(wall).parts, fmt::format("c{}", number));
  };
  CHECK(course("running", 1, 2.4) == "444444");
  CHECK(course("running", 2, 2.4) == "2444442");
  CHECK(course("running", 3, 2.4) == "444444");
  CHECK(course("running", 1, 2.2) == "444442");
  CHECK(course("running", 2, 2.2) == "244444");
  CHECK(course("stack", 1, 2.4) == "444444");
  CHECK(course("stack", 2, 2.4) == "444444");
  CHECK(course("english", 1, 2.4) == "444444");
  CHECK(course("english", 2, 2.4) ==
        "21222222222"
        "12");
  CHECK(course("flemish", 1, 2.2) == "4242424");
  CHECK(course("flemish", 2, 2.2) == "214242412");
  CHECK(course("header", 1, 2.4) == "222222222222");
  CHECK(course("header", 2, 2.4) == "1222222222221");
  CHECK(course("english_garden", 3, 2.4) == "444444");
  CHECK(course("english_garden", 4, 2.4) == "2122222222212");
}

TEST_CASE("in every bond but stack bond no head joint stands over another") {
  for (const BondPattern& bond : bond_patterns()) {
    CAPTURE(bond.name);
    const BondUnits units{0.4, 0.2};
    const double length = bond.name == "flemish" ? 2.2 : 2.4;  // a whole number of pattern lengths
    int above = 0;
    for (int i = 0; i < bond.courses; ++i) {
      const auto row = static_cast<std::size_t>(i), next = static_cast<std::size_t>((i + 1) % bond.courses);
      for (const double joint : head_joints(bond.course[row], units, length))
        for (const double other : head_joints(bond.course[next], units, length))
          above += std::abs(joint - other) < 0.09;
    }
    CHECK((above == 0) == (bond.name != "stack"));
  }
}

TEST_CASE("a wall of any length and bond is filled without gap, overlap or a unit that is too short") {
  for (const BondPattern& bond : bond_patterns())
    for (const double length : {0.4, 0.43, 0.9, 1.37, 2.4, 3.0001, 7.13}) {
      CAPTURE(bond.name);
      CAPTURE(length);
      Wall wall = plain_wall(std::string(bond.name));
      wall.length = length;
      const std::vector<Part> parts = build_wall(wall).parts;
      check_sound(parts);
      CHECK(near(total_area(parts), length, 1e-13));
      for (const Part& part : parts) {
        const Box2 box = bounding_box(part.outline);
        CHECK(box.high.x() - box.low.x() > 0.1 - 1e-8);
      }
    }
}

TEST_CASE("joints add to the units, and a course may be given by its units") {
  Wall wall;
  wall.units = 12, wall.unit_length = 0.24, wall.head_joint = 0.01, wall.unit_height = 0.115, wall.bed_joint = 0.01;
  wall.storeys = {{.height = 2.7, .slab_height = 0.2}, {.courses = 4}};
  const std::vector<Part> parts = build_wall(wall).parts;
  check_sound(parts);
  CHECK(bounding_box(named(parts, "s1.slab").outline).high.isApprox(Vec2(3, 2.7), 1e-14));
  CHECK(bounding_box(named(parts, "s2.c3.u1").outline).high.isApprox(Vec2(0.25, 3.075), 1e-14));
  CHECK(count_in_group(parts, "storey 2") == 4 * 12 + 2);
}

TEST_CASE("short pieces are merged with the shorter neighbour, and a note counts them") {
  Wall wall = plain_wall();
  wall.openings = {{.x = 0.85, .sill = 0.2, .width = 0.8, .height = 0.6}};
  const BuiltParts made = build_wall(wall);
  check_sound(made.parts);
  // course 2: joints at 0.2, 0.6 | opening 0.85 to 1.65 | 1.8, 2.2; course 3: 0.4, 0.8 | 2.0
  REQUIRE(made.notes.size() == 1);
  CHECK(made.notes[0] == "wall: pieces shorter than 0.1 m were merged with a neighbour, 1 in all");
  CHECK(near(bounding_box(named(made.parts, "s1.c3.u2").outline).high.x(), 0.85, 1e-12));
  CHECK(near(bounding_box(named(made.parts, "s1.c3.u2").outline).low.x(), 0.4, 1e-12));
  wall.name = std::string("w"), wall.short_pieces = ShortPieces::refuse;
  CHECK(mentions(
      refusal_of_wall(wall),
      "wall 'w', storey 1, course 3: cutting leaves a piece of 0.05 m from x = 0.8 to 0.85 m, less than the least "
      "length of a unit, 0.1 m; move the opening, give a smaller least_length, or let short pieces be merged"));
}

TEST_CASE("jitter moves head joints alone, by at most its size, the same for the same seed") {
  Wall wall = paper_wall();
  const std::vector<Part> straight = build_wall(wall).parts;
  wall.jitter = 1e-6;
  const std::vector<Part> moved = build_wall(wall).parts, again = build_wall(wall).parts;
  wall.seed = 2;
  const std::vector<Part> other = build_wall(wall).parts;
  check_sound(moved);
  REQUIRE(moved.size() == straight.size());
  CHECK(near(total_area(moved), total_area(straight), 1e-14));
  double most = 0, differs = 0;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    CHECK(moved[i].outline == again[i].outline);
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec2 step = moved[i].outline[k] - straight[i].outline[k];
      CHECK(step.y() == 0);
      if (straight[i].groups[0] != "units") CHECK(step.x() == 0);
      most = std::max(most, std::abs(step.x()));
      differs = std::max(differs, std::abs(moved[i].outline[k].x() - other[i].outline[k].x()));
    }
  }
  CHECK(most > 0.9e-6);
  CHECK(most < 1.001e-6);
  CHECK(differs > 0.9e-6);
}

TEST_CASE("a sill may be a block that reaches under the masonry next to the opening") {
  Wall wall = plain_wall();
  wall.openings = {{.x = 0.8, .sill = 0.4, .width = 0.8, .height = 0.4, .sill_height = 0.2, .sill_bearing = 0.1}};
  const std::vector<Part> parts = build_wall(wall).parts;
  check_sound(parts);
  const Part& sill = named(parts, "s1.sill1");
  CHECK(sill.groups == std::vector<std::string>{"sills", "storey 1", "course 2", "spandrels", "spandrel 1"});
  CHECK(bounding_box(sill.outline).low.isApprox(Vec2(0.7, 0.2), 1e-14));
  CHECK(bounding_box(sill.outline).high.isApprox(Vec2(1.7, 0.4), 1e-14));
  CHECK(near(total_area(parts), 2.4 - 0.32, 1e-13));
  wall.openings[0].sill_height = 0.6;
  CHECK(mentions(refusal_of_wall(wall), "sill block needs 3 courses under the sill, but 2 are left in the storey"));
  wall.openings[0].sill_height = 0.2, wall.openings[0].sill_bearing = 1;
  CHECK(mentions(refusal_of_wall(wall),
                 "sill block lies from x = -0.2 to 2.6 m, must lie within the wall's 0 to 2.4 m; a "
                 "bearing of up to 0.8 m fits"));
}

TEST_CASE("any description is built without gap and overlap, or rejected in one line") {
  std::mt19937_64 bits(11);
  int built = 0, refused = 0;
  const auto grid = [&](double step, int low, int high) {
    // mostly on the grid, sometimes off it
    const double off = random_count(bits, 0, 3) == 0 ? random_between(bits, -0.5, 0.5) : 0;
    return step * (random_count(bits, low, high) + off);
  };
  for (int i = 0; i < 600; ++i) {
    const auto bond = static_cast<std::size_t>(random_count(bits, 0, static_cast<int>(bond_patterns().size()) - 1));
    Wall wall;
    wall.bond = bond_patterns()[bond].name;
    wall.length = grid(0.4, 1, 9), wall.at = {random_between(bits, -5, 5), 1};
    wall.slab_height = random_count(bits, 0, 1) * 0.15, wall.snap = random_count(bits, 0, 1) == 1;
    wall.short_pieces = random_count(bits, 0, 3) == 0 ? ShortPieces::refuse : ShortPieces::merge;
    wall.jitter = random_count(bits, 0, 1) * 1e-4, wall.seed = i;
    for (int k = random_count(bits, 1, 2); k > 0; --k) wall.storeys.push_back({.courses = random_count(bits, 1, 7)});
    for (int k = random_count(bits, 0, 3); k > 0; --k)
      wall.openings.push_back({.storey = random_count(bits, 1, 2),
                               .x = grid(0.2, 0, 14),
                               .sill = grid(0.2, 0, 3),
                               .width = grid(0.2, 1, 5),
                               .height = grid(0.2, 1, 4),
                               .lintel = random_count(bits, 0, 2) > 0,
                               .sill_height = random_count(bits, 0, 1) * 0.2});
    CAPTURE(i);
    const std::string refusal = refusal_of_wall(wall);
    if (refusal != "accepted") {
      CHECK(mentions(refusal, "wall"));
      ++refused;
      continue;
    }
    ++built;
    const BuiltParts made = build_wall(wall);
    check_sound(made.parts);
    double area = 0;
    for (const WallStorey& storey : wall.storeys) area += wall.length * (storey.courses * 0.2 + wall.slab_height);
    for (const WallOpening& o : wall.openings) area -= o.width * o.height;
    if (!wall.snap) CHECK(near(total_area(made.parts), area, 1e-9));
  }
  CHECK(built > 100);
  CHECK(refused > 100);
}
