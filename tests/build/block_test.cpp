#include "build/plane/block.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <numbers>

#include "build/sound_parts.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

TEST_CASE("a block stands at its lower left corner or about its centre") {
  const Part at_corner = build_block({.name = "a", .width = 2, .height = 1, .at = {3, 4}, .groups = {"stones"}});
  CHECK(at_corner.outline == Polygon{{3, 4}, {5, 4}, {5, 5}, {3, 5}});
  CHECK(at_corner.groups == std::vector<std::string>{"stones"});
  const Part centred = build_block({.name = "b", .width = 2, .height = 1, .at = {3, 4}, .anchor = BlockAnchor::centre});
  CHECK(centred.outline == Polygon{{2, 3.5}, {4, 3.5}, {4, 4.5}, {2, 4.5}});
}

TEST_CASE("a block is turned counter-clockwise about its anchor") {
  const Part part = build_block({.name = "a", .width = 2, .height = 1, .at = {3, 4}, .angle = std::numbers::pi / 2});
  CHECK(part.outline[0] == Vec2(3, 4));
  CHECK(part.outline[1].isApprox(Vec2(3, 6), 1e-15));
  CHECK(part.outline[2].isApprox(Vec2(2, 6), 1e-15));
  const Part turned =
      build_block({.name = "b", .width = 2, .height = 1, .at = {3, 4}, .anchor = BlockAnchor::centre, .angle = 0.3});
  CHECK(polygon_moments(turned.outline).centroid.isApprox(Vec2(3, 4), 1e-15));
  CHECK(near(signed_area(turned.outline), 2, 1e-14));
}

TEST_CASE("a block without size or place is rejected by name") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(mentions(refusal_of([] { build_block({.name = "a", .width = 0, .height = 1}); }), "block 'a': width is 0 m"));
  CHECK(mentions(refusal_of([] { build_block({.name = "a", .width = 1, .height = -1}); }), "height is -1 m"));
  CHECK(mentions(refusal_of([=] {
                   build_block({.name = "a", .width = 1, .height = 1, .at = {nan, 0}});
                 }),
                 "at must be finite"));
  CHECK(
      mentions(refusal_of([=] { build_block({.name = "a", .width = 1, .height = 1, .angle = nan}); }), "angle is nan"));
}

TEST_CASE("a polygon of the user's points comes back repaired, with notes, or is rejected by name") {
  const PolygonPart built = build_polygon("stone", {{0, 0}, {0, 1}, {1, 0}}, {"stones"});
  CHECK(built.part.outline == Polygon{{0, 0}, {1, 0}, {0, 1}});
  CHECK(built.notes.size() == 1);
  CHECK(mentions(refusal_of([] {
                   build_polygon("stone", {{0, 0}, {1, 1}, {1, 0}, {0, 1}});
                 }),
                 "polygon 'stone': outline crosses"));
}
