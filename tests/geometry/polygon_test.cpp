#include "geometry/plane/polygon.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.hpp"
#include "geometry/plane/random_convex.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;

namespace {

std::string refusal(Polygon points) {
  try {
    check_polygon(std::move(points), "body 'stone'");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

bool mentions(const std::string& message, std::string_view part) {
  return message.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("moments of a rectangle are exact wherever it stands") {
  for (const Vec2& at : {Vec2(0, 0), Vec2(-7, 3), Vec2(1024, -4096)}) {
    const Polygon box{at, at + Vec2(2, 0), at + Vec2(2, 0.5), at + Vec2(0, 0.5)};
    const PolygonMoments m = polygon_moments(box);
    CHECK(m.area == 1);
    CHECK(m.centroid == at + Vec2(1, 0.25));
    CHECK(near(m.second_moment, 1.0 * (4 + 0.25) / 12, 1e-14));
    CHECK(perimeter(box) == 5);
    CHECK(orientation(box) == 1);
    CHECK(is_convex(box));
  }
}

TEST_CASE("the second moment of a right triangle and of a fine circle agree with their closed forms") {
  const double b = 3, h = 2;
  const PolygonMoments triangle = polygon_moments(Polygon{{0, 0}, {b, 0}, {0, h}});
  CHECK(triangle.area == 3);
  CHECK(triangle.centroid.isApprox(Vec2(1, h / 3), 1e-15));
  CHECK(near(triangle.second_moment, b * h * (b * b + h * h) / 36, 1e-14));
  Polygon circle;
  const int n = 2000;
  for (int i = 0; i < n; ++i)
    circle.emplace_back(5 + std::cos(2 * std::numbers::pi * i / n), 7 + std::sin(2 * std::numbers::pi * i / n));
  CHECK(near(polygon_moments(circle).second_moment, std::numbers::pi / 2, 1e-5));
  CHECK(is_convex(circle));
}

TEST_CASE("moments of an L add up from its two rectangles") {
  const Polygon ell{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 4}};
  const PolygonMoments m = polygon_moments(ell);
  CHECK(m.area == 6);
  CHECK(m.centroid.isApprox((3 * Vec2(1.5, 0.5) + 3 * Vec2(0.5, 2.5)) / 6, 1e-15));
  const double parts = 3.0 * (9 + 1) / 12 * 2 + 3 * (m.centroid - Vec2(1.5, 0.5)).squaredNorm() +
                       3 * (m.centroid - Vec2(0.5, 2.5)).squaredNorm();
  CHECK(near(m.second_moment, parts, 1e-14));
  CHECK_FALSE(is_convex(ell));
}

TEST_CASE("moments follow a rotation and a translation, and change sign with the order of the points") {
  std::mt19937_64 bits(11);
  for (int trial = 0; trial < 500; ++trial) {
    const Polygon shape = random_convex(bits, {.slenderest = 20});
    const PolygonMoments m = polygon_moments(shape);
    const Vec2 direction = random_direction(bits), shift(random_between(bits, -9, 9), random_between(bits, -9, 9));
    Polygon moved = placed(shape, direction, shift);
    const PolygonMoments n = polygon_moments(moved);
    CHECK(near(n.area, m.area, 1e-12));
    CHECK(near(n.second_moment, m.second_moment, 1e-11));
    CHECK((n.centroid - shift - m.centroid.x() * direction - m.centroid.y() * left_of(direction)).norm() < 1e-13);
    std::reverse(moved.begin(), moved.end());
    CHECK(near(polygon_moments(moved).area, -m.area, 1e-12));
    CHECK(orientation(moved) == -1);
  }
}

TEST_CASE("collinear corners leave a polygon convex, a star that goes round twice is not convex") {
  CHECK(is_convex(Polygon{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}, {0, 1}}));
  Polygon star;
  for (int i = 0; i < 5; ++i)
    star.emplace_back(std::cos(4 * std::numbers::pi * i / 5), std::sin(4 * std::numbers::pi * i / 5));
  CHECK_FALSE(is_convex(star));
}

TEST_CASE("a good polygon passes the check unchanged and without notes") {
  const Polygon given{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}};
  const CheckedPolygon checked = check_polygon(given, "body 'stone'");
  CHECK(checked.outline == given);
  CHECK(checked.notes.empty());
}

TEST_CASE("a clockwise polygon is reversed with a note and keeps its first point") {
  const CheckedPolygon checked = check_polygon({{0, 0}, {0, 1}, {2, 1}, {2, 0}}, "body 'stone'");
  CHECK(checked.outline == Polygon{{0, 0}, {2, 0}, {2, 1}, {0, 1}});
  REQUIRE(checked.notes.size() == 1);
  CHECK(mentions(checked.notes[0], "body 'stone': outline was clockwise"));
}

TEST_CASE("repeated points are left out with a note, the closing one among them") {
  const CheckedPolygon checked =
      check_polygon({{0, 0}, {2, 0}, {2, 1e-13}, {2, 0}, {2, 1}, {0, 1}, {0, 0}}, "body 'stone'");
  CHECK(checked.outline == Polygon{{0, 0}, {2, 0}, {2, 1}, {0, 1}});
  REQUIRE(checked.notes.size() == 3);
  CHECK(mentions(checked.notes[0], "point 3 (2, 1e-13) repeats point 2"));
  CHECK(mentions(checked.notes[2], "point 7 (0, 0) repeats point 1"));
}

TEST_CASE("points that make no polygon are rejected with number and coordinates") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  CHECK(mentions(refusal({}), "0 different points, needs at least 3"));
  CHECK(mentions(refusal({{0, 0}, {1, 0}, {1, 0}, {0, 0}}), "2 different points"));
  CHECK(mentions(refusal({{0, 0}, {1, nan}, {1, 1}}), "body 'stone': point 2 (1, nan) is not finite"));
  CHECK(mentions(refusal({{0, 0}, {1, 0}, {inf, 1}}), "point 3 (inf, 1) is not finite"));
  CHECK(mentions(refusal({{0, 0}, {1, 0}, {1e300, 1}}), "point 3 (1e+300, 1) is farther out than"));
  CHECK(mentions(refusal({{0, 0}, {1, 1}, {3, 3}, {2, 2}}), "no area"));
  CHECK(mentions(refusal({{3, 3}, {3, 3}, {3, 3}}), "1 different point,"));
}

TEST_CASE("self-crossing, touching and spikes are rejected, naming edges and place") {
  const std::string bow = refusal({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  CHECK(mentions(bow, "at (1, 1)"));
  CHECK(mentions(bow, "from point 1 (0, 0) to point 2 (2, 2)"));
  CHECK(mentions(bow, "from point 3 (2, 0) to point 4 (0, 2)"));
  CHECK(mentions(refusal({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}), "touches itself at (1, 0)"));
  CHECK(mentions(refusal({{0, 0}, {4, 0}, {4, 1}, {2, 1}, {2, 3}, {2, 1}, {0, 1}}), "point 5 (2, 3), a spike"));
  CHECK(mentions(refusal({{0, 0}, {4, 0}, {2, 0}, {2, 2}, {0, 2}}), "point 2 (4, 0), a spike"));
  // the same corner with a small but nonzero angle
  CHECK(refusal({{0, 0}, {4, 0}, {2, 1e-6}, {2, 2}, {0, 2}}) == "accepted");
  CHECK(mentions(refusal({{0, 0}, {4, 0}, {2, 1e-10}, {2, 2}, {0, 2}}), "spike"));
}

TEST_CASE("a random list of points is either rejected with one line or comes back simple and counter-clockwise") {
  std::mt19937_64 bits(5);
  int accepted = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    Polygon points;
    const int count = random_count(bits, 0, 8);
    for (int i = 0; i < count; ++i)  // a coarse grid, so that coincidences and alignments are frequent
      points.emplace_back(random_count(bits, 0, 4), random_count(bits, 0, 4));
    try {
      const CheckedPolygon checked = check_polygon(points, "p");
      ++accepted;
      CHECK(orientation(checked.outline) == 1);
      CHECK_FALSE(find_self_crossing(checked.outline, 1e-12));
    } catch (const InputError& error) {
      CHECK(std::string(error.what()).find('\n') == std::string::npos);
    }
  }
  CHECK(accepted > 1000);
}
