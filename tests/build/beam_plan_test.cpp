#include <doctest/doctest.h>

#include <array>
#include <random>

#include "build/sound_parts.hpp"
#include "build/sound_solids.hpp"
#include "build/space/building.hpp"
#include "geometry/plane/random_convex.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// A house with walls of 0.4 m and a cross wall, all rooms 2.8 m deep: one of 2.4 m to the left and one of 2.8 m to the
/// right of it, 1.6 m high.
Building beamed_house(std::vector<BeamRow> beams) {
  Building building{.name = "B",
                    .walls = {{.name = "south", .start = {0, 0}, .end = {6, 0}},
                              {.name = "north", .start = {0, 3.2}, .end = {6, 3.2}},
                              {.name = "west", .start = {0, 0}, .end = {0, 3.2}},
                              {.name = "east", .start = {6, 0}, .end = {6, 3.2}},
                              {.name = "middle", .start = {2.8, 0}, .end = {2.8, 3.2}}},
                    .storeys = {{.courses = 8}},
                    .beams = std::move(beams)};
  for (PlanWall& wall : building.walls) wall.thickness = 0.4;
  return building;
}

constexpr double plan_area = 2 * 6.4 * 0.4 + 3 * 2.8 * 0.4;

std::pair<Vec3, Vec3> box_named(const SolidParts& made, const std::string& name) {
  const std::vector<Vec3>& corners = named(made.parts, name).pieces[0].corners;
  return {corners[0], corners[6]};
}

void check_box(const SolidParts& made, const std::string& name, const Vec3& low, const Vec3& high) {
  CAPTURE(name);
  const auto [from, to] = box_named(made, name);
  CHECK((from - low).norm() < 1e-12);
  CHECK((to - high).norm() < 1e-12);
}

double volume_in(const SolidParts& made, const std::string& group) {
  double volume = 0;
  for (const SolidPart& part : made.parts)
    if (std::count(part.groups.begin(), part.groups.end(), group) > 0) volume += volume_of(part);
  return volume;
}

std::string refusal_of_beams(std::vector<BeamRow> beams) {
  return refusal_of([&] { build_building(beamed_house(std::move(beams))); });
}

/// Four walls around a room of 3.2 m by 2.4 m between their centre lines, four courses high, with one row of beams.
Building room_at_random(std::mt19937_64& bits) {
  const auto pick = [&](int choices) { return static_cast<std::size_t>(random_count(bits, 0, choices - 1)); };
  const double t = std::array{0.2, 0.4, 0.5}.at(pick(3));
  Building building{.walls = {{.name = "a", .start = {0, 0}, .end = {3.2, 0}, .thickness = t},
                              {.name = "b", .start = {3.2, 2.4}, .end = {0, 2.4}, .thickness = t},
                              {.name = "c", .start = {0, 2.4}, .end = {0, 0}, .thickness = t},
                              {.name = "d", .start = {3.2, 0}, .end = {3.2, 2.4}, .thickness = t}},
                    .storeys = {{.courses = 4}}};
  building.masonry.bond = leaf_bonds()[pick(static_cast<int>(leaf_bonds().size()))].name;
  building.first_along_y = pick(2) == 1;
  BeamRow row{
      .along_y = pick(2) == 1, .width = random_between(bits, 0.05, 0.3), .height = 0.2 * static_cast<double>(pick(4))};
  if (pick(2) == 1) row.count = 1 + static_cast<int>(pick(6));
  if (row.count == 0 || pick(3) == 0) row.spacing = random_between(bits, 0.2, 1.2);
  if (pick(2) == 1) row.bearing = t * random_between(bits, 0.1, 1);
  building.beams = {row};
  return building;
}

}  // namespace

TEST_CASE("beams end in pockets of two walls and nothing overlaps: volumes add up") {
  const SolidParts made = build_building(beamed_house({{.along_y = true, .spacing = 1.3, .width = 0.2}}));
  // 5.6 m between west and east hold 4 beams of 1.3 m spacing; the middle wall is parallel to them, between two beams
  check_sound(made.parts);
  CHECK(count_in_group(made.parts, "beams") == 4);
  CHECK(count_in_group(made.parts, "floors") == 4);
  for (int i = 0; i < 4; ++i) {
    const double x = 3 + 1.3 * (i - 1.5);
    check_box(made, fmt::format("B.s1.beam{}", i + 1), {x - 0.1, -0.2, 1.4}, {x + 0.1, 3.4, 1.6});
  }
  CHECK(near(volume_in(made, "beams"), 4 * 0.2 * 0.2 * 3.6, 1e-12));
  CHECK(near(volume_in(made, "units"), plan_area * 1.6 - 4 * 2 * 0.2 * 0.2 * 0.4, 1e-12));
  CHECK(near(volume_in(made, "storey 1"), total_volume(made.parts), 1e-12));
  CHECK(volume_in(made, "B") == volume_in(made, "storey 1"));
}

TEST_CASE("beams pass through walls that stand between their end walls") {
  const SolidParts made = build_building(beamed_house({{.count = 4, .width = 0.2, .height = 0.4}}));
  check_sound(made.parts);
  // even spacing over 2.8 m: 0.7 m from centre to centre
  for (int i = 0; i < 4; ++i) {
    const double y = 1.6 + 0.7 * (i - 1.5);
    check_box(made, fmt::format("B.s1.beam{}", i + 1), {-0.2, y - 0.1, 1.2}, {6.2, y + 0.1, 1.6});
  }
  CHECK(near(volume_in(made, "units"), plan_area * 1.6 - 4 * 3 * 0.2 * 0.4 * 0.4, 1e-12));
}

TEST_CASE("count and spacing together place a row in the middle of its room") {
  const SolidParts made = build_building(beamed_house({{.count = 3, .spacing = 0.5, .width = 0.2}}));
  for (int i = 0; i < 3; ++i)
    CHECK(near(box_named(made, fmt::format("B.s1.beam{}", i + 1)).first.y(), 1.5 + 0.5 * (i - 1), 1e-12));
}

TEST_CASE("the wall behind the end of a beam is filled with one unit per course") {
  const SolidParts made = build_building(beamed_house({{.count = 1, .width = 0.2, .height = 0.4, .bearing = 0.25}}));
  check_sound(made.parts);
  check_box(made, "B.s1.beam1", {-0.05, 1.5, 1.2}, {6.05, 1.7, 1.6});
  CHECK(near(volume_in(made, "units"), plan_area * 1.6 - 0.2 * 0.4 * (2 * 0.25 + 0.4), 1e-12));
  int fillings = 0;
  for (const SolidPart& part : made.parts) {
    const std::vector<Vec3>& corners = part.pieces[0].corners;
    if (part.groups[0] != "units" || near(corners[6].x() - corners[0].x(), 0.4, 1e-9)) continue;
    if (!near(corners[6].y() - corners[0].y(), 0.2, 1e-9) || !near(corners[6].x() - corners[0].x(), 0.15, 1e-9))
      continue;
    ++fillings;
    CHECK(near(corners[6].z() - corners[0].z(), 0.2, 1e-9));
    CHECK(std::count(part.groups.begin(), part.groups.end(), corners[0].x() < 3 ? "west" : "east") == 1);
  }
  CHECK(fillings == 4);
}

TEST_CASE("rooms have separate beams, which share pockets of the wall between them") {
  const auto rooms = [](double left, double right) {
    return beamed_house({{.count = 3, .width = 0.2, .bearing = left, .to = Vec2(2.8, 3.2)},
                         {.count = 3, .width = 0.2, .bearing = right, .from = Vec2(2.8, 0)}});
  };
  const SolidParts meeting = build_building(rooms(0.2, 0.2));
  check_sound(meeting.parts);
  CHECK(count_in_group(meeting.parts, "beams") == 6);
  check_box(meeting, "B.s1.beam2", {0, 1.5, 1.4}, {2.8, 1.7, 1.6});
  check_box(meeting, "B.s1.beam5", {2.8, 1.5, 1.4}, {6, 1.7, 1.6});
  CHECK(near(volume_in(meeting, "units"), plan_area * 1.6 - 3 * 4 * 0.2 * 0.2 * 0.2, 1e-12));
  const SolidParts apart = build_building(rooms(0.15, 0.15));  // with 0.1 m of masonry between their ends
  check_sound(apart.parts);
  CHECK(near(volume_in(apart, "units"), plan_area * 1.6 - 3 * 4 * 0.2 * 0.2 * 0.15, 1e-12));
  CHECK(mentions(
      refusal_of([&] { build_building(rooms(0.3, 0.2)); }),
      "storey 1: beams, row 2: beam 4 from y = 0.566667 to 0.766667 m runs into beam 1; give each row its own part"));
  CHECK(mentions(refusal_of([&] { build_building(rooms(0.17, 0.17)); }),
                 "beam 4 from y = 0.566667 to 0.766667 m leaves"));
}

TEST_CASE("beams side by side make a floor from wall to wall") {
  const SolidParts made = build_building(beamed_house({{.count = 14, .width = 0.2}}));
  check_sound(made.parts);
  CHECK(near(volume_in(made, "beams"), 2.8 * 6.4 * 0.2, 1e-12));
  CHECK(near(volume_in(made, "units"), plan_area * 1.6 - 3 * 2.8 * 0.4 * 0.2, 1e-12));
}

TEST_CASE("storeys have their own beams or the beams of the building, with or without a slab") {
  Building building = beamed_house({{.count = 4, .width = 0.2}});
  building.storeys = {
      {.courses = 8, .slab_height = 0.1},
      {.courses = 6, .beams = std::vector<BeamRow>{{.along_y = true, .count = 4, .spacing = 1.3, .width = 0.1}}},
      {.courses = 4, .beams = std::vector<BeamRow>{}}};
  building.masonry.least_length = 0.06;
  const SolidParts made = build_building(building);
  check_sound(made.parts);
  CHECK(count_in_group(made.parts, "beams") == 8);
  check_box(made, "B.s1.floor", {-0.2, -0.2, 1.6}, {6.2, 3.4, 1.7});
  check_box(made, "B.s1.beam4", {-0.2, 2.55, 1.4}, {6.2, 2.75, 1.6});
  check_box(made, "B.s2.beam1", {1, -0.2, 2.7}, {1.1, 3.4, 2.9});
  CHECK(named(made.parts, "B.s2.beam1").groups == std::vector<std::string>{"beams", "floors", "storey 2", "B"});
  const double pockets = 4 * 3 * 0.2 * 0.2 * 0.4 + 4 * 2 * 0.1 * 0.2 * 0.4;
  CHECK(near(volume_in(made, "units"), plan_area * 18 * 0.2 - pockets, 1e-12));
}

TEST_CASE("beams of a plan with a wing end in the walls that their own lines meet") {
  Building wing{.walls = {{.name = "a", .start = {0, 0}, .end = {6, 0}},
                          {.name = "b", .start = {6, 0}, .end = {6, 2}},
                          {.name = "c", .start = {3, 2}, .end = {6, 2}},
                          {.name = "d", .start = {3, 2}, .end = {3, 4}},
                          {.name = "e", .start = {0, 4}, .end = {3, 4}},
                          {.name = "f", .start = {0, 0}, .end = {0, 4}}},
                .storeys = {{.courses = 3}},
                .beams = {{.count = 6, .width = 0.1}}};
  const SolidParts made = build_building(wing);
  check_sound(made.parts);
  CHECK(near(box_named(made, "s1.beam1").second.x(), 6.1, 1e-12));
  CHECK(near(box_named(made, "s1.beam6").second.x(), 3.1, 1e-12));
  wing.beams[0].count = 5;
  CHECK(
      mentions(refusal_of([&] { build_building(wing); }),
               "storey 1: beams: beam 3 from y = 1.95 to 2.05 m lies in wall 'c', which runs along it from y = 1.9 to "
               "2.1 m; move it by spacing or count"));
}

TEST_CASE("beams lie on lintels, and over openings alone they are rejected") {
  Building building = beamed_house({{.along_y = true, .count = 1, .width = 0.2, .to = Vec2(2.8, 3.2)}});
  building.walls[0].openings = {{.from = 0.8, .width = 1.2, .height = 1.2}};  // its lintel ends at 1.4 m
  check_sound(build_building(building).parts);
  MasonryOpening& opening = building.walls[0].openings[0];
  opening.height = 1.4, opening.lintel = false;
  CHECK(
      mentions(refusal_of([&] { build_building(building); }),
               "building 'B': storey 1: beams: beam 1 from x = 1.3 to 1.5 m lies over an opening of wall 'south', from "
               "0.8 to 2 m, without a lintel under it; give the opening a lintel"));
  opening.lintel = true;
  CHECK(mentions(refusal_of([&] { build_building(building); }),
                 "has its pocket on a lintel of wall 'south', from 0.6 to"));
  opening.height = 1.6;
  CHECK(mentions(
      refusal_of([&] { build_building(building); }),
      "has its pocket on an opening of wall 'south', from 0.8 to 2 m, which reaches into the top course of the "
      "storey"));
  building.beams[0].count = 2, building.beams[0].spacing = 1.8;  // next to the lintel
  check_sound(build_building(building).parts);
  // a storey as high as its beams stands on an opening of the storey below
  building.storeys = {{.courses = 8, .beams = std::vector<BeamRow>{}}, {.courses = 1}};
  building.beams = {{.along_y = true, .count = 1, .width = 0.2, .to = Vec2(2.8, 3.2)}};
  CHECK(
      mentions(refusal_of([&] { build_building(building); }),
               "storey 2: beams: beam 1 from x = 1.3 to 1.5 m lies over an opening of wall 'south', from 0.8 to 2 m in "
               "the storey below"));
  building.masonry.slab_height = 0.1;
  check_sound(build_building(building).parts);
}

TEST_CASE("rows of beams at random are sound or rejected with a line, in every bond") {
  std::mt19937_64 bits(7);
  int sound = 0;
  for (int i = 0; i < 120; ++i) {
    CAPTURE(i);
    Building building = room_at_random(bits);
    SolidParts made;
    const std::string refusal = refusal_of([&] { made = build_building(building); });
    if (refusal != "accepted") {
      CHECK(mentions(refusal, "storey 1: beams"));
      continue;
    }
    ++sound;
    check_sound(made.parts);
    const BeamRow& row = building.beams[0];
    const double t = building.walls[0].thickness, clear = (row.along_y ? 2.4 : 3.2) - t, walls = 2 * (3.2 + 2.4) * t;
    const SolidPart& beam = named(made.parts, "s1.beam1");
    const double section = row.width * (row.height > 0 ? row.height : 0.2), span = volume_of(beam) / section;
    CHECK(near(span, clear + 2 * row.bearing.value_or(t), 1e-9));
    const double in_walls = count_in_group(made.parts, "beams") * section * (span - clear);
    CHECK(near(volume_in(made, "units"), walls * 0.8 - in_walls, 1e-9));
  }
  CHECK(sound > 40);
}

TEST_CASE("beams that cannot lie are rejected") {
  CHECK(mentions(refusal_of_beams({{.count = 3}}), "building 'B': storey 1: beams: width is 0 m, must be"));
  CHECK(mentions(refusal_of_beams({{.width = 0.1}}), "give their spacing in m from centre to centre, or their count"));
  CHECK(mentions(refusal_of_beams({{.count = -1, .width = 0.1}}), "count is -1"));
  CHECK(mentions(refusal_of_beams({{.spacing = 0.1, .width = 0.2}}), "spacing is 0.1 m, must be at least the width"));
  CHECK(mentions(refusal_of_beams({{.spacing = 3, .width = 0.2}}),
                 "spacing is 3 m, more than the room from y = 0.2 to 3 m, 2.8 m; give a smaller spacing, or a count"));
  CHECK(mentions(refusal_of_beams({{.count = 15, .width = 0.2}}),
                 "15 beams of 0.2 m width need 3 m, but the room has 2.8 m, from"));
  CHECK(mentions(refusal_of_beams({{.count = 2, .width = 0.2, .height = 0.3}}),
                 "height is 0.3 m, must be a whole number of courses of 0.2 m; 0.2 or 0.4 m would fit"));
  CHECK(mentions(refusal_of_beams({{.count = 2, .width = 0.2, .height = 1.8}}),
                 "must be at most the height of the storey's"));
  CHECK(mentions(
      refusal_of_beams({{.count = 1, .width = 0.2, .bearing = 0.5}}),
      "beam 1 from y = 1.5 to 1.7 m has a bearing of 0.5 m, must be at most the thickness of wall 'west', 0.4"));
  CHECK(mentions(refusal_of_beams({{.count = 1, .width = 0.2, .bearing = 0}}), "bearing is 0 m"));
  CHECK(mentions(refusal_of_beams({{.count = 1, .width = 0.2, .bearing = 0.35}}),
                 "leaves 0.05 m of wall 'west' behind its end, less than the least length of a piece, 0.08 m"));
  CHECK(mentions(refusal_of_beams({{.count = 1, .width = 0.2, .from = Vec2(1, 1), .to = Vec2(1, 2)}}), "has no area"));
  CHECK(mentions(refusal_of_beams({{.count = 1, .width = 0.2, .from = Vec2(4, 0)}}),
                 "beam 1 from y = 1.5 to 1.7 m has no wall at its end towards -x: from x = 4 to 6.2 m there is only "
                 "'east'; each end of a beam needs a wall across it"));
  CHECK(mentions(refusal_of_beams({{.count = 1, .width = 0.2, .from = Vec2(1, 0), .to = Vec2(2, 3)}}),
                 "has no wall at its ends from x = 1 to 2 m"));
  CHECK(
      mentions(refusal_of_beams({{.along_y = true, .count = 15, .width = 0.1}}), "lies in wall 'middle', which runs"));
  CHECK(mentions(refusal_of_beams({{.count = 2, .width = 0.2}, {.along_y = true, .count = 2, .width = 0.2}}),
                 "row 2: beam 3 from x = 1.5 to 1.7 m runs into beam 1"));
  CHECK(mentions(refusal_of_beams({{.along_y = true, .count = 2, .spacing = 5.3, .width = 0.2}}),
                 "the pocket of beam 1 leaves a piece of 0.05 m in course 8 of wall 'south', from x = 0.2 to 0.25 m, "
                 "shorter than the least length of 0.08 m. Move the beams by spacing"));
  CHECK(mentions(refusal_of([] {
                   SolidWall wall{.length = 4, .storeys = {{.courses = 3}}};
                   wall.storeys[0].beams = std::vector<BeamRow>{{.count = 1, .width = 0.1}};
                   build_solid_wall(wall);
                 }),
                 "wall: storey 1: beams: there is no room"));
}
