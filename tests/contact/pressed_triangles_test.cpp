#include "contact/space/pressed_triangles.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "contact/space/solid_pressure.hpp"
#include "geometry/space/random_convex_3d.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;

namespace {

struct Corner {
  Vec3 at;
  double depth;
};

struct Triangle {
  std::array<Corner, 3> corner;
  double sign;

  explicit Triangle(std::mt19937_64& bits) {
    for (Corner& c : corner) c = {random_in_ball(bits), random_between(bits, 0, 1)};
    sign = random_count(bits, 0, 1) == 0 ? -1 : 1;
  }
  [[nodiscard]] Vec3 twice() const {
    return cross(Vec3(corner[1].at - corner[0].at), Vec3(corner[2].at - corner[0].at));
  }
  /// The force of its springs.
  [[nodiscard]] Vec3 push() const { return sign * (corner[0].depth + corner[1].depth + corner[2].depth) / 6 * twice(); }
};

Corner between(const Corner& p, const Corner& q, double share) {
  return {p.at + share * (q.at - p.at), p.depth + share * (q.depth - p.depth)};
}

/// Calls f(point, weight) at six points of a triangle, exact to degree 4 (Dunavant 1985).
template <class F>
void at_points(const Corner& p, const Corner& q, const Corner& r, F&& f) {
  const std::array<Corner, 3> of{p, q, r};
  const double area = 0.5 * cross(Vec3(q.at - p.at), Vec3(r.at - p.at)).norm();
  for (const auto& [own, other, weight] : {std::array{0.108103018168070, 0.445948490915965, 0.223381589678011},
                                           std::array{0.816847572980459, 0.091576213509771, 0.109951743655322}})
    for (const std::size_t i : {0U, 1U, 2U}) {
      const Corner &a = of[i], &b = of[(i + 1) % 3], &c = of[(i + 2) % 3];
      f(Corner{own * a.at + other * (b.at + c.at), own * a.depth + other * (b.depth + c.depth)}, weight * area);
    }
}

std::array<double, 6> products_of(const Vec3& x) {
  return {x[0] * x[0], x[1] * x[1], x[2] * x[2], x[0] * x[1], x[1] * x[2], x[2] * x[0]};
}

/// Sums over the points of each triangle, with damping where the pressure is above 0: one triangle after the other.
PressedSums by_points(const std::vector<Triangle>& triangles, double beta, const ClosingMotion& motion) {
  PressedSums sums;
  Vec3 push = Vec3::Zero();
  for (const Triangle& t : triangles) push += t.push();
  const Vec3 n = push.normalized();
  for (const Triangle& t : triangles) {
    const Vec3 u = t.sign * t.twice().normalized();
    const double facing = std::max(0.0, u.dot(n));
    const auto closing = [&](const Vec3& x) { return -facing * n.dot(motion.velocity + cross(motion.spin, x)); };
    const auto add = [&](const Corner& c, double springs, double total) {
      const Vec3 force = springs * u, damping = facing * (total - springs) * n;
      sums.force += force + damping, sums.moment += cross(c.at, Vec3(force + damping));
      sums.damping += damping, sums.damping_moment += cross(c.at, damping);
      sums.damped += (total - springs) * closing(c.at);
      sums.pressure += total, sums.arm += total * c.at;
      const std::array products = products_of(c.at);
      for (std::size_t k = 0; k < 6; ++k) sums.arm_second[k] += total * products[k];
    };
    at_points(t.corner[0], t.corner[1], t.corner[2], [&](const Corner& c, double area) {
      add(c, area * c.depth, 0);
      sums.area += area, sums.area_arm += area * c.at;
      const std::array products = products_of(c.at);
      for (std::size_t k = 0; k < 6; ++k) sums.area_second[k] += area * products[k];
    });
    // The part with positive damped pressure, as a polygon.
    std::vector<Corner> kept;
    for (std::size_t i = 0; i < 3; ++i) {
      const Corner &p = t.corner[i], &q = t.corner[(i + 1) % 3];
      const double hp = p.depth + beta * closing(p.at), hq = q.depth + beta * closing(q.at);
      if (hp >= 0) kept.push_back(p);
      if (hp * hq < 0) kept.push_back(between(p, q, hp / (hp - hq)));
    }
    for (std::size_t i = 2; i < kept.size(); ++i)
      at_points(kept[0], kept[i - 1], kept[i],
                [&](const Corner& c, double area) { add(c, 0, area * (c.depth + beta * closing(c.at))); });
  }
  return sums;
}

bool near_vectors(const Vec3& a, const Vec3& b, double of) {
  return (a - b).norm() <= 1e-11 * of;
}

}  // namespace

TEST_CASE("triangles by lanes have the sum of a sequential evaluation") {
  std::mt19937_64 bits(36);
  std::vector<FourTriangles> room;
  int in_part = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const double beta = random_between(bits, 0, 1);
    const ClosingMotion motion{random_in_ball(bits), random_in_ball(bits)};
    std::vector<Triangle> triangles;
    for (int n = random_count(bits, 0, 20); n >= 0; --n) triangles.emplace_back(bits);
    TriangleLanes lanes(room);
    double whole = 0, deepest = 0;
    for (const Triangle& t : triangles) {
      const Vec3 n = t.twice().normalized();
      const auto corner = [&](std::size_t k) {
        const Corner& c = t.corner[k];
        return Lanes{c.at.x(), c.at.y(), c.at.z(), c.depth};
      };
      lanes.add(Lanes{n.x(), n.y(), n.z(), t.sign}, corner(0), corner(1), corner(2));
      whole += t.twice().norm();
      for (const Corner& c : t.corner) deepest = std::max(deepest, c.depth);
    }
    const PressedSums got = pressed_triangles(lanes.all(), beta, motion), expected = by_points(triangles, beta, motion);
    CHECK(near_vectors(got.force, expected.force, whole));
    CHECK(near_vectors(got.moment, expected.moment, whole));
    CHECK(near_vectors(got.damping, expected.damping, whole));
    CHECK(near_vectors(got.damping_moment, expected.damping_moment, whole));
    CHECK(near_vectors(got.arm, expected.arm, whole));
    CHECK(near_vectors(got.area_arm, expected.area_arm, whole));
    CHECK(std::abs(got.damped - expected.damped) <= 1e-11 * whole);
    CHECK(std::abs(got.pressure - expected.pressure) <= 1e-11 * whole);
    CHECK(near(got.area, expected.area, 1e-12));
    for (std::size_t k = 0; k < 6; ++k) {
      CHECK(std::abs(got.arm_second[k] - expected.arm_second[k]) <= 1e-11 * whole);
      CHECK(std::abs(got.area_second[k] - expected.area_second[k]) <= 1e-11 * whole);
    }
    CHECK(got.depth == deepest);
    // Damping dissipates energy, and the total force is along the force of the springs.
    CHECK(got.damped >= 0);
    const Vec3 n = spring_force(lanes.all()).normalized();
    CHECK((got.force - got.force.dot(n) * n).norm() <= 1e-11 * whole);
    in_part += got.damped > 0 ? 1 : 0;
  }
  CHECK(in_part > 1000);
}

TEST_CASE("pressure by cells and lanes equals pressure point by point") {
  // A power law of exponent 1 equals the linear one, but uses the general method.
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
