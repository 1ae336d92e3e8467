#include "build/plane/ground.hpp"

#include <doctest/doctest.h>

#include "build/sound_parts.hpp"

using namespace trilith;
using namespace trilith::testing;

TEST_CASE("a stepped valley is one concave outline with the area under its surface") {
  const std::vector<GroundStep> steps{{0, 0}, {10, -20}, {25, -40}, {50, -20}, {60, 0}};
  const PolygonPart ground = build_ground_profile({.surface = stepped_surface(steps, 80), .base_level = -50});
  check_sound({ground.part});
  CHECK(ground.notes.empty());
  CHECK(ground.part.name == "ground");
  CHECK(ground.part.outline.size() == 12);
  CHECK(ground.part.outline[0] == Vec2(0, -50));
  CHECK(ground.part.outline.back() == Vec2(0, 0));
  CHECK(signed_area(ground.part.outline) == 50 * 10 + 30 * 15 + 10 * 25 + 30 * 10 + 50 * 20);
}

TEST_CASE("neighbouring steps of one level are one face") {
  CHECK(stepped_surface({{0, 1}, {1, 1}, {2, 3}}, 4) == std::vector<Vec2>{{0, 1}, {2, 1}, {2, 3}, {4, 3}});
}

TEST_CASE("a sloping surface with a collinear point keeps it") {
  const PolygonPart ground =
      build_ground_profile({.name = "hill", .surface = {{0, 1}, {1, 2}, {2, 3}}, .base_level = 0});
  CHECK(ground.part.outline == Polygon{{0, 0}, {2, 0}, {2, 3}, {1, 2}, {0, 1}});
  CHECK(convex_parts(ground.part.outline).size() == 1);
}

TEST_CASE("grounds that cannot be built are rejected") {
  CHECK(mentions(refusal_of([] {
                   build_ground_profile({.surface = {{0, 0}}, .base_level = -1});
                 }),
                 "surface has 1 point,"));
  CHECK(mentions(refusal_of([] {
                   build_ground_profile({.surface = {{0, 0}, {1, -2}}, .base_level = -1});
                 }),
                 "ground profile 'ground': surface point 2 (1, -2) is not above the base level -1 m"));
  CHECK(mentions(refusal_of([] {
                   build_ground_profile({.surface = {{0, 0}, {2, 0}, {1, 1}}, .base_level = -1});
                 }),
                 "surface point 3 (1, 1) lies left of the previous point"));
  CHECK(mentions(refusal_of([] { build_ground_profile({.surface = {{0, 0}, {0, 1}}, .base_level = -1}); }), "no area"));
  CHECK(mentions(refusal_of([] { stepped_surface({}, 1); }), "no steps"));
  CHECK(mentions(refusal_of([] { stepped_surface({{0, 0}, {5, 1}}, 5); }), "step 2: reaches from 5 m to 5 m"));
}
