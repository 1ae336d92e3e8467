#include "build/space/building.hpp"

#include <doctest/doctest.h>

#include <array>
#include <set>

#include "build/block_list.hpp"
#include "build/sound_parts.hpp"
#include "build/sound_solids.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// The published rule for blocks l x l/2 x l/2: a facade of k blocks and walls of j and a half at right angles to it.
Building published(int k, int j, int sides) {
  const double l = 0.4, length = k * l, depth = j * l + l / 2, mid = l / 4;
  Building building{.walls = {{.name = "front", .start = {0, mid}, .end = {length, mid}}}, .storeys = {{.courses = 8}}};
  building.walls.push_back({.name = "left", .start = {mid, mid}, .end = {mid, depth}});
  if (sides == 2)
    building.walls.push_back({.name = "right", .start = {length - mid, mid}, .end = {length - mid, depth}});
  return building;
}

/// A house of four walls with a cross wall, two storeys, doors and windows.
Building house() {
  Building building{.name = "house",
                    .walls = {{.name = "south", .start = {0, 0}, .end = {6, 0}},
                              {.name = "north", .start = {6, 4}, .end = {0, 4}},
                              {.name = "west", .start = {0, 0}, .end = {0, 4}},
                              {.name = "east", .start = {6, 0}, .end = {6, 4}},
                              {.name = "middle", .start = {2.8, 0}, .end = {2.8, 4}}},
                    .storeys = {{.courses = 14}, {.height = 2.6}},
                    .masonry = {.slab_height = 0.2, .slab_overhang = 0.1, .base_height = 0.5, .base_margin = 0.3}};
  building.walls[0].openings = {
      {.storey = 1, .from = 1, .sill = 0, .width = 1, .height = 2},
      {.storey = 1, .from = 3.5, .sill = 0.8, .width = 1.2, .height = 1.2, .lintel_height = 0.4},
      {.storey = 2, .from = 1, .sill = 0.8, .width = 1, .height = 1.6}};
  building.walls[1].openings = {{.storey = 1, .from = 1, .sill = 0.8, .width = 1, .height = 1}};
  return building;
}

SolidWall wall_of(double length, int courses, std::string_view bond) {
  SolidWall wall;
  wall.name = "W", wall.length = length, wall.masonry.bond = bond;
  wall.storeys.push_back({.courses = courses});
  return wall;
}

/// The wall of the units at a position within a course.
std::string wall_at(const std::vector<SolidPart>& parts, const Vec3& at) {
  std::string found;
  for (const SolidPart& part : parts) {
    const std::vector<Vec3>& corners = part.pieces[0].corners;
    const auto [low, high] = std::pair(corners[0], corners[6]);
    if ((at.array() > low.array()).all() && (at.array() < high.array()).all()) {
      CHECK(found.empty());
      found = part.groups.at(3);
    }
  }
  return found;
}

}  // namespace

TEST_CASE("the facade and the corner of the published tests come out block by block") {
  check_same_blocks(build_building(published(5, 2, 2)).parts, block_list("facade_k5_j2_c8.json"), 1e-12);
  check_same_blocks(build_building(published(4, 3, 1)).parts, block_list("corner_k4_j3_c8.json"), 1e-12);
  // the direction and order of lines have no influence here
  Building turned = published(4, 3, 1);
  std::swap(turned.walls[0], turned.walls[1]);
  check_same_blocks(build_building(turned).parts, block_list("corner_k4_j3_c8.json"), 1e-12);
}

TEST_CASE("facades of any length follow the published rule") {
  for (const int k : {1, 3, 8})
    for (const int j : {1, 4})
      // two courses have k and k - 1 blocks in front, 2 j and 2 (j + 1) at the sides
      CHECK(build_building(published(k, j, 2)).parts.size() == static_cast<std::size_t>(4 * (2 * k - 1 + 4 * j + 2)));
}

TEST_CASE("walls take turns at corners and junctions from course to course") {
  const Building building = house();
  const std::vector<SolidPart> all = build_building(building).parts;
  std::vector<SolidPart> units;
  for (const SolidPart& part : all)
    if (part.groups[0] == "units") units.push_back(part);
  for (int c = 0; c < 14; ++c) {
    const double z = 0.2 * c + 0.1;
    const bool odd = c % 2 == 0;
    CHECK(wall_at(units, {0.03, 0.02, z}) == (odd ? "south" : "west"));
    CHECK(wall_at(units, {6.03, 4.02, z}) == (odd ? "north" : "east"));
    CHECK(wall_at(units, {2.81, 4.05, z}) == (odd ? "north" : "middle"));
    CHECK(wall_at(units, {2.79, -0.09, z}) == (odd ? "south" : "middle"));
  }
}

TEST_CASE("a house of two storeys has no overlap, flat joints and the volume of its walls") {
  const SolidParts made = build_building(house());
  check_sound(made.parts);
  const double x = 6.2, y = 4.2, t = 0.2, area = 2 * x * t + 3 * (y - 2 * t) * t;
  const double openings = 1 * 2 + 1.2 * 1.2 + 1 * 1.6 + 1;
  const double walls = area * (14 * 0.2 + 2.4) - openings * t;
  double laid = 0;
  for (const SolidPart& part : made.parts)
    if (part.groups[0] == "units" || part.groups[0] == "lintels") laid += volume_of(part);
  CHECK(near(laid, walls, 1e-12));
  CHECK(count_in_group(made.parts, "lintels") == 3);  // the floor covers the window of storey 2
  CHECK(count_in_group(made.parts, "floors") == 2);
  CHECK(count_in_group(made.parts, "house") == static_cast<int>(made.parts.size()));
  CHECK(near(volume_of(named(made.parts, "house.s1.floor")), (x + 0.2) * (y + 0.2) * 0.2, 1e-12));
  CHECK(near(volume_of(named(made.parts, "house.base")), (x + 0.6) * (y + 0.6) * 0.5, 1e-12));
  CHECK(near(volume_of(named(made.parts, "house.south.s1.lintel2")), 1.6 * 0.4 * 0.2, 1e-12));
}

TEST_CASE("a building may be turned, and its floors have any outline") {
  Building building = house();
  building.angle = 0.4, building.at = {3, 1, 0.5};
  building.slab_outline = {{-0.2, -0.2}, {6.2, -0.2}, {6.2, 4.2}, {3, 4.2}, {3, 3}, {-0.2, 3}};
  const SolidParts made = build_building(building);
  CHECK(near(total_volume(made.parts) - total_volume(build_building(house()).parts),
             2 * 0.2 * (6.4 * 4.4 - 3.2 * 1.2 - 6.4 * 4.4), 1e-9));
  CHECK(named(made.parts, "house.s2.floor").pieces.size() == 2);
}

TEST_CASE("a storey without a carrying slab is rejected, one on a partial slab gets a note") {
  Building building = house();
  building.slab_outline = {{0.1, 0.1}, {5.9, 0.1}, {5.9, 3.9}, {0.1, 3.9}};
  CHECK(mentions(
      refusal_of([&] { build_building(building); }),
      "wall 'south', storey 2: the slab below does not reach under it, so it hangs 0.2 m above the wall below; "
      "extend slab_outline under all walls, or leave it out"));
  building.slab_outline = {{0, 0}, {6, 0}, {6, 4}, {0, 4}};
  const std::vector<std::string> notes = build_building(building).notes;
  REQUIRE(notes.size() == building.walls.size());
  // 6.0 m of 6.2 m of its length, and half of its thickness
  CHECK(mentions(notes[0],
                 "wall 'south', storey 2: the slab below reaches under 48.4 % of its foot; the rest hangs 0.2 m"));
  building.storeys[0].slab_height = 0;  // it stands on the walls below
  building.slab_outline = {{0.1, 0.1}, {5.9, 0.1}, {5.9, 3.9}, {0.1, 3.9}};
  CHECK(build_building(building).notes.empty());
}

TEST_CASE("no head joint of a wall lies over another in any bond") {
  for (const LeafBond& bond : leaf_bonds()) {
    CAPTURE(bond.name);
    const double length = bond.name == "flemish" ? 0.6 * 5 + 0.4 : 3.2;
    const SolidWall wall = wall_of(length, 4, bond.name);
    const SolidParts made = build_solid_wall(wall);
    CHECK(made.notes.empty());
    const double thickness = bond.name == "stretcher" ? 0.2 : 0.4;
    CHECK(near(total_volume(made.parts), length * thickness * 0.8, 1e-12));
    check_sound(made.parts);
    std::array<std::set<long>, 4> joints;
    for (const SolidPart& part : made.parts) {
      const std::vector<Vec3>& corners = part.pieces[0].corners;
      const auto course = static_cast<std::size_t>(std::lround(corners[0].z() / 0.2));
      for (const double x : {corners[0].x(), corners[6].x()})
        if (x > 1e-9 && x < length - 1e-9) joints.at(course).insert(std::lround(x * 1e6));
    }
    for (std::size_t c = 0; c + 1 < 4; ++c) {
      CHECK(joints.at(c) == joints.at(c < 2 ? c + 2 : c - 2));
      for (const long below : joints.at(c))
        for (const long above : joints.at(c + 1)) CHECK(std::abs(below - above) >= 100000);
    }
    // a wall with equal ends is its own mirror image
    for (const auto& course : joints)
      for (const long at : course)
        if (bond.name != "stretcher") CHECK(course.count(std::lround(length * 1e6) - at) == 1);
  }
}

TEST_CASE("headers run through a wall, stretchers lie side by side") {
  const SolidParts english = build_solid_wall(wall_of(2, 2, "english"));
  CHECK(named(english.parts, "W.s1.c1.u1a").pieces[0].corners[6] == Vec3(0.4, 0.2, 0.2));
  CHECK(named(english.parts, "W.s1.c1.u1b").pieces[0].corners[6] == Vec3(0.4, 0.4, 0.2));
  CHECK(near(volume_of(named(english.parts, "W.s1.c2.u1")), 0.2 * 0.4 * 0.2, 1e-12));
  CHECK(near(volume_of(named(english.parts, "W.s1.c2.u2")), 0.1 * 0.4 * 0.2, 1e-12));
}

TEST_CASE("English bond turns a corner with stretchers that become headers and a closer behind them") {
  Building building{.walls = {{.name = "a", .start = {0, 0.2}, .end = {3.2, 0.2}},
                              {.name = "b", .start = {0.2, 0.2}, .end = {0.2, 2.4}}},
                    .storeys = {{.courses = 6}}};
  building.masonry.bond = "english";
  const SolidParts made = build_building(building);
  check_sound(made.parts);
  CHECK(near(total_volume(made.parts), 0.4 * (3.2 + 2.0) * 1.2, 1e-12));
  CHECK(near(volume_of(named(made.parts, "b.s1.c1.u1")), 0.1 * 0.4 * 0.2, 1e-12));
  CHECK(near(volume_of(named(made.parts, "b.s1.c1.u2")), 0.2 * 0.4 * 0.2, 1e-12));
}

TEST_CASE("openings cut units, short pieces join their neighbours with a note") {
  SolidWall wall = wall_of(4, 10, "stretcher");
  wall.openings = {{.from = 1.25, .sill = 0.4, .width = 1, .height = 1}};
  const SolidParts made = build_solid_wall(wall);
  REQUIRE(made.notes.size() == 1);
  CHECK(mentions(made.notes[0], "pieces shorter than 0.08 m were merged with a neighbour"));
  CHECK(near(total_volume(made.parts), 0.2 * (4 * 2 - 1), 1e-12));
  check_sound(made.parts);
  wall.openings[0].sill = 0.45, wall.masonry.snap = true;
  CHECK(build_solid_wall(wall).notes.size() == 3);
}

TEST_CASE("masonry next to an opening or a lintel that is shorter than the least length is rejected") {
  SolidWall wall = wall_of(4, 10, "stretcher");
  const auto refused = [&] { return refusal_of([&] { build_solid_wall(wall); }); };
  wall.openings = {{.from = 0.05, .sill = 0.4, .width = 1, .height = 1, .lintel = false}};
  CHECK(mentions(refused(),
                 "wall 'W', storey 1, course 3: the masonry from x = 0 to 0.05 m is 0.05 m long, less than the "
                 "least length of 0.08 m; move the opening, or give a smaller least_length"));
  wall.openings = {{.from = 1, .width = 1, .height = 1}, {.from = 2.43, .width = 1, .height = 1}};
  CHECK(mentions(refused(),
                 "course 6: the masonry from x = 2.2 to 2.23 m is 0.03 m long, less than the least length of 0.08 "
                 "m; move the opening, give its lintel another bearing, or give a smaller least_length"));
  wall.masonry.least_length = 0.03;
  CHECK_NOTHROW(build_solid_wall(wall));
  Building building = house();  // its corner is 0.2 m wide, its first joint 0.1 m beyond that
  building.walls[0].openings[2] = {.storey = 2, .from = 0.15, .sill = 0.8, .width = 1, .height = 1, .lintel = false};
  CHECK(mentions(refusal_of([&] { build_building(building); }),
                 "wall 'south', storey 2, course 6: the masonry from x = 0.1 to "
                 "0.15 m is 0.05 m long"));
}

TEST_CASE("impossible buildings are rejected") {
  const auto refused = [](auto change) {
    Building building = house();
    change(building);
    return refusal_of([&] { build_building(building); });
  };
  CHECK(mentions(refused([](Building& b) { b.walls.clear(); }), "building 'house': number of walls is 0"));
  CHECK(mentions(refused([](Building& b) { b.storeys.clear(); }), "number of storeys is 0"));
  CHECK(mentions(refused([](Building& b) {
                   b.walls[0].end = {6, 1};
                 }),
                 "wall 'south': runs from (0, 0) to (6, 1); walls of a plan run along"));
  CHECK(mentions(refused([](Building& b) { b.walls[0].end = b.walls[0].start; }), "its ends are the same point"));
  CHECK(mentions(refused([](Building& b) { b.walls[1].name = "south"; }), "there are two walls 'south'"));
  CHECK(mentions(refused([](Building& b) {
                   b.walls.push_back({.start = {1, 0.1}, .end = {2, 0.1}});
                 }),
                 "walls 'south' and 'w6' overlap along their length"));
  CHECK(mentions(refused([](Building& b) { b.walls[2].bond = "flemmish"; }),
                 "there is no bond 'flemmish'; did you mean 'flemish'"));
  CHECK(mentions(refused([](Building& b) { b.storeys[1].height = 2.5; }),
                 "storey 2: height is 2.5 m, which is 11.5 courses"));
  CHECK(mentions(refused([](Building& b) { b.walls[0].openings[0].sill = 0.05; }),
                 "opening 1: its sill is at 0.05 m, which is not a course line; the nearest is at 0 m"));
  CHECK(mentions(refused([](Building& b) { b.walls[0].openings[0].from = 2.2; }),
                 "opening 1 reaches from 2.2 to 3.2 m in x, into the wall across"));
  CHECK(mentions(refused([](Building& b) { b.walls[0].openings[1].from = 5.4; }), "outside of the wall"));
  CHECK(mentions(refused([](Building& b) { b.walls[0].openings.push_back(b.walls[0].openings[0]); }),
                 "opening 4 lies on another opening"));
  CHECK(mentions(refused([](Building& b) { b.walls[0].openings[0].storey = 3; }), "opening 1: storey is 3"));
  CHECK(mentions(refused([](Building& b) { b.masonry.least_length = 1; }), "least length is 1 m"));
  CHECK(mentions(refusal_of([] { build_solid_wall(wall_of(0, 1, "stretcher")); }), "wall 'W': length is 0 m"));
}
