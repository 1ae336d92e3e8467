#include "contact/space/sphere_contact.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "geometry/space/random_convex_3d.hpp"
#include "geometry/space/sphere_distance.hpp"
#include "near.hpp"

using namespace trilith;
using trilith::testing::near;

namespace {

ContactLaw sphere_law(double mu = 0, double beta = 0) {
  Frictional law;
  law.kn = 1e6, law.ks = 5e5, law.mu = mu, law.beta = beta;
  return law;
}
ContactLaw power_law() {
  Power law;
  law.kn = 1e6, law.depth = 0.01, law.exponent = 1.5;
  return law;
}

struct Placed {
  ConvexSolid solid;
  PlacedSolid placed;
  Sphere sphere;
  Vec3 origin = Vec3::Zero(), velocity = Vec3::Zero(), spin = Vec3::Zero();

  explicit Placed(ConvexSolid of, const UnitQuaternion& turn = {}, const Vec3& at = Vec3::Zero())
      : solid(std::move(of)) {
    put(turn, at);
  }
  Placed(const Placed&) = delete;
  void put(const UnitQuaternion& turn, const Vec3& at) {
    place(solid, turn_of(turn), at, placed);
    sphere = {placed.corners[0], solid.radius};
    origin = at;
  }
  [[nodiscard]] SphereSide side() const { return {sphere, placed, origin, velocity, spin}; }
};

SolidResponse response(const Placed& a, const Placed& b, const ContactLaw& law, const SolidMemory& before = {},
                       double dt = 0) {
  double apart = 0;
  return respond_spheres(a.side(), b.side(), before, {law, 1, dt}, apart);
}

double energy(const Placed& a, const Placed& b, const ContactLaw& law) {
  return sphere_energy(a.placed, b.placed, {law, 1, 0});
}

}  // namespace

TEST_CASE("two spheres press each other by the stiffness times the volume they share") {
  const Placed a(convex_sphere({Vec3::Zero(), 0.3})), b(convex_sphere({Vec3::Zero(), 0.2}), {}, Vec3(0, 0, 0.48));
  const SolidResponse r = response(a, b, sphere_law());
  const double d = 0.48, e = 0.02, sum = 0.5, difference = 0.1;
  const double lens = std::numbers::pi * e * e * (d * d + 2 * d * sum - 3 * difference * difference) / (12 * d);
  CHECK(r.touching);
  CHECK(near(r.force.z(), 1e6 * lens, 1e-12));
  CHECK(std::abs(r.force.x()) + std::abs(r.force.y()) == 0);
  CHECK(near(r.depth, e, 1e-12));
  // Small penetration: kn pi R e^2 with 1/R the sum of the curvatures.
  const Placed near_b(convex_sphere({Vec3::Zero(), 0.2}), {}, Vec3(0, 0, 0.4999));
  CHECK(near(response(a, near_b, sphere_law()).force.z(), 1e6 * std::numbers::pi * 0.12 * 1e-8, 2e-3));
}

TEST_CASE("the force between spheres is the gradient of their energy") {
  for (const ContactLaw& law : {sphere_law(), power_law()})
    for (const double apart : {0.499, 0.47, 0.4, 0.25}) {
      const Placed a(convex_sphere({Vec3::Zero(), 0.3}));
      const double step = 1e-5;
      const Vec3 way = Vec3(1, 2, 2) / 3;
      const Placed b(convex_sphere({Vec3::Zero(), 0.2}), {}, apart * way),
          up(convex_sphere({Vec3::Zero(), 0.2}), {}, (apart + step) * way),
          down(convex_sphere({Vec3::Zero(), 0.2}), {}, (apart - step) * way);
      const double slope = (energy(a, down, law) - energy(a, up, law)) / (2 * step);
      CHECK(near(response(a, b, law).force.dot(way), slope, 1e-4));
    }
}

TEST_CASE("on a plane a sphere of radius R is pressed by kn pi e^2 (3R - 2e) / 3") {
  const Placed floor(convex_solid(box_solid(Vec3(-1, -1, -1), Vec3(1, 1, 0)), "floor")),
      ball(convex_sphere({Vec3::Zero(), 0.1}), {}, Vec3(0.2, 0.1, 0.095));
  const SolidResponse r = response(floor, ball, sphere_law());
  CHECK(near(r.force.z(), 1e6 * std::numbers::pi * 25e-6 * (0.3 - 0.01) / 3, 1e-9));
  CHECK(near(r.area, std::numbers::pi * (0.01 - 0.095 * 0.095), 1e-12));
  CHECK((r.middle - Vec3(0.2, 0.1, 0)).norm() < 1e-12);
  CHECK(near(r.depth, 0.005, 1e-9));
}

TEST_CASE("over faces, edges and corners the force of a polyhedron on a sphere is the gradient of their energy") {
  std::mt19937_64 bits(5);
  int touched = 0;
  for (int i = 0; i < 600; ++i) {
    const ConvexSolid stone = convex_solid(random_convex_solid(bits), "stone");
    const UnitQuaternion turn = random_rotation(bits);
    const Vec3 at = 1.3 * random_in_ball(bits);
    const double radius = random_between(bits, 0.2, 0.6);
    const Placed a(stone, turn, Vec3::Zero());
    Placed b(convex_sphere({Vec3::Zero(), radius}), {}, at);
    const double depth = -sphere_distance(a.placed, b.placed);
    if (depth < 0.02 * radius || depth > 0.2 * radius) continue;
    for (const ContactLaw& law : {sphere_law(), power_law()}) {
      b.put({}, at);
      const SolidResponse r = response(a, b, law);
      Vec3 slope;
      const double step = 1e-5;
      for (int k = 0; k < 3; ++k) {
        b.put({}, at + step * Vec3::Unit(k));
        const double up = energy(a, b, law);
        b.put({}, at - step * Vec3::Unit(k));
        slope[k] = (energy(a, b, law) - up) / (2 * step);
      }
      CHECK((r.force - slope).norm() < 2e-3 * slope.norm());
      // The force passes through the centre of the sphere.
      CHECK(cross(Vec3(r.centre - at), r.force).norm() < 1e-9 * r.force.norm());
      ++touched;
    }
  }
  CHECK(touched > 60);
}

TEST_CASE("a sphere over the joint of two flush blocks is pressed as by one block") {
  const ContactLaw law = sphere_law();
  const Placed whole(convex_solid(box_solid(Vec3(-1, -1, -1), Vec3(1, 1, 0)), "whole")),
      left(convex_solid(box_solid(Vec3(-1, -1, -1), Vec3(0, 1, 0)), "left")),
      right(convex_solid(box_solid(Vec3(0, -1, -1), Vec3(1, 1, 0)), "right"));
  for (const double x : {-0.02, -0.01, -0.003, 0.0, 0.001, 0.008, 0.03}) {
    const Placed ball(convex_sphere({Vec3::Zero(), 0.1}), {}, Vec3(x, 0.2, 0.097));
    const Vec3 one = response(whole, ball, law).force,
               two = response(left, ball, law).force + response(right, ball, law).force;
    CHECK((one - two).norm() < 1e-9 * one.norm());
  }
}

TEST_CASE("damping increases the pressure of closing spheres and never pulls separating ones") {
  const ContactLaw law = sphere_law(0, 1e-3);
  const Placed a(convex_sphere({Vec3::Zero(), 0.3}));
  Placed b(convex_sphere({Vec3::Zero(), 0.3}), {}, Vec3(0, 0, 0.59));
  const double still = response(a, b, law).force.z();
  b.velocity = Vec3(0, 0, -2);
  const SolidResponse closing = response(a, b, law);
  CHECK(near(closing.force.z(), still + 1e6 * 1e-3 * 2 * closing.area, 1e-12));
  b.velocity = Vec3(0, 0, 2);
  const SolidResponse parting = response(a, b, law);
  CHECK(parting.force.z() > 0);
  CHECK(parting.force.z() < still);
  b.velocity = Vec3(0, 0, 20);
  CHECK(response(a, b, law).force.z() == 0);
}

TEST_CASE("friction of spheres ends exactly at its limit and rotates with the pair") {
  const ContactLaw law = sphere_law(0.4);
  const Placed floor(convex_solid(box_solid(Vec3(-1, -1, -1), Vec3(1, 1, 0)), "floor"));
  Placed ball(convex_sphere({Vec3::Zero(), 0.1}), {}, Vec3(0, 0, 0.098));
  SolidMemory memory = response(floor, ball, law).memory;
  ball.velocity = Vec3(1, 0, 0);
  for (int i = 0; i < 50; ++i) memory = response(floor, ball, law, memory, 1e-4).memory;
  SolidResponse r = response(floor, ball, law, memory, 1e-4);
  CHECK(near(r.force.x(), -0.4 * r.force.z(), 1e-12));
  // The spring rotates about the normal with the mean of both spins: here by a tenth.
  ball.velocity = Vec3::Zero(), ball.spin = Vec3(0, 0, 2000);
  r = response(floor, ball, sphere_law(1e9), memory, 1e-4);
  r.memory.shear.elastic.z() = 0;  // torsion by the rotation itself
  CHECK(r.memory.shear.elastic.normalized().dot(Vec3(std::cos(0.1), std::sin(0.1), 0)) > 1 - 1e-6);
  // Pure rotation carries mu N 8/15 of the radius of the area.
  SolidMemory spun = response(floor, ball, law).memory;
  ball.spin = Vec3(0, 0, 50);
  for (int i = 0; i < 100; ++i) spun = response(floor, ball, law, spun, 1e-3).memory;
  r = response(floor, ball, law, spun, 1e-3);
  const double rim = std::sqrt(0.01 - 0.098 * 0.098);
  CHECK(near(r.moment.z(), -0.4 * r.force.z() * 8.0 / 15 * rim, 1e-9));
}

TEST_CASE("distance of a sphere from a block") {
  const Placed floor(convex_solid(box_solid(Vec3(-1, -1, -1), Vec3(1, 1, 0)), "floor"));
  const auto distance = [&](const Vec3& at) {
    const Placed ball(convex_sphere({Vec3::Zero(), 0.1}), {}, at);
    return sphere_distance(floor.placed, ball.placed);
  };
  CHECK(near(distance(Vec3(0, 0, 0.3)), 0.2, 1e-12));
  CHECK(near(distance(Vec3(0, 0, -0.02)), -0.12, 1e-12));
  CHECK(near(distance(Vec3(1.3, 0, 0.4)), 0.4, 1e-12));
  CHECK(near(distance(Vec3(1.2, 1.2, 0.1)), 0.2, 1e-12));
}
