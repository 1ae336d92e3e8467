#include "geometry/space/convex_hull.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/rotation_3d.hpp"
#include "geometry/space/random_convex_3d.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;
using testing::near_zero;

namespace {

/// Largest distance of one of `points` outside of `solid` [m].
double outside_of(const Polyhedron& solid, const std::vector<Vec3>& points) {
  double most = -1e9;
  const auto normals = face_normals(solid);
  for (int f = 0; f < solid.faces.count(); ++f)
    for (const Vec3& p : points)
      most = std::max(most, normals[static_cast<std::size_t>(f)].dot(
                                p - solid.corners[static_cast<std::size_t>(solid.faces[f][0])]));
  return most;
}

std::vector<Vec3> grid_points(int n) {
  std::vector<Vec3> points;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k <= n; ++k) points.emplace_back(3.0 * i / n, 2.0 * j / n, 1.0 * k / n);
  return points;
}

}  // namespace

TEST_CASE("the hull of a grid of points is the box around it, for any rotation") {
  std::mt19937_64 bits(1);
  for (int trial = 0; trial < 20; ++trial) {
    const Turn3 turn(trial == 0 ? UnitQuaternion{} : random_rotation(bits));
    std::vector<Vec3> points = grid_points(3);
    for (Vec3& p : points) p = turn.apply(p);
    const Polyhedron box = convex_hull(points, "body");
    CHECK(box.corners.size() == 8);
    CHECK(box.faces.count() == 6);
    CHECK(near(solid_moments(box).volume, 6, 1e-13));
  }
}

TEST_CASE("a hull holds all points, is convex and does not depend on their order") {
  std::mt19937_64 bits(2);
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Vec3> points;
    const int count = random_count(bits, 4, 60);
    for (int i = 0; i < count; ++i) points.push_back(random_in_ball(bits));
    const Polyhedron hull = convex_hull(points, "body");
    CHECK_NOTHROW(check_convex(hull, "hull"));
    CHECK(near_zero(std::max(outside_of(hull, points), 0.0), 5e-9));
    const auto edges = static_cast<int>(solid_edges(hull.faces).size());
    CHECK(static_cast<int>(hull.corners.size()) - edges + hull.faces.count() == 2);
    std::reverse(points.begin(), points.end());
    CHECK(near(solid_moments(convex_hull(points, "body")).volume, solid_moments(hull).volume, 1e-9));
  }
}

TEST_CASE("the plane faces of a voussoir are recovered from corners rounded to six digits") {
  const std::vector<Vec3> voussoir{Vec3(0.94, 0.0, 0.0),          Vec3(0.868447, 0.359722, 0.0),
                                   Vec3(0.925719, 0.0, 0.163229), Vec3(0.855253, 0.354257, 0.163229),
                                   Vec3(1.06, 0.0, 0.0),          Vec3(0.979312, 0.405644, 0.0),
                                   Vec3(1.043896, 0.0, 0.184067), Vec3(0.964434, 0.399482, 0.184067)};
  const Polyhedron stone = convex_hull(voussoir, "stone", 1e-5);
  CHECK(stone.corners.size() == 8);
  CHECK(stone.faces.count() == 6);
  // by the exact numbers its faces are folded by less than 0.001 mm
  CHECK(convex_hull(voussoir, "stone").faces.count() > 6);
}

TEST_CASE("random polyhedra of ten corners have consistent masses") {
  const std::vector<Vec3> first{
      Vec3(-0.618743972, -0.628571193, -0.991817333), Vec3(-0.900898195, -0.86144908, -0.678165468),
      Vec3(-0.572533739, -0.525906545, -0.458041237), Vec3(-0.989363566, -0.727111837, -0.706525302),
      Vec3(-0.641687456, -0.925302852, -0.646398875), Vec3(-0.70768007, -0.75465583, -0.980146354),
      Vec3(-0.605551434, -0.588690687, -0.424573324), Vec3(-0.969651785, -0.569463298, -0.584294787),
      Vec3(-0.419051374, -0.711219999, -0.766168836), Vec3(-0.421327635, -0.723550584, -0.760383764)};
  const std::vector<Vec3> second{
      Vec3(-0.765349213, -0.413562933, 0.022418493),  Vec3(-0.829765594, -0.969775634, -0.023554843),
      Vec3(-0.511328353, -0.590346672, -0.184354081), Vec3(-0.775929178, -0.508428214, 0.234075281),
      Vec3(-0.744606353, -0.693683446, -0.273293914), Vec3(-0.940254266, -0.826093556, -0.102529482),
      Vec3(-0.581933268, -0.694277414, 0.299829789),  Vec3(-0.775877882, -0.469999627, 0.190316848),
      Vec3(-0.426691564, -0.783547274, -0.084855113), Vec3(-0.84408156, -0.964590785, 0.050560352)};
  CHECK(near(1000 * solid_moments(convex_hull(first, "first")).volume, 34.05050954535208, 1e-9));
  CHECK(near(1000 * solid_moments(convex_hull(second, "second")).volume, 39.88998968433255, 1e-9));
}

TEST_CASE("points that form no solid are rejected") {
  const auto complaint_about = [](const std::vector<Vec3>& points) -> std::string {
    try {
      convex_hull(points, "body 'x'");
    } catch (const InputError& e) {
      return e.what();
    }
    return {};
  };
  std::vector<Vec3> flat{Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(0, 1, 1)};
  CHECK(complaint_about(flat) == "body 'x': has 3 points, needs at least 4");
  flat.emplace_back(1, 1, 1);
  CHECK(complaint_about(flat) == "body 'x': all its points lie in one plane; give points on both sides of it");
  flat.back() = Vec3(1, 1, std::nan(""));
  CHECK(complaint_about(flat) == "body 'x': point 4 is (1, 1, nan) m, must be finite and within 1e12 m");
  flat.back() = Vec3(1, 1, 1 + 1e-10);
  CHECK(complaint_about(flat).find("in one plane") != std::string::npos);
  flat.back() = Vec3(1, 1, 1 + 1e-8);
  CHECK(complaint_about(flat).find("too small for") != std::string::npos);
  flat.back() = Vec3(1, 1, 1 + 1e-6);
  CHECK(complaint_about(flat).empty());
  CHECK(complaint_about(std::vector<Vec3>(5, Vec3(1, 2, 3))).find("in one plane") != std::string::npos);
  std::mt19937_64 bits(3);
  std::vector<Vec3> ball;
  for (int i = 0; i < 20000; ++i) ball.push_back(random_in_ball(bits).normalized());
  CHECK(complaint_about(ball) ==
        "body 'x': the hull of its 20000 points has more than 5000 faces; give fewer points of its surface, at most a "
        "few hundred");
}

TEST_CASE("random solids are convex, have their centroid at the origin and are the same for the same seed") {
  std::mt19937_64 bits(7), again(7);
  for (int trial = 0; trial < 100; ++trial) {
    const Polyhedron solid = random_convex_solid(bits, {.slenderest = 4}), prism = random_prism(bits, 0.3, 1);
    CHECK_NOTHROW(check_convex(solid, "solid"));
    CHECK_NOTHROW(check_convex(prism, "prism"));
    CHECK(near_zero(solid_moments(solid).centroid.norm(), 1e-14));
    CHECK(near_zero(solid_moments(prism).centroid.norm(), 1e-14));
    const Polyhedron same = random_convex_solid(again, {.slenderest = 4});
    CHECK(same.corners == solid.corners);
    random_prism(again, 0.3, 1);
  }
}

TEST_CASE("random rotations have no preferred direction") {
  std::mt19937_64 bits(9);
  Vec3 mean = Vec3::Zero();
  for (int i = 0; i < 10000; ++i) mean += Turn3(random_rotation(bits)).apply(Vec3(1, 0, 0)) / 10000;
  // each component has a variance of 1/3
  CHECK(near_zero(mean.norm(), 4 * 0.01));
}
