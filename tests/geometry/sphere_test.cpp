#include "geometry/space/sphere.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "base/error.hpp"
#include "base/rotation_3d.hpp"
#include "geometry/space/polyhedron.hpp"
#include "geometry/space/random_convex_3d.hpp"
#include "near.hpp"

using namespace trilith;
using trilith::testing::near;

namespace {

double ball(double radius) {
  return 4.0 / 3 * std::numbers::pi * radius * radius * radius;
}

/// Integrals over two spheres on the x axis at 0 and `apart`, with discs as sections: polynomials on either side of the
/// plane of intersection. Simpson's rule with few strips is exact for them except for rounding.
struct Revolved {
  double volume = 0, first = 0, along = 0, across = 0;
  Revolved(double r, double s, double apart) {
    const double plane = 0.5 * (apart + (r * r - s * s) / apart);
    add(-r, plane, 0, r), add(plane, apart + s, apart, s);
  }
  void add(double from, double to, double centre, double radius) {
    constexpr int strips = 200;
    const double step = (to - from) / strips;
    for (int i = 0; i <= strips; ++i) {
      const double x = from + i * step, weight = step / 3 * (i == 0 || i == strips ? 1 : i % 2 == 1 ? 4 : 2);
      const double square = radius * radius - (x - centre) * (x - centre);
      volume += weight * std::numbers::pi * square, first += weight * std::numbers::pi * square * x;
      along += weight * std::numbers::pi * square * x * x;
      across += weight * std::numbers::pi / 4 * square * square;
    }
  }
};

}  // namespace

TEST_CASE("a sphere has the volume and the inertia of one") {
  const std::array one{Sphere{Vec3(1, 2, 3), 0.5}};
  const SolidMoments m = sphere_moments(one);
  CHECK(near(m.volume, ball(0.5), 1e-15));
  CHECK((m.centroid - one[0].centre).norm() == 0);
  for (int k = 0; k < 3; ++k) CHECK(near(m.inertia(k, k), 0.4 * ball(0.5) * 0.25, 1e-14));
  CHECK(std::abs(m.inertia(0, 1)) < 1e-16);
}

TEST_CASE("the overlap of two spheres counts once, in any position") {
  std::mt19937_64 bits(7);
  for (int i = 0; i < 20; ++i) {
    const double r = random_between(bits, 0.5, 1), s = random_between(bits, 0.5, 1),
                 apart = random_between(bits, std::abs(r - s) + 0.05, r + s);
    const Turn3 turn = turn_of(random_rotation(bits));
    const Vec3 at(3, -2, 5);
    const std::array two{Sphere{at, r}, Sphere{at + apart * turn.x(), s}};
    const SolidMoments m = sphere_moments(two);
    const Revolved exact(r, s, apart);
    CHECK(near(m.volume, exact.volume, 1e-8));
    const double middle = exact.first / exact.volume;
    CHECK((m.centroid - at - middle * turn.x()).norm() < 1e-8);
    const double along = exact.along - exact.volume * middle * middle;
    CHECK(near(turn.x().dot(m.inertia * turn.x()), 2 * exact.across, 1e-8));
    CHECK(near(turn.y().dot(m.inertia * turn.y()), along + exact.across, 1e-8));
    CHECK(std::abs(turn.x().dot(m.inertia * turn.z())) < 1e-8);
  }
}

TEST_CASE("masses of disjoint spheres add up, and a sphere inside another adds nothing") {
  const std::array apart{Sphere{Vec3(0, 0, 0), 1}, Sphere{Vec3(3, 0, 0), 1}};
  const SolidMoments m = sphere_moments(apart);
  CHECK(near(m.volume, 2 * ball(1), 1e-15));
  CHECK(near(m.inertia(1, 1), 2 * ball(1) * (0.4 + 1.5 * 1.5), 1e-14));
  const std::array within{Sphere{Vec3(0, 0, 0), 1}, Sphere{Vec3(0.2, 0.1, 0.1), 0.5}};
  CHECK(near(sphere_moments(within).volume, ball(1), 1e-9));
}

TEST_CASE("moments of clumps rotate with them, to 1e-6") {
  std::mt19937_64 bits(11);
  for (int i = 0; i < 5; ++i) {
    std::vector<Sphere> clump{{Vec3::Zero(), 1}};
    for (int k = 0; k < 4; ++k) clump.push_back({random_in_ball(bits), random_between(bits, 0.4, 0.9)});
    const SolidMoments still = sphere_moments(clump);
    const Turn3 turn = turn_of(random_rotation(bits));
    for (Sphere& s : clump) s.centre = turn.apply(s.centre);
    const SolidMoments turned = sphere_moments(clump);
    CHECK(near(turned.volume, still.volume, 1e-6));
    CHECK((turned.centroid - turn.apply(still.centroid)).norm() < 1e-6);
    CHECK(near(turned.inertia.trace(), still.inertia.trace(), 2e-6));
    // Counts the points of a fine lattice inside any sphere.
    const int n = 60;
    int inside = 0;
    for (int p = 0; p < n * n * n; ++p) {
      const Vec3 x = 2 * (Vec3(p % n, p / n % n, p / (n * n)) + Vec3::Constant(0.5)) * 2 / n - Vec3::Constant(2);
      bool in = false;
      for (const Sphere& s : clump) in = in || (x - s.centre).squaredNorm() < s.radius * s.radius;
      inside += in ? 1 : 0;
    }
    CHECK(near(inside * std::pow(4.0 / n, 3), still.volume, 0.01));
  }
}

TEST_CASE("a sphere without radius or place is rejected with a valid example") {
  CHECK_THROWS_WITH_AS(check_sphere({Vec3::Zero(), 0}, "body 'ball'"),
                       "body 'ball': radius is 0 m, must be above 0; try 0.05", InputError);
  CHECK_THROWS_WITH_AS(check_sphere({Vec3(NAN, 0, 0), 1}, "body 'ball'"),
                       "body 'ball': centre (nan, 0, 0) is not finite or beyond 1e12 m", InputError);
}
