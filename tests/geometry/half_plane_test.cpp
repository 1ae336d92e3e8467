#include "geometry/plane/half_plane.hpp"

#include <doctest/doctest.h>

#include <random>

#include "geometry/plane/random_convex.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;

namespace {

double area_of(const std::vector<Polygon>& pieces) {
  double area = 0;
  for (const Polygon& piece : pieces) area += signed_area(piece);
  return area;
}

const Polygon comb{{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {3, 1}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};

}  // namespace

TEST_CASE("a line divides a comb into its teeth and its back") {
  const std::vector<Polygon> teeth = cut_by(comb, {{0, -1}, -2}, 1e-12), back = cut_by(comb, {{0, 1}, 2}, 1e-12);
  CHECK(teeth.size() == 3);
  for (const Polygon& tooth : teeth) CHECK(near(signed_area(tooth), 1, 1e-12));
  CHECK(back.size() == 1);
  CHECK(near(area_of(back), signed_area(comb) - 3, 1e-12));
}

TEST_CASE("a line through corners or along sides cuts cleanly") {
  CHECK(cut_by(comb, {{0, -1}, -1}, 1e-12).size() == 3);  // along the roots of the teeth
  CHECK(near(area_of(cut_by(comb, {{0, -1}, -1}, 1e-12)), 6, 1e-12));
  CHECK(cut_by(comb, {{0, 1}, 1}, 1e-12) == std::vector<Polygon>{{{0, 1}, {0, 0}, {5, 0}, {5, 1}}});
  CHECK(cut_by(comb, {{0, 1}, 3}, 1e-12) == std::vector<Polygon>{comb});
  CHECK(cut_by(comb, {{0, -1}, -3}, 1e-12).empty());  // three sides of no area
  CHECK(cut_by(comb, {{0, -1}, -4}, 1e-12).empty());
}

TEST_CASE("a half-plane is the same for a normal of any length") {
  for (const double length : {0.25, 1.0, 4.0}) {
    CAPTURE(length);
    CHECK(near(area_of(cut_by(comb, {{0, length}, length}, 1e-12)), 5, 1e-12));
    CHECK(near(area_of(cut_by(comb, {{0, -length}, -length}, 1e-12)), 6, 1e-12));
  }
}

TEST_CASE("the parts on both sides of any line have the area of the polygon") {
  std::mt19937_64 bits(7);
  for (int i = 0; i < 3000; ++i) {
    const Polygon outline = i % 2 == 0 ? random_convex(bits) : comb;
    const Vec2 normal = 2 * random_direction(bits);
    const double offset = normal.dot(Vec2(random_between(bits, 0, 5), random_between(bits, 0, 3)));
    const auto below = cut_by(outline, {normal, offset}, 1e-12), above = cut_by(outline, {-normal, -offset}, 1e-12);
    CHECK(near(area_of(below) + area_of(above), signed_area(outline), 1e-10));
    for (const auto& pieces : {below, above})
      for (const Polygon& piece : pieces) {
        CHECK(signed_area(piece) > 0);
        CHECK_FALSE(find_self_crossing(piece, 0));
      }
  }
}
