#include "contact/joint/shear_3d.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "contact/joint/area_limit.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;
using testing::near_zero;

namespace {

/// Friction of `force` in the plane z = 0 whose centre of pressure is at `offset` from the spring.
FrictionLimit limit_at(double force, const Vec3& offset = Vec3::Zero(), double radius = 1, double arm = 1) {
  return {force, Vec3::UnitZ(), offset, radius, arm};
}

/// V / mu N and T / mu N a of a spring's force.
std::pair<double, double> shares(const FrictionLimit& limit, const Vec3& spring) {
  const Vec3 across(spring.x(), spring.y(), 0);
  const double couple = limit.radius * spring.z() - (limit.offset.x() * spring.y() - limit.offset.y() * spring.x());
  return {across.norm() / limit.force, std::abs(couple) / (limit.force * limit.arm)};
}
double measure(const FrictionLimit& limit, const Vec3& spring) {
  const auto [x, y] = shares(limit, spring);
  return limit_measure(x, y);
}

/// A random limit, and a force beyond it by up to `far` times itself.
struct LimitDraw {
  FrictionLimit limit;
  Vec3 beyond;
};
LimitDraw draw_limit(std::mt19937& random, double far) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> share(0, 1);
  const double radius = 0.2 + share(random);
  const FrictionLimit limit =
      limit_at(100, radius * Vec3(normal(random), normal(random), 0), radius, radius * std::exp(-4 * share(random)));
  Vec3 spring(normal(random), normal(random), normal(random));
  while (measure(limit, spring) <= 1) spring *= 1.1;
  return {limit, Vec3(spring * (1 + far * share(random)))};
}

}  // namespace

TEST_CASE("shear below its limit is elastic in any direction") {
  const SlidingLaw law{1e8, 0, 1e-3};
  SlidingForce force{Vec3::Zero(), Vec3::Zero(), 0.5};
  const Vec3 path(3e-6, -4e-6, 0);
  const SlidingResponse r = slide({path, path / law.dt, limit_at(1e9)}, 0.5, force, law);
  CHECK(near_zero((r.force.elastic - 5e7 * path).norm(), 1e-9));
  CHECK(r.slip == 0);
  CHECK(r.lost_friction == 0);
  CHECK(near(sliding_energy(law.ks, r.force), 0.5 * 5e7 * path.squaredNorm(), 1e-12));
}

TEST_CASE("beyond its limit shear slides with the limit force, against the motion") {
  const SlidingLaw law{1e8, 0, 1e-3};
  SlidingForce force{Vec3::Zero(), Vec3::Zero(), 0.5};
  const Vec3 way = Vec3(1, 2, 0).normalized() * 1e-5;
  double slip = 0, lost = 0;
  for (int i = 0; i < 200; ++i) {
    const SlidingResponse r = slide({way, way / law.dt, limit_at(100)}, 0.5, force, law);
    force = r.force, slip += r.slip, lost += r.lost_friction;
  }
  CHECK(near(force.total.norm(), 100, 1e-12));
  CHECK(near(force.total.dot(way) / way.norm(), 100, 1e-9));
  CHECK(near(slip, 200 * way.norm() - 100 / 5e7, 1e-9));
  CHECK(near(lost, 100 * slip, 1e-2));
}

TEST_CASE("work of shear is stored or dissipated, with damping and changing area") {
  const SlidingLaw law{1e8, 2e-4, 1e-3};
  SlidingForce force{Vec3::Zero(), Vec3::Zero(), 0.5};
  double put_in = 0, lost = 0;
  for (int i = 0; i < 500; ++i) {
    const double t = 0.02 * i;
    const Vec3 path = 1e-6 * Vec3(std::cos(t), std::sin(1.7 * t), 0.5 * std::cos(2.3 * t));
    const double area = 0.5 + 0.3 * std::sin(0.5 * t);
    const Vec3 before = force.total;
    const SlidingResponse r = slide({path, path / law.dt, limit_at(60)}, area, force, law);
    force = r.force;
    put_in += 0.5 * (before + force.total).dot(path);
    lost += r.lost_friction + r.lost_damping;
    CHECK(limit_measure(force.total.head<2>().norm() / 60, std::abs(force.total.z()) / 60) <= 1 + 1e-12);
  }
  CHECK(lost > 0);
  CHECK(near(put_in, lost + sliding_energy(law.ks, force), 1e-9));
}

TEST_CASE("the computed nearest point of the limit is the nearest one, for any pressure distribution") {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  for (const double far : {1e-6, 1e-2, 3.0})
    for (int i = 0; i < 300; ++i) {
      const auto [limit, beyond] = draw_limit(random, far);
      REQUIRE(limit.is_below(beyond));
      const Vec3 held = limit.nearest_to(beyond);
      CHECK(near(measure(limit, held), 1, 1e-12));
      const double least = (beyond - held).norm();
      for (int k = 0; k < 50; ++k) {
        // Other forces around it, scaled to the limit along their rays.
        Vec3 other = held + 30 * (k % 2 == 0 ? 1 : 0.01) * Vec3(normal(random), normal(random), normal(random));
        const auto [x, y] = shares(limit, other);
        other /= std::sqrt(limit_measure(x, y));
        CHECK((beyond - other).norm() >= least * (1 - 1e-9));
      }
    }
}

TEST_CASE("sliding creates no energy and dissipates the most that friction allows") {
  std::mt19937 random(12);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 20000; ++i) {
    const auto [limit, beyond] = draw_limit(random, i % 2 == 0 ? 1e-3 : 10);
    const Vec3 held = limit.nearest_to(beyond), slip = beyond - held;
    CHECK(held.dot(slip) > 0);
    const Vec3 other(normal(random), normal(random), normal(random)), inside = 40 * other;
    if (!limit.is_below(inside)) CHECK(held.dot(slip) >= inside.dot(slip) - 1e-9 * held.norm() * slip.norm());
  }
}

TEST_CASE("the projection onto the friction limit is unique for any friction and any distance") {
  std::mt19937 random(13);
  for (int i = 0; i < 300; ++i) {
    const auto [limit, beyond] = draw_limit(random, 3);
    const Vec3 far = limit.nearest_to(1e7 * beyond) / limit.force;
    for (const double held : {1e2, 1e-40, 1e-120, 1e-139}) {
      const FrictionLimit less = limit_at(held, limit.offset, limit.radius, limit.arm);
      const Vec3 force = 1e12 * beyond;
      REQUIRE(less.is_below(force));
      const Vec3 nearest = less.nearest_to(force);
      CHECK(near(measure(less, nearest), 1, 1e-12));
      CHECK((nearest / held - far).norm() < 1e-4);
    }
    const FrictionLimit none = limit_at(1e-300, limit.offset, limit.radius, limit.arm);
    CHECK(none.is_below(beyond));
    CHECK(none.nearest_to(beyond).norm() == 0);
  }
}

TEST_CASE("a body that slides straight under eccentric pressure has no couple about its centre of pressure") {
  const Vec3 offset(0.1, -0.3, 0);
  const FrictionLimit limit = limit_at(100, offset, 0.4, 0.2);
  const SlidingLaw law{1e8, 0, 1e-3};
  for (const Vec3& way : {Vec3(1, 0, 0), Vec3(0.6, 0.8, 0), Vec3(-0.28, 0.96, 0)}) {
    SlidingForce force{Vec3::Zero(), Vec3::Zero(), 0.5};
    const Vec3 path = 1e-7 * way;
    for (int i = 0; i < 1000; ++i) force = slide({path, path / law.dt, limit}, 0.5, force, law).force;
    CHECK(near(force.total.head<2>().dot(way.head<2>()), 100, 1e-9));
    const double couple = 0.4 * force.total.z();
    CHECK(near(couple, (offset.x() * way.y() - offset.y() * way.x()) * 100, 1e-9));
  }
}

TEST_CASE("the limit is a convex curve: its normal rotates in one sense") {
  double before = -1;
  for (int i = 0; i <= 1000; ++i) {
    const double angle = i / 1000.0 * std::acos(-1.0) / 2;
    const double c = std::cos(angle), s = std::sin(angle);
    const double share = std::sqrt(limit_measure(c, s)), x = c / share, y = s / share;
    const double slide = 2 * square_slide;
    CHECK(near(slide * x * x * (1 - x * x) + x * x * x * x + y * y * (1 + square_turn * x * x), 1, 1e-12));
    CHECK(near(limit_measure(x, y), 1, 1e-12));
    CHECK(std::hypot(x, y) >= std::sqrt(0.88));
    const double along = slide * x * (1 - x * x) + (2 - slide) * x * x * x + square_turn * x * y * y;
    const double way = std::atan2(y * (1 + square_turn * x * x), along);
    CHECK(way > before);
    before = way;
  }
}

TEST_CASE("T11: limit of a square that slides and rotates at once") {
  // V / mu N, T / T_limit, about a point at d a from the middle
  for (const auto& [v, t] : {std::pair(0.1758, 0.9771), std::pair(0.3485, 0.9094), std::pair(0.5142, 0.8014),
                             std::pair(0.7902, 0.5178), std::pair(0.9534, 0.2352)}) {
    // Share of both on the curve: the measure of (v, t) / share is 1.
    const double squares = v * v + t * t, product = limit_measure(v, t) - squares;
    const double share = std::sqrt(0.5 * (squares + std::sqrt(squares * squares + 4 * product)));
    CHECK(near(share, 1, 7e-3));
  }
}
