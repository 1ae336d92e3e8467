#include "contact/pressed_triangles.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "contact/solid_pressure.hpp"
#include "near.hpp"
#include "shape/random_convex_3d.hpp"

using namespace trilith;
using testing::near;

namespace {

struct Triangle {
  std::array<Vec3, 3> at;
  std::array<double, 3> depth, closing;
  double sign;
  TriangleShare share;

  explicit Triangle(std::mt19937_64& bits) {
    for (Vec3& x : at) x = random_in_ball(bits);
    for (double& d : depth) d = random_between(bits, 0, 1);
    for (double& c : closing) c = random_between(bits, -1, 1);
    sign = random_count(bits, 0, 1) == 0 ? -1 : 1;
    share = static_cast<TriangleShare>(random_count(bits, 0, 2));
  }
  [[nodiscard]] Vec3 twice() const { return cross(Vec3(at[1] - at[0]), Vec3(at[2] - at[0])); }
};

/// The sums by six points of each triangle, exact to degree 4 (Dunavant 1985): one triangle after the other.
PressedSums by_points(const std::vector<Triangle>& triangles, double beta) {
  PressedSums sums;
  const auto add = [&](const Triangle& t, double weight, const std::array<double, 3>& share) {
    const Vec3 n = t.sign * t.twice().normalized();
    const Vec3 x = share[0] * t.at[0] + share[1] * t.at[1] + share[2] * t.at[2];
    const double area = weight * 0.5 * t.twice().norm();
    const double depth = share[0] * t.depth[0] + share[1] * t.depth[1] + share[2] * t.depth[2];
    const double closing = share[0] * t.closing[0] + share[1] * t.closing[1] + share[2] * t.closing[2];
    const double springs = t.share == TriangleShare::damped ? 0 : area * depth;
    const double total = t.share == TriangleShare::springs ? 0 : area * (depth + beta * closing);
    sums.force += total * n, sums.moment += total * cross(x, n);
    sums.damping += (total - springs) * n, sums.damping_moment += (total - springs) * cross(x, n);
    sums.damped += (total - springs) * closing;
    sums.pressure += total, sums.arm += total * x;
    const double counted = t.share == TriangleShare::damped ? 0 : area;
    sums.area += counted, sums.area_arm += counted * x;
    const std::array<double, 6> products{x[0] * x[0], x[1] * x[1], x[2] * x[2], x[0] * x[1], x[1] * x[2], x[2] * x[0]};
    for (std::size_t k = 0; k < 6; ++k)
      sums.arm_second[k] += total * products[k], sums.area_second[k] += counted * products[k];
  };
  for (const Triangle& t : triangles)
    for (const auto& [own, other, weight] : {std::array{0.108103018168070, 0.445948490915965, 0.223381589678011},
                                             std::array{0.816847572980459, 0.091576213509771, 0.109951743655322}})
      for (const std::size_t i : {0U, 1U, 2U}) {
        std::array<double, 3> share{other, other, other};
        share[i] = own;
        add(t, weight, share);
      }
  return sums;
}

bool near_vectors(const Vec3& a, const Vec3& b, double of) {
  return (a - b).norm() <= 1e-12 * of;
}

}  // namespace

TEST_CASE("triangles by lanes sum up to what points of each give one after the other") {
  std::mt19937_64 bits(36);
  const double beta = 0.7;
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<Triangle> triangles;
    for (int n = random_count(bits, 0, 20); n >= 0; --n) triangles.emplace_back(bits);
    PressedTriangles lanes(beta);
    double whole = 0, deepest = 0;
    for (const Triangle& t : triangles) {
      lanes.add(t.twice().normalized(), t.sign, t.share,
                {TriangleCorner{t.at[0], t.depth[0], t.closing[0]}, TriangleCorner{t.at[1], t.depth[1], t.closing[1]},
                 TriangleCorner{t.at[2], t.depth[2], t.closing[2]}});
      whole += t.twice().norm();
      if (t.share == TriangleShare::damped) continue;
      for (const double d : t.depth) deepest = std::max(deepest, d);
    }
    const PressedSums got = lanes.sums(), expected = by_points(triangles, beta);
    CHECK(near_vectors(got.force, expected.force, whole));
    CHECK(near_vectors(got.moment, expected.moment, whole));
    CHECK(near_vectors(got.damping, expected.damping, whole));
    CHECK(near_vectors(got.damping_moment, expected.damping_moment, whole));
    CHECK(near_vectors(got.arm, expected.arm, whole));
    CHECK(near_vectors(got.area_arm, expected.area_arm, whole));
    CHECK(std::abs(got.damped - expected.damped) <= 1e-12 * whole);
    CHECK(std::abs(got.pressure - expected.pressure) <= 1e-12 * whole);
    CHECK(near(got.area, expected.area, 1e-12));
    for (std::size_t k = 0; k < 6; ++k) {
      CHECK(std::abs(got.arm_second[k] - expected.arm_second[k]) <= 1e-12 * whole);
      CHECK(std::abs(got.area_second[k] - expected.area_second[k]) <= 1e-12 * whole);
    }
    CHECK(got.depth == deepest);
  }
}

TEST_CASE("pressure by whole cells and lanes is that of points of one triangle after the other") {
  // A power law of exponent 1 presses as the linear one, but goes the long way.
  Frictional linear;
  linear.kn = 1e6;
  Power power;
  power.kn = 1e6, power.depth = 0.1, power.exponent = 1;
  const ContactLaw by_lanes = linear, by_points = power;
  std::mt19937_64 bits(37);
  SolidOverlapBuffer shared;
  int touching = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const auto chance = [&] {
      return convex_solid(
          random_count(bits, 0, 1) == 0 ? random_convex_solid(bits, {.slenderest = 2}) : random_prism(bits, 0.5, 1.5),
          "solid");
    };
    const ConvexSolid of_a = chance(), of_b = chance();
    PlacedSolid a, b;
    place(of_a, Turn3(random_rotation(bits)), Vec3::Zero(), a);
    place(of_b, Turn3(random_rotation(bits)), 1.2 * random_in_ball(bits), b);
    if (!(shared_volume(a, b, shared) > 1e-6)) continue;
    ++touching;
    const MovingSolid still_a{a, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()},
        still_b{b, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    const SolidPressure p = solid_pressure(still_a, still_b, {by_lanes}, shared),
                        q = solid_pressure(still_a, still_b, {by_points}, shared);
    CHECK((p.force - q.force).norm() <= 1e-9 * p.pressure);
    CHECK((p.moment - q.moment).norm() <= 1e-9 * p.pressure * p.radius);
    CHECK(near(p.pressure, q.pressure, 1e-9));
    CHECK((p.centre - q.centre).norm() <= 1e-9 * p.radius);
    CHECK((p.middle - q.middle).norm() <= 1e-9 * p.radius);
    CHECK(near(p.area, q.area, 1e-9));
    CHECK(near(p.radius, q.radius, 1e-9));
    CHECK(near(p.friction_arm, q.friction_arm, 1e-8));
    CHECK(near(p.depth, q.depth, 1e-9));
  }
  CHECK(touching > 1000);
}
