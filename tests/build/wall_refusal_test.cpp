// Walls and openings that cannot be built: their messages.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "build/plain_wall.hpp"

using namespace trilith;
using namespace trilith::testing;

TEST_CASE("a sill off the course lines is rejected with the nearest lines, or moved on request") {
  WallOpening opening{.x = 0.8, .sill = 0.25, .width = 0.8, .height = 0.4};
  CHECK(refusal_of_opening(opening) ==
        "wall 'w', opening 1 (storey 1): sill is 0.25 m, must lie on a course line: 0.2 or 0.4 m are nearest, and snap "
        "takes the nearer one");
  Wall wall = plain_wall();
  wall.openings = {opening}, wall.snap = true;
  const BuiltParts made = build_wall(wall);
  check_sound(made.parts);
  CHECK(made.notes ==
        std::vector<std::string>{
            "wall, opening 1 (storey 1): sill is moved from 0.25 to 0.2 m, a course line",
            "wall, opening 1 (storey 1): head (sill + height) is moved from 0.65 to 0.6 m, a course line"});
  CHECK(count_in_group(made.parts, "lintels") == 1);
}

TEST_CASE("impossible openings are rejected with place, value and allowed values") {
  const WallOpening good{.x = 0.8, .sill = 0.2, .width = 0.8, .height = 0.4};
  CHECK(refusal_of_opening(good) == "accepted");
  const auto with = [&](auto change) {
    WallOpening opening = good;
    change(opening);
    return refusal_of_opening(opening);
  };
  const auto first = [](std::string_view rest) { return fmt::format("wall 'w', opening 1 (storey 1): {}", rest); };
  CHECK(with([](WallOpening& o) { o.x = 1.8; }) ==
        first("lies from x = 1.8 to 2.6 m, must lie within the wall's 0 to 2.4 m"));
  CHECK(with([](WallOpening& o) { o.height = 1; }) ==
        first("head is at 1.2 m, must not be above the storey's courses of 1 m"));
  CHECK(with([](WallOpening& o) { o.storey = 2; }) ==
        "wall 'w', opening 1: storey is 2, must be a whole number from 1 to 1");
  CHECK(with([](WallOpening& o) { o.width = 0; }) == first("width is 0 m, must be finite and above 0"));
  CHECK(mentions(with([](WallOpening& o) { o.sill = -0.2; }), "sill is -0.2 m"));
  CHECK(with([](WallOpening& o) { o.x = 0.1, o.lintel_bearing = 0.2; }) ==
        first("lintel lies from x = -0.1 to 1.1 m, must lie within the wall's 0 to 2.4 m; a bearing of up to 0.1 m "
              "fits, or give lintel = false"));
  CHECK(with([](WallOpening& o) { o.lintel_height = 0.6; }) ==
        first("lintel needs 3 courses over the head, but 2 are left in the storey"));
  CHECK(
      with([](WallOpening& o) { o.x = 0.05, o.lintel_bearing = 0.02; }) ==
      "wall 'w', storey 1, course 2: the masonry from x = 0 to 0.05 m is 0.05 m long, less than the least length of a "
      "unit, 0.1 m; move the opening, or give a smaller least_length");
  CHECK(with([](WallOpening& o) { o.x = 0, o.lintel = false; }) == "accepted");
  CHECK(with([](WallOpening& o) { o.x = 0, o.height = 0.8; }) == "accepted");  // no courses above the head
}

TEST_CASE("openings and lintels on each other are rejected") {
  Wall wall = plain_wall();
  wall.openings = {{.x = 0.4, .sill = 0.2, .width = 0.6, .height = 0.4},
                   {.x = 0.8, .sill = 0.4, .width = 0.6, .height = 0.4}};
  CHECK(mentions(refusal_of_wall(wall), "opening 2 (storey 1): overlaps the opening from x = 0.4 to 1 m"));
  wall.openings[1].x = 1.2, wall.openings[1].sill = 0.2;
  CHECK(mentions(refusal_of_wall(wall),
                 "opening 2 (storey 1): lintel from x = 1 to 2 m runs into the lintel from x = 0.2 to "
                 "1.2 m"));
  wall.openings[0].lintel_bearing = 0.25;
  CHECK(mentions(refusal_of_wall(wall),
                 "opening 1 (storey 1): lintel reaches 0.25 m beyond each side and so over the next opening; give a "
                 "shorter bearing"));
  for (WallOpening& opening : wall.openings) opening.lintel_bearing = 0.1;
  CHECK(refusal_of_wall(wall) == "accepted");
}

TEST_CASE("walls with invalid sizes are rejected") {
  const auto with = [](auto change) {
    Wall wall = plain_wall();
    change(wall);
    return refusal_of_wall(wall);
  };
  CHECK(mentions(with([](Wall& w) { w.length = 0; }), "give its length in m, or the number of whole units"));
  CHECK(mentions(with([](Wall& w) { w.units = 3; }), "both length and units are given"));
  CHECK(mentions(with([](Wall& w) { w.unit_length = 0; }), "unit length is 0 m"));
  CHECK(mentions(with([](Wall& w) { w.bond = "flemisch"; }), "there is no bond 'flemisch'; did you mean 'flemish'?"));
  CHECK(mentions(with([](Wall& w) { w.first_row = 3; }),
                 "first row of the bond is 3, must be a whole number from 1 to 2"));
  CHECK(mentions(with([](Wall& w) { w.storeys.clear(); }), "has no storey"));
  CHECK(mentions(
      with([](Wall& w) { w.storeys = {{.height = 2.5, .slab_height = 0.2}}; }),
      "storey 1: 2.5 m high with a slab of 0.2 m leaves 11.5 courses of 0.2 m, must be a whole number; 2.4 or 2.6 "
      "m would fit"));
  CHECK(mentions(with([](Wall& w) { w.storeys = {{.courses = 4, .height = 1}}; }),
                 "4 courses are given, but its height"));
  CHECK(mentions(with([](Wall& w) { w.jitter = 0.1; }),
                 "jitter is 0.1 m, must be at most a quarter of the least length"));
  CHECK(mentions(with([](Wall& w) { w.length = 0.05; }), "must not be above the wall's length"));
  CHECK(mentions(with([](Wall& w) { w.length = 1e9; }), "at most 1000000 are built"));
  CHECK(mentions(with([](Wall& w) { w.length = NAN; }), "length is nan"));
  CHECK(mentions(with([](Wall& w) { w.least_length = -1; }), "least length is -1 m"));
}
