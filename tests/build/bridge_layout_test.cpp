#include "build/plane/bridge_layout.hpp"

#include <doctest/doctest.h>

#include "build/sound_parts.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

const Abutment left_abutment{.name = "A0",
                             .side = AbutmentSide::left,
                             .ground_level = -6,
                             .height = 6,
                             .width = 4,
                             .back_wall_height = 1.5,
                             .axis = 0,
                             .seat = 0.5,
                             .gap = 0.1};
const Pier pier_1{.name = "P1", .x = 20, .ground_level = -6, .height = 6, .seat = 0.5, .gap = 0.2};
const Abutment right_abutment{.name = "A2",
                              .side = AbutmentSide::right,
                              .ground_level = -6,
                              .height = 6,
                              .width = 4,
                              .back_wall_height = 1.5,
                              .axis = 50,
                              .seat = 0.4,
                              .gap = 0.1};

/// Two abutments and a pier with seats at y = 0; bearing types without height, and one 0.3 m high.
BridgeLayout layout() {
  BridgeLayout bridge;
  bridge.add_support(top_of(left_abutment));
  bridge.add_support(top_of(pier_1));
  bridge.add_support(top_of(right_abutment));
  bridge.add_bearing_type({"fixed"});
  bridge.add_bearing_type({"expansion"});
  bridge.add_bearing_type({"pot", 0.3});
  return bridge;
}

SpanPlan first() {
  return {.name = "S1", .from = "A0", .to = "P1", .left = "fixed", .right = "expansion", .depth = 1.2};
}
SpanPlan second() {
  return {.name = "S2", .from = "P1", .to = "A2", .left = "fixed", .right = "expansion", .depth = 1.2};
}

std::string why_not(const SpanPlan& plan) {
  return refusal_of([&] { static_cast<void>(layout().lay(plan)); });
}

}  // namespace

TEST_CASE("a span ends half a joint from the axes of its supports, its bearings in the middle of the seats") {
  const LaidSpan span = layout().lay(first());
  CHECK(span.deck.outline == Polygon{{0.05, 0}, {19.9, 0}, {19.9, 1.2}, {0.05, 1.2}});
  CHECK(span.deck.groups == std::vector<std::string>{"spans"});
  const SpanEnd &left = span.ends[0], &right = span.ends[1];
  CHECK(left.support == "A0");
  CHECK(left.end == Vec2(0.05, 0));
  CHECK(left.edge == Vec2(0.05 + 0.5, 0));
  CHECK(left.bearing == Vec2(0.05 + 0.25, 0));
  CHECK(left.inward == Vec2(-1, 0));
  CHECK(right.support == "P1");
  CHECK(right.end == Vec2(19.9, 0));
  CHECK(right.edge == Vec2(19.9 - 0.5, 0));
  CHECK(right.bearing == Vec2(19.9 - 0.25, 0));
  CHECK(right.inward == Vec2(1, 0));
  for (const SpanEnd& end : span.ends) CHECK(end.seat == 0.5);
  CHECK(span.length() == 19.9 - 0.05);
}

TEST_CASE("between two decks, and between a deck and the back wall, the joint has the width given for the support") {
  BridgeLayout bridge = layout();
  const LaidSpan one = bridge.lay(first());
  bridge.add(one);
  const LaidSpan two = bridge.lay(second());
  CHECK(near(two.ends[0].end.x() - one.ends[1].end.x(), 0.2, 1e-12));
  const Part wall = build_abutment(right_abutment);
  const double face = 50.05;  // the axis is in the middle of a joint of 0.1 m
  CHECK(contains(wall.outline, {face + 1e-9, 1}));
  CHECK_FALSE(contains(wall.outline, {face - 1e-9, 1}));
  CHECK(near(face - two.ends[1].end.x(), 0.1, 1e-12));
  CHECK(two.ends[1].seat == 0.4);
}

TEST_CASE("seats and joint make a pier's top and an abutment's back wall") {
  CHECK(build_pier(pier_1).outline == Polygon{{19.4, -6}, {20.6, -6}, {20.6, 0}, {19.4, 0}});
  Pier hammer = pier_1;
  hammer.stem_width = 0.8, hammer.cap_thickness = 1;
  const Box2 top = bounding_box(build_pier(hammer).outline);
  CHECK(top.low.x() == 19.4);
  CHECK(with_seats(hammer).top_width == 2 * 0.5 + 0.2);
  const Abutment a = with_seats(left_abutment);
  CHECK(a.x == 0.05 + 0.5);
  CHECK(a.back_wall_width == 4 - 0.5 - 0.1);
}

TEST_CASE("keys missing in a support follow from its top and the gap of the span") {
  BridgeLayout bridge = layout();
  bridge.add_support(top_of(Pier{.name = "P3", .x = 30, .ground_level = -6, .height = 6, .stem_width = 2}));
  bridge.add_support(top_of("rock", {{60, -6}, {64, -6}, {64, -1}, {63, 0}, {61, 0}}));
  bridge.add_support(top_of(Abutment{.name = "A9",
                                     .side = AbutmentSide::right,
                                     .x = 80,
                                     .ground_level = -6,
                                     .height = 6,
                                     .width = 3,
                                     .back_wall_height = 1,
                                     .back_wall_width = 2}));
  SpanPlan plan = second();
  plan.from = "P3", plan.to = "rock", plan.gap = 0.1;
  const LaidSpan span = bridge.lay(plan);
  CHECK(span.ends[0].end == Vec2(30.05, 0));
  CHECK(near(span.ends[0].edge.x(), 31, 1e-12));
  CHECK(span.ends[1].end == Vec2(61.95, 0));
  CHECK(near(span.ends[1].edge.x(), 61, 1e-12));
  plan.name = "S3", plan.from = "rock", plan.to = "A9";
  const LaidSpan last = bridge.lay(plan);
  CHECK(near(last.ends[1].end.x(), 80.9, 1e-12));
  CHECK(near(last.ends[1].edge.x(), 80, 1e-12));
  plan.gap = std::nullopt;
  CHECK(mentions(
      refusal_of([&] { static_cast<void>(bridge.lay(plan)); }),
      "span 'S3': the width of the joint on support 'rock' is missing; give gap at the support or at the span"));
  plan.gap = 2;
  CHECK(mentions(refusal_of([&] { static_cast<void>(bridge.lay(plan)); }),
                 "leaves no seat on support 'rock', whose top is 2 m long"));
}

TEST_CASE("a deck lies on its bearings, and both must have it at one level") {
  BridgeLayout bridge = layout();
  SpanPlan plan = first();
  plan.left = plan.right = "pot";
  CHECK(bridge.lay(plan).ends[1].bearing.y() == 0.3);
  CHECK(bounding_box(bridge.lay(plan).deck.outline).low.y() == 0.3);
  plan.right = "expansion";
  CHECK(mentions(why_not(plan),
                 "span 'S1': its underside is at y = 0.3 m, but on 'P1' (seat at 0 m, bearing type "
                 "'expansion' 0 m high) it would be at 0 m; make seats or bearings fit"));
  plan = first();
  plan.soffit_level = 1e-9;
  CHECK(bridge.lay(plan).ends[0].end.y() == 1e-9);
  plan.soffit_level = 1e-5;
  CHECK(mentions(why_not(plan), "on 'A0'"));
}

TEST_CASE("a span on unknown supports or bearings is rejected with the nearest name") {
  SpanPlan plan = first();
  plan.to = "p1";
  CHECK(mentions(why_not(plan), "span 'S1': to: there is no support 'p1'; did you mean 'P1'?"));
  plan.to = "the pier";
  CHECK(mentions(why_not(plan), "there is no support 'the pier'; known: A0, P1, A2"));
  plan = first();
  plan.left = "fixd";
  CHECK(mentions(why_not(plan), "span 'S1': left: there is no bearing type 'fixd'; did you mean 'fixed'?"));
  BridgeLayout empty;
  CHECK(mentions(refusal_of([&] { static_cast<void>(empty.lay(first())); }), "piers and abutments come before spans"));
  empty.add_support(top_of(left_abutment));
  empty.add_support(top_of(pier_1));
  CHECK(mentions(refusal_of([&] { static_cast<void>(empty.lay(first())); }), "bearing types come before spans"));
}

TEST_CASE("a span that runs backwards, has no length or has the same support at both ends is rejected") {
  SpanPlan plan = first();
  plan.from = "A2", plan.to = "P1";
  CHECK(mentions(why_not(plan), "from is 'A2', an abutment at the right end of a bridge; give it as to"));
  plan.from = "P1", plan.to = "A0";
  CHECK(mentions(why_not(plan), "to is 'A0', an abutment at the left end of a bridge; give it as from"));
  plan.to = "P1";
  CHECK(mentions(why_not(plan), "from and to are both 'P1'"));
  BridgeLayout bridge = layout();
  bridge.add_support(top_of(Pier{.name = "P9", .x = 21.1, .ground_level = -6, .height = 6, .seat = 0.5, .gap = 0.2}));
  plan.from = "P9";
  CHECK(mentions(refusal_of([&] { static_cast<void>(bridge.lay(plan)); }),
                 "'P1' at x = 20 m is not to the right of 'P9' at 21.1 m; from is the left support"));
  plan.from = "P1", plan.to = "P9";
  CHECK(mentions(refusal_of([&] { static_cast<void>(bridge.lay(plan)); }),
                 "the joints leave 0.9 m of deck, which must be above the 1 m of both seats"));
  plan = first();
  plan.depth = -1;
  CHECK(mentions(why_not(plan), "span 'S1': depth is -1 m"));
  plan = first();
  plan.gap = -0.1;
  CHECK(mentions(why_not(plan), "span 'S1': gap is -0.1 m"));
}

TEST_CASE("each seat takes one span, and no deck overlaps another") {
  BridgeLayout bridge = layout();
  bridge.add(bridge.lay(first()));
  SpanPlan again = first();
  again.name = "S9";
  CHECK(mentions(
      refusal_of([&] { static_cast<void>(bridge.lay(again)); }),
      "span 'S9': the seat on 'A0' to the right of its joint already carries span 'S1'; each seat carries one span"));
  bridge.add_support(top_of(Pier{.name = "P9", .x = 10, .ground_level = -6, .height = 6, .seat = 0.5, .gap = 0.2}));
  SpanPlan across = second();
  across.from = "P9";
  CHECK(mentions(refusal_of([&] { static_cast<void>(bridge.lay(across)); }),
                 "span 'S2': from x = 10.1 to 49.95 m it overlaps span 'S1', from 0.05 to 19.9 m"));
  CHECK(bridge.lay(second()).deck.name == "S2");
}

TEST_CASE("invalid seats, joints and bearing types are rejected by name") {
  CHECK(mentions(refusal_of([] { build_pier({.name = "P1", .height = 5, .seat = 0.4}); }),
                 "seat is 0.4 m, but the width of its joint"));
  CHECK(mentions(refusal_of([] {
                   build_pier({.name = "P1", .height = 5, .stem_width = 1, .top_width = 2, .seat = 0.4, .gap = 0.1});
                 }),
                 "both top width, 2 m, and seat, 0.4 m, are given"));
  CHECK(mentions(refusal_of([] { build_pier({.name = "P1", .height = 5, .stem_width = 1, .gap = 1}); }),
                 "a joint of 1 m leaves no seat on a top 1 m wide"));
  CHECK(mentions(refusal_of([] { build_pier({.name = "P1", .height = 5, .seat = -0.4, .gap = 0.1}); }),
                 "seat is -0.4 m"));
  Abutment a = left_abutment;
  a.seat = 0;
  CHECK(mentions(refusal_of([&] { build_abutment(a); }), "abutment 'A0': the axis is the middle of the joint"));
  a = left_abutment;
  a.back_wall_width = 3;
  CHECK(mentions(refusal_of([&] { build_abutment(a); }), "both back wall width, 3 m, and seat, 0.5 m, are given"));
  a = left_abutment;
  a.width = 0.6;
  CHECK(
      mentions(refusal_of([&] { build_abutment(a); }), "width is 0.6 m, must be above seat and joint together, 0.6 m"));
  CHECK(mentions(refusal_of([] {
                   static_cast<void>(top_of("rock", {{0, 0}, {2, 0}, {1, 1}}));
                 }),
                 "support 'rock': its highest point, at y = 1 m, is a corner"));
  BridgeLayout bridge = layout();
  CHECK(mentions(refusal_of([&] { bridge.add_bearing_type({"fixed"}); }), "bearing type 'fixed': exists already"));
  CHECK(mentions(refusal_of([&] { bridge.add_bearing_type({"low", -0.1}); }), "bearing type 'low': height is -0.1 m"));
}
