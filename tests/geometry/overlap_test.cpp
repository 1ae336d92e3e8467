#include "geometry/plane/overlap.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "geometry/plane/polygon.hpp"
#include "geometry/plane/random_convex.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;

namespace {

Polygon box(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

struct Pair {
  Polygon a, b;
};

Pair random_pair(std::mt19937_64& bits) {
  Polygon a = random_convex(bits, {.slenderest = 6}), b = random_convex(bits, {.slenderest = 6});
  // In separate statements: the order of evaluation of arguments is unspecified.
  const double y = random_between(bits, -1.2, 1.2), x = random_between(bits, -1.2, 1.2);
  return {std::move(a), placed(b, Vec2(1, 0), Vec2(x, y))};
}

/// The left part of `outline`, cut by the line through `at` along `direction`.
Polygon left_part(const Polygon& outline, const Vec2& at, const Vec2& direction) {
  const Vec2 far = 100 * direction, side = 100 * left_of(direction);
  OverlapBuffer buffer;
  convex_overlap(outline, Polygon{at - far, at + far, at + far + side, at - far + side}, buffer);
  return buffer.corners;
}

}  // namespace

TEST_CASE("two boxes overlap in the box that they share") {
  OverlapBuffer buffer;
  const Overlap shared = convex_overlap(box(0, 0, 2, 1), box(1.5, 0.25, 2, 3), buffer);
  CHECK(shared.area == 0.375);
  CHECK(shared.centroid.isApprox(Vec2(1.75, 0.625), 1e-15));
  CHECK(buffer.corners.size() == 4);
  CHECK(convex_overlap(box(0, 0, 2, 1), box(0.5, 0.25, 0.5, 0.5), buffer).area == 0.25);
}

TEST_CASE("boxes that touch along a face, at a corner or not at all have no overlap") {
  OverlapBuffer buffer;
  for (const Polygon& other : {box(2, 0, 1, 1), box(0.7, 1, 2, 1), box(2, 1, 1, 1), box(5, 5, 1, 1)}) {
    CHECK(convex_overlap(box(0, 0, 2, 1), other, buffer).area == 0);
    CHECK(convex_overlap(other, box(0, 0, 2, 1), buffer).area == 0);
    CHECK(buffer.corners.empty());
  }
}

TEST_CASE("faces with the same end points share nothing at any angle") {
  std::mt19937_64 bits(4);
  OverlapBuffer buffer;
  for (int trial = 0; trial < 1000; ++trial) {
    const Vec2 d = random_direction(bits), p(random_between(bits, -3, 3), random_between(bits, -3, 3)), q = p + 1.7 * d;
    const Polygon above{p, q, q + left_of(d), p + left_of(d)}, below{q, p, p - left_of(d), q - left_of(d)};
    CHECK(convex_overlap(above, below, buffer).area == 0);
    CHECK(std::abs(penetration(above, below).separation) < 1e-15);
  }
}

TEST_CASE("overlap is symmetric and does not depend on the frame") {
  std::mt19937_64 bits(6);
  OverlapBuffer buffer;
  int meeting = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    const auto [a, b] = random_pair(bits);
    const Overlap ab = convex_overlap(a, b, buffer);
    if (ab.area > 0) CHECK(is_convex(buffer.corners) == true);
    CHECK(buffer.corners.size() <= a.size() + b.size());
    const Overlap ba = convex_overlap(b, a, buffer);
    const Vec2 d = random_direction(bits);
    const double sy = random_between(bits, -9, 9), sx = random_between(bits, -9, 9);
    const Vec2 s(sx, sy);
    const Overlap moved = convex_overlap(placed(a, d, s), placed(b, d, s), buffer);
    CHECK(std::abs(ab.area - ba.area) < 1e-14);
    CHECK(std::abs(ab.area - moved.area) < 1e-13);
    if (ab.area < 1e-4) continue;
    ++meeting;
    CHECK((ab.centroid - ba.centroid).norm() < 1e-11);
    CHECK((moved.centroid - s - ab.centroid.x() * d - ab.centroid.y() * left_of(d)).norm() < 1e-10);
  }
  CHECK(meeting > 1500);
}

TEST_CASE("the overlaps with the two halves of a polygon add up to the overlap with the whole") {
  std::mt19937_64 bits(7);
  OverlapBuffer buffer;
  for (int trial = 0; trial < 3000; ++trial) {
    const auto [a, b] = random_pair(bits);
    const Overlap whole = convex_overlap(a, b, buffer);
    const Vec2 d = random_direction(bits), at(random_between(bits, -0.3, 0.3), random_between(bits, -0.3, 0.3));
    const Polygon left = left_part(b, at, d), right = left_part(b, at, -d);
    double area = 0;
    Vec2 first = Vec2::Zero();
    for (const Polygon& half : {left, right}) {
      if (half.size() < 3) continue;
      const Overlap part = convex_overlap(a, half, buffer);
      area += part.area;
      first += part.area * part.centroid;
    }
    CHECK(std::abs(area - whole.area) < 1e-13);
    CHECK((first - whole.area * whole.centroid).norm() < 1e-12);
  }
}

TEST_CASE("penetration of boxes is the least translation that separates them") {
  const Penetration deep = penetration(box(0, 0, 2, 1), box(0.5, 0.9, 3, 2));
  CHECK(near(deep.separation, -0.1, 1e-14));
  CHECK(deep.axis == Vec2(0, 1));
  CHECK(deep.face_of_a);
  CHECK(deep.face == 2);
  const Penetration gap = penetration(box(0, 0, 2, 1), box(2.25, 0.5, 1, 3));
  CHECK(gap.separation == 0.25);
  CHECK(gap.axis == Vec2(1, 0));
}

TEST_CASE("the sign of the penetration agrees with overlap, and its translation separates the polygons") {
  std::mt19937_64 bits(8);
  OverlapBuffer buffer;
  for (int trial = 0; trial < 5000; ++trial) {
    const auto [a, b] = random_pair(bits);
    const Penetration found = penetration(a, b), back = penetration(b, a);
    CHECK(std::abs(found.separation - back.separation) < 1e-14);
    CHECK(std::abs(found.axis.norm() - 1) < 1e-14);
    const double area = convex_overlap(a, b, buffer).area;
    if (found.separation > 1e-12) CHECK(area == 0);
    if (found.separation < -1e-6) CHECK(area > 0);
    const Vec2 d = random_direction(bits), s(random_between(bits, -9, 9), random_between(bits, -9, 9));
    CHECK(std::abs(penetration(placed(a, d, s), placed(b, d, s)).separation - found.separation) < 1e-13);
    if (found.separation >= 0) continue;
    const Polygon parted = placed(b, Vec2(1, 0), -(found.separation - 1e-9) * found.axis);
    CHECK(convex_overlap(a, parted, buffer).area == 0);
    const Polygon still = placed(b, Vec2(1, 0), -found.separation * 0.99 * found.axis);
    CHECK(penetration(a, still).separation < 1e-15);
  }
}

TEST_CASE("a point is inside, outside or at its distance from the boundary") {
  const Polygon ell{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 4}};
  CHECK(contains(ell, {0.5, 3}));
  CHECK(contains(ell, {2, 0.5}));
  CHECK_FALSE(contains(ell, {2, 2}));
  CHECK_FALSE(contains(ell, {-1, 1}));  // its ray passes through corners and along an edge
  CHECK_FALSE(contains(ell, {-1, 0}));
  CHECK(boundary_point(ell, {2, 2}).distance == 1);
  CHECK(boundary_point(ell, {2, 2}).edge == 2);
  CHECK(boundary_point(ell, {4, 5}).at == Vec2(1, 4));
  CHECK(boundary_point(ell, {1, 1}).distance == 0);
}

TEST_CASE("for convex polygons inside means left of every edge, and the distance belongs to the nearest edge") {
  std::mt19937_64 bits(9);
  for (int trial = 0; trial < 5000; ++trial) {
    const Polygon a = random_convex(bits, {.slenderest = 5});
    const Vec2 p(random_between(bits, -1, 1), random_between(bits, -1, 1));
    double least = 1e300;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const Vec2 along = a[(i + 1) % a.size()] - a[i];
      least = std::min(least, cross(along, p - a[i]) / along.norm());
    }
    CHECK(contains(a, p) == (least > 0));
    const BoundaryPoint nearest = boundary_point(a, p);
    if (least > 0) CHECK(near(nearest.distance, least, 1e-12));
    if (least < 0) CHECK(nearest.distance >= -least * (1 - 1e-12));
  }
}

TEST_CASE("random convex polygons are convex, centred at the origin and as specified") {
  std::mt19937_64 bits(10);
  for (int trial = 0; trial < 5000; ++trial) {
    const Polygon a = random_convex(bits, {.smallest = 0.2, .largest = 3, .slenderest = 10});
    CHECK(a.size() >= 3);
    CHECK(a.size() <= 10);
    CHECK(is_convex(a));
    CHECK(polygon_moments(a).centroid.norm() < 1e-14);
    CHECK(polygon_size(a) < 3 * std::sqrt(2.0));
    CHECK(signed_area(a) > 0);
  }
}

TEST_CASE("a seed gives the same polygon everywhere") {
  std::mt19937_64 bits(42);
  const Polygon a = random_convex(bits);
  CHECK(a.size() == 9);
  CHECK(a[0].x() == 0x1.2436d27464d44p-1);
  CHECK(a[0].y() == -0x1.daf842d19712dp-2);
}
