#include "build/plane/bridge.hpp"

#include <doctest/doctest.h>

#include "build/sound_parts.hpp"

using namespace trilith;
using namespace trilith::testing;

TEST_CASE("a pier of footing, stem and cap is one concave outline, symmetric about its middle") {
  const Part pier = build_pier({.name = "P1",
                                .x = 100,
                                .ground_level = -40,
                                .height = 40,
                                .stem_width = 2,
                                .top_width = 4,
                                .cap_thickness = 1,
                                .footing_width = 20,
                                .footing_thickness = 4});
  check_sound({pier});
  CHECK(pier.outline.size() == 12);
  CHECK(signed_area(pier.outline) == 20 * 4 + 2 * 35 + 4 * 1);
  CHECK(polygon_moments(pier.outline).centroid.x() == 100);
  const Box2 box = bounding_box(pier.outline);
  CHECK(box.low == Vec2(90, -40));
  CHECK(box.high == Vec2(110, 0));
  CHECK(convex_parts(pier.outline).size() == 3);
}

TEST_CASE("a pier without footing, without cap or with a tapering stem is drawn with as few corners") {
  CHECK(build_pier({.height = 5, .stem_width = 1}).outline == Polygon{{-0.5, 0}, {0.5, 0}, {0.5, 5}, {-0.5, 5}});
  const Part taper = build_pier({.height = 5, .stem_width = 2, .top_width = 1});
  CHECK(taper.outline == Polygon{{-1, 0}, {1, 0}, {0.5, 5}, {-0.5, 5}});
  const Part flush = build_pier(
      {.height = 5, .stem_width = 2, .top_width = 2, .cap_thickness = 1, .footing_width = 2, .footing_thickness = 1});
  CHECK(flush.outline.size() == 4);
  const Part footed = build_pier({.height = 5, .stem_width = 2, .footing_width = 6, .footing_thickness = 1});
  CHECK(footed.outline.size() == 8);
  CHECK(signed_area(footed.outline) == 14);
  check_sound({footed});
}

TEST_CASE("abutments stand behind their front face, left and right as mirror images") {
  const Abutment left{.name = "A0",
                      .side = AbutmentSide::left,
                      .x = 3,
                      .ground_level = -20,
                      .height = 20,
                      .width = 12,
                      .back_wall_height = 2.5,
                      .back_wall_width = 8};
  Abutment right = left;
  right.side = AbutmentSide::right;
  right.x = -3;
  const Part a = build_abutment(left), b = build_abutment(right);
  check_sound({a});
  check_sound({b});
  CHECK(a.outline.size() == 6);
  CHECK(signed_area(a.outline) == 12 * 20 + 8 * 2.5);
  for (const Vec2& p : a.outline) CHECK(std::count(b.outline.begin(), b.outline.end(), Vec2(-p.x(), p.y())) == 1);
  CHECK(bounding_box(a.outline).low == Vec2(-9, -20));
  CHECK(bounding_box(a.outline).high == Vec2(3, 2.5));
  CHECK(contains(a.outline, {-5, 1}));
  CHECK_FALSE(contains(a.outline, {1, 1}));
  const Part plain = build_abutment({.side = AbutmentSide::right, .x = 1, .height = 2, .width = 3});
  CHECK(plain.outline == Polygon{{1, 0}, {4, 0}, {4, 2}, {1, 2}});
}

TEST_CASE("a span fills its opening except for the gap at each end") {
  const Part span = build_span({.name = "S1", .x0 = 10, .x1 = 40, .end_gap = 0.5, .soffit_level = 2, .depth = 1.5});
  CHECK(span.outline == Polygon{{10.5, 2}, {39.5, 2}, {39.5, 3.5}, {10.5, 3.5}});
  CHECK(span.groups == std::vector<std::string>{"spans"});
}

TEST_CASE("bridge pieces that cannot be built are rejected by name") {
  CHECK(mentions(refusal_of([] { build_pier({.name = "P1", .height = 5}); }), "pier 'P1': stem width is 0 m"));
  CHECK(mentions(refusal_of([] { build_pier({.height = 5, .stem_width = 1, .footing_width = 3}); }),
                 "give both or neither"));
  CHECK(mentions(
      refusal_of([] { build_pier({.height = 5, .stem_width = 4, .footing_width = 3, .footing_thickness = 1}); }),
      "footing width is 3 m, must not be below the stem width of 4 m"));
  CHECK(mentions(refusal_of([] { build_pier({.height = 5, .stem_width = 1, .top_width = 2, .cap_thickness = 5}); }),
                 "height is 5 m"));
  CHECK(mentions(refusal_of([] { build_pier({.height = 5, .stem_width = 1, .cap_thickness = 1}); }),
                 "give its top width"));
  CHECK(mentions(refusal_of([] { build_abutment({.name = "A0", .height = 2}); }), "abutment 'A0': width is 0 m"));
  CHECK(mentions(
      refusal_of([] { build_abutment({.height = 2, .width = 3, .back_wall_height = 1, .back_wall_width = 3}); }),
      "no seat is left"));
  CHECK(mentions(refusal_of([] { build_abutment({.height = 2, .width = 3, .back_wall_height = 1}); }),
                 "give both or neither"));
  CHECK(mentions(refusal_of([] { build_span({.name = "S1", .x0 = 1, .x1 = 2, .end_gap = 0.5, .depth = 1}); }),
                 "leaves no length"));
  CHECK(mentions(refusal_of([] { build_span({.x0 = 0, .x1 = 2}); }), "span 'span': depth is 0 m"));
}
