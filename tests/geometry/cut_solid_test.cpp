#include "geometry/space/cut_solid.hpp"

#include <doctest/doctest.h>

#include <random>

#include "geometry/space/random_convex_3d.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

TEST_CASE("a cube cut through four corners keeps them to the bit") {
  const Polyhedron cube = box_solid({0, 0, 0}, {1, 1, 1});
  const auto half = cut_solid(cube, {Vec3(1, 1, 0).normalized(), std::sqrt(0.5)}, 1e-12);
  REQUIRE(half);
  CHECK(half->corners.size() == 6);
  CHECK(half->faces.count() == 5);
  CHECK(near(solid_moments(*half).volume, 0.5, 1e-15));
  check_convex(*half, "half");
}

TEST_CASE("a plane outside a solid does not change it, and one that cuts off all of it leaves an empty solid") {
  const Polyhedron cube = box_solid({0, 0, 0}, {1, 1, 1});
  CHECK(cut_solid(cube, {Vec3(0, 0, 1), 1}, 1e-12)->corners == cube.corners);
  CHECK(cut_solid(cube, {Vec3(0, 0, 1), 2}, 1e-12)->corners == cube.corners);
  CHECK_FALSE(cut_solid(cube, {Vec3(0, 0, 1), 0}, 1e-12));
  CHECK_FALSE(cut_solid(cube, {Vec3(0, 0, 1), -1}, 1e-12));
}

TEST_CASE("both sides of many random cuts make up the solid, closed and convex") {
  std::mt19937_64 bits(5);
  for (int i = 0; i < 300; ++i) {
    const Polyhedron solid = random_convex_solid(bits, {.slenderest = 5});
    const Vec3 normal = random_in_ball(bits).normalized();
    const double offset = random_between(bits, -0.3, 0.3);
    double volume = 0;
    for (const double sign : {1.0, -1.0})
      if (const auto part = cut_solid(solid, {sign * normal, sign * offset}, 1e-12)) {
        check_convex(*part, "part");
        volume += solid_moments(*part).volume;
      }
    CHECK(near(volume, solid_moments(solid).volume, 1e-12));
  }
}

TEST_CASE("corners off their planes are brought onto them") {
  std::mt19937_64 bits(7);
  for (int i = 0; i < 50; ++i) {
    Polyhedron solid = random_prism(bits, 0.5, 1);
    for (Vec3& p : solid.corners) p += 1e-6 * random_in_ball(bits);
    const PlanarSolid planar = with_plane_faces(solid);
    check_convex(planar.solid, "planar", 1e-12);
    CHECK(planar.solid.faces.count() == solid.faces.count());
    CHECK(planar.moved > 0);
    CHECK(planar.moved < 1e-4);
  }
}
