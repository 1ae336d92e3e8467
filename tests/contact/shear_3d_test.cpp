#include "contact/shear_3d.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "near.hpp"

using namespace trilith;
using testing::near;
using testing::near_zero;

TEST_CASE("shear below its limit is elastic, in any direction") {
  const SlidingLaw law{1e8, 0, 1e-3};
  SlidingForce force{Vec3::Zero(), Vec3::Zero(), 0.5};
  const Vec3 path(3e-6, -4e-6, 0);
  const SlidingResponse r = slide({path, path / law.dt, Vec3::UnitZ(), 1e9}, 0.5, force, law);
  CHECK(near_zero((r.force.elastic - 5e7 * path).norm(), 1e-9));
  CHECK(r.slip == 0);
  CHECK(r.lost_friction == 0);
  CHECK(near(sliding_energy(law.ks, r.force), 0.5 * 5e7 * path.squaredNorm(), 1e-12));
}

TEST_CASE("beyond its limit shear slides against the motion with just the limit") {
  const SlidingLaw law{1e8, 0, 1e-3};
  SlidingForce force{Vec3::Zero(), Vec3::Zero(), 0.5};
  const Vec3 way = Vec3(1, 2, 0).normalized() * 1e-5;
  double slip = 0, lost = 0;
  for (int i = 0; i < 200; ++i) {
    const SlidingResponse r = slide({way, way / law.dt, Vec3::UnitZ(), 100}, 0.5, force, law);
    force = r.force, slip += r.slip, lost += r.lost_friction;
  }
  CHECK(near(force.total.norm(), 100, 1e-12));
  CHECK(near(force.total.dot(way) / way.norm(), 100, 1e-9));
  CHECK(near(slip, 200 * way.norm() - 100 / 5e7, 1e-9));
  CHECK(near(lost, 100 * slip, 1e-2));
}

TEST_CASE("energy put into shear is held or given off, with damping and changing area") {
  const SlidingLaw law{1e8, 2e-4, 1e-3};
  SlidingForce force{Vec3::Zero(), Vec3::Zero(), 0.5};
  double put_in = 0, lost = 0;
  for (int i = 0; i < 500; ++i) {
    const double t = 0.02 * i;
    const Vec3 path = 1e-6 * Vec3(std::cos(t), std::sin(1.7 * t), 0.5 * std::cos(2.3 * t));
    const double area = 0.5 + 0.3 * std::sin(0.5 * t);
    const Vec3 before = force.total;
    const SlidingResponse r = slide({path, path / law.dt, Vec3::UnitZ(), 60}, area, force, law);
    force = r.force;
    put_in += 0.5 * (before + force.total).dot(path);
    lost += r.lost_friction + r.lost_damping;
    CHECK(limit_measure(force.total.head<2>().norm() / 60, std::abs(force.total.z()) / 60) <= 1 + 1e-12);
  }
  CHECK(lost > 0);
  CHECK(near(put_in, lost + sliding_energy(law.ks, force), 1e-9));
}

TEST_CASE("the nearest point of the limit is nearest, and the way to it is along the normal") {
  for (const double x : {0.0, 0.3, 0.9, 1.5, 20.0})
    for (const double y : {0.0, 0.4, 0.8, 1.1, 30.0}) {
      if (!(limit_measure(x, y) > 1)) continue;
      const auto [a, b] = nearest_on_limit(x, y);
      CHECK(near(limit_measure(a, b), 1, 1e-12));
      const double least = std::hypot(x - a, y - b);
      for (int i = 0; i <= 1000; ++i) {
        const double c = i / 1000.0, d = std::sqrt((1 - c * c) / (1 + 0.57 * c * c));
        CHECK(std::hypot(x - c, y - d) >= least * (1 - 1e-12));
      }
    }
}

TEST_CASE("the limit is a convex curve: its normal turns one way only") {
  double before = -1;
  for (int i = 0; i <= 1000; ++i) {
    const double angle = i / 1000.0 * std::acos(-1.0) / 2;
    const double c = std::cos(angle), s = std::sin(angle);
    const double squares = 1, product = 0.57 * c * c * s * s;
    const double share = std::sqrt(0.5 * (squares + std::sqrt(squares + 4 * product))), x = c / share, y = s / share;
    CHECK(near(limit_measure(x, y), 1, 1e-12));
    CHECK(std::hypot(x, y) >= std::sqrt(0.88));
    const double way = std::atan2(y * (1 + 0.57 * x * x), x * (1 + 0.57 * y * y));
    CHECK(way > before);
    before = way;
  }
}

TEST_CASE("T11: what a square carries in sliding and turning at once") {
  // V / mu N, T / T_limit, about a point at d a from the middle
  for (const auto& [v, t] : {std::pair(0.1758, 0.9771), std::pair(0.3485, 0.9094), std::pair(0.5142, 0.8014),
                             std::pair(0.7902, 0.5178), std::pair(0.9534, 0.2352)}) {
    // How much of them the curve carries: measure of (v, t) / share is 1.
    const double squares = v * v + t * t, product = limit_measure(v, t) - squares;
    const double share = std::sqrt(0.5 * (squares + std::sqrt(squares * squares + 4 * product)));
    CHECK(near(share, 1, 7e-3));
  }
}
