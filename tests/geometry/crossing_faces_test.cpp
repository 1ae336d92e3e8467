#include "geometry/space/crossing_faces.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "geometry/space/random_convex_3d.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Solid swept by an outline with any order of corners over a height of 1 m.
Polyhedron raised(const std::vector<Vec2>& outline) {
  const int n = static_cast<int>(outline.size());
  Polyhedron solid;
  for (const double z : {0.0, 1.0})
    for (const Vec2& p : outline) solid.corners.emplace_back(p.x(), p.y(), z);
  std::vector<int> foot, top;
  for (int i = 0; i < n; ++i) {
    foot.push_back(n - 1 - i), top.push_back(n + i);
    solid.faces.add(std::vector<int>{i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  solid.faces.add(foot), solid.faces.add(top);
  return solid;
}

/// A surface about the origin whose corner at (i, j) of `around` by `levels` is at the distance `reach(i, j)`.
template <class Reach>
Polyhedron star_shaped(int around, int levels, Reach&& reach) {
  Polyhedron solid;
  const auto corner = [&](int i, int j) { return 1 + (i - 1) * around + j % around; };
  solid.corners.emplace_back(0, 0, -reach(0, 0));
  for (int i = 1; i < levels; ++i)
    for (int j = 0; j < around; ++j) {
      const double level = std::numbers::pi * i / levels - std::numbers::pi / 2,
                   azimuth = 2 * std::numbers::pi * j / around;
      solid.corners.push_back(reach(i, j) * Vec3(std::cos(level) * std::cos(azimuth),
                                                 std::cos(level) * std::sin(azimuth), std::sin(level)));
    }
  const int top = static_cast<int>(solid.corners.size());
  solid.corners.emplace_back(0, 0, reach(levels, 0));
  for (int j = 0; j < around; ++j) {
    solid.faces.add(std::vector<int>{0, corner(1, j + 1), corner(1, j)});
    solid.faces.add(std::vector<int>{top, corner(levels - 1, j), corner(levels - 1, j + 1)});
    for (int i = 1; i + 1 < levels; ++i) {
      solid.faces.add(std::vector<int>{corner(i, j), corner(i, j + 1), corner(i + 1, j + 1)});
      solid.faces.add(std::vector<int>{corner(i, j), corner(i + 1, j + 1), corner(i + 1, j)});
    }
  }
  return solid;
}

}  // namespace

TEST_CASE("no face of a convex solid or of a valid hollow solid crosses another") {
  std::mt19937_64 bits(21);
  for (int i = 0; i < 100; ++i) CHECK(!crossing_faces(random_convex_solid(bits), 1e-9));
  CHECK(!crossing_faces(raised({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}), 1e-9));
  // seen from the middle its faces are side by side, however rugged it is
  const auto rugged = [&](int i, int j) { return 1 + 0.5 * std::sin(0.7 * i) * std::sin(1.3 * j); };
  CHECK(!crossing_faces(star_shaped(64, 32, rugged), 1e-9));
}

TEST_CASE("the outline of a bow tie and of a five-pointed star cross themselves") {
  const auto attachment = crossing_faces(raised({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), 1e-9);
  REQUIRE(attachment);
  CHECK(near(attachment->at.x(), 0.5, 1e-12));
  CHECK(near(attachment->at.y(), 0.5, 1e-12));
  std::vector<Vec2> star;
  for (int i = 0; i < 5; ++i)
    star.emplace_back(std::cos(0.8 * std::numbers::pi * i), std::sin(0.8 * std::numbers::pi * i));
  const auto points = crossing_faces(raised(star), 1e-9);
  REQUIRE(points);
  // the sides cross on a circle smaller by the square of the golden ratio
  CHECK(near(std::hypot(points->at.x(), points->at.y()), (3 - std::sqrt(5.0)) / 2, 1e-9));
}

TEST_CASE("two boxes of one surface cross where they overlap and not where they are apart") {
  const auto pair_at = [](double x) {
    Polyhedron both = box_solid({0, 0, 0}, {1, 1, 1});
    const Polyhedron other = box_solid({x, 0.3, 0.4}, {x + 1, 1.3, 1.4});
    for (const Vec3& p : other.corners) both.corners.push_back(p);
    for (int f = 0; f < other.faces.count(); ++f) {
      std::vector<int> loop;
      for (const int i : other.faces[f]) loop.push_back(i + 8);
      both.faces.add(loop);
    }
    return both;
  };
  CHECK(crossing_faces(pair_at(0.5), 1e-9));
  CHECK(crossing_faces(pair_at(0.999), 1e-9));
  CHECK(!crossing_faces(pair_at(1.001), 1e-9));
}
