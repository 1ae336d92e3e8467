// Half an arch between a pier and a wall: position of its joints, and rejected input.
#include "build/plane/flying_buttress.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "near.hpp"

using namespace trilith;
using trilith::testing::near;
using trilith::testing::near_zero;

namespace {

double area_of(const Part& part) {
  double twice = 0;
  for (std::size_t i = 0; i < part.outline.size(); ++i) {
    const Vec2 &p = part.outline[i], &q = part.outline[(i + 1) % part.outline.size()];
    twice += p.x() * q.y() - p.y() * q.x();
  }
  return twice / 2;
}

std::string refusal(const FlyingButtress& f) {
  try {
    build_flying_buttress(f);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a flying buttress fills the sector between its circles and shares its joints to the bit") {
  FlyingButtress f;
  f.voussoirs = 8, f.span = 4, f.rise = 2, f.thickness = 0.5, f.sub_edges = 40;
  const std::vector<Part> parts = build_flying_buttress(f);
  REQUIRE(parts.size() == 8);
  // Level at the head: radius (16 + 4)/4 = 5 m about (4, -3), from an angle of asin 4/5 to zero.
  double area = 0;
  for (std::size_t v = 0; v < parts.size(); ++v) {
    const Polygon& outline = parts[v].outline;
    area += area_of(parts[v]);
    for (std::size_t i = 0; i <= 40; ++i) CHECK(near((outline[i] - Vec2(4, -3)).norm(), 5, 1e-12));
    for (std::size_t i = 41; i < outline.size(); ++i) CHECK(near((outline[i] - Vec2(4, -3)).norm(), 5.5, 1e-12));
    if (v + 1 == parts.size()) break;
    CHECK(outline[40] == parts[v + 1].outline.front());
    CHECK(outline[41] == parts[v + 1].outline.back());
  }
  CHECK(near(area, std::asin(0.8) / 2 * (5.5 * 5.5 - 25), 1e-4));
  CHECK(parts.front().outline.front() == Vec2(0, 0));
  CHECK(parts.back().outline[40] == Vec2(4, 2));
  CHECK(near(parts.back().outline[41].y(), 2.5, 1e-12));
}

TEST_CASE("a coping is one straight line over all voussoirs, with joints towards the circle's centre") {
  FlyingButtress f;
  f.voussoirs = 9, f.sub_edges = 3, f.slope = 20 * std::numbers::pi / 180, f.springing = {1, 7};
  f.pier_height = 6, f.pier_width = 1.5, f.wall_width = 0.8, f.wall_height = 3;
  const std::vector<Part> parts = build_flying_buttress(f);
  REQUIRE(parts.size() == 11);
  const Vec2 head = f.springing + Vec2(4, 2.4), centre = f.springing + Vec2(4, -3);
  for (std::size_t v = 0; v < 9; ++v) {
    const Polygon& outline = parts[v].outline;
    REQUIRE(outline.size() == 6);  // four of the intrados, two of the coping
    CHECK(area_of(parts[v]) > 0);
    for (const Vec2& p : {outline[4], outline[5]})
      CHECK(near_zero(p.y() - head.y() - std::tan(f.slope) * (p.x() - head.x()), 1e-12));
    const Vec2 low = outline[0] - centre, high = outline[5] - centre;
    CHECK(near_zero(low.x() * high.y() - low.y() * high.x(), 1e-12));
  }
  // Pier and wall follow the shape of the ends.
  CHECK(parts[9].name == "pier");
  CHECK(parts[9].outline[2] == parts[0].outline.front());
  CHECK(parts[9].outline[3] == parts[0].outline.back());
  CHECK(area_of(parts[9]) > 6 * 1.5);
  CHECK(parts[10].name == "wall");
  CHECK(near(area_of(parts[10]), 0.8 * (2 + 3), 1e-12));
}

TEST_CASE("a steep flyer has the given radius and a vertical last joint") {
  FlyingButtress f;
  f.span = 2, f.rise = 3, f.radius = 4, f.voussoirs = 5;
  const std::vector<Part> parts = build_flying_buttress(f);
  const Polygon& last = parts.back().outline;
  CHECK(last[1] == Vec2(2, 3));
  CHECK(last[2].x() == 2);
  CHECK(last[2].y() > 3.4);
  for (const Part& part : parts) CHECK(area_of(part) > 0);
}

TEST_CASE("impossible flying buttresses are rejected with a remedy") {
  FlyingButtress f;
  f.name = "A", f.rise = 5;
  CHECK(refusal(f).find("flying buttress 'A': rise is 5 m, above the span of 4 m") == 0);
  f.radius = 5;
  CHECK(refusal(f).find("radius is 5 m, must be at least 5.125 m") != std::string::npos);
  f.radius = 5.125, f.pier_height = 1;  // springs level, so the pier has a flat top
  CHECK(refusal(f).empty());
  CHECK(near_zero(build_flying_buttress(f).back().outline[3].y(), 1e-12));
  f = {}, f.slope = 0.6;
  CHECK(refusal(f).find("a coping of slope 0.6 rad meets the intrados") != std::string::npos);
  f.slope = 1.6;
  CHECK(refusal(f).find("must be below pi/2") != std::string::npos);
  f = {}, f.slope = 0.35, f.pier_height = 1, f.pier_width = 0.3;
  CHECK(refusal(f).find("pier_width is 0.3 m, must be at least") != std::string::npos);
  f = {}, f.thickness = 0;
  CHECK(refusal(f).find("thickness is 0 m, must be finite and above 0") != std::string::npos);
}
