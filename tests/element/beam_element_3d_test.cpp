// The beam element in space: its forces are the gradient of its energy, its strain rates the derivatives of its
// strains, and a rigid motion causes no strain.
#include <doctest/doctest.h>

#include <random>

#include "element/beam/beam_element_3d.hpp"
#include "geometry/plane/random_convex.hpp"
#include "geometry/space/random_convex_3d.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

struct BeamPose {
  std::array<Vec3, 2> place;
  std::array<UnitQuaternion, 2> axes;
};
struct BeamRates {
  std::array<Vec3, 2> velocity, spin;
};

constexpr double rest_length = 1.3;

/// A beam at a random place, stretched, bent by up to `bend` [rad] and twisted.
BeamPose strained_pose(std::mt19937_64& bits, double bend) {
  const UnitQuaternion turn = rotation_by(3 * random_in_ball(bits));
  const Vec3 from = random_in_ball(bits);
  return {{from, Vec3(from + turn_of(turn).apply(Vec3(1.01 * rest_length, 0, 0)))},
          {turn * rotation_by(bend * random_in_ball(bits)), turn * rotation_by(bend * random_in_ball(bits))}};
}

BeamNow3 beam_at(const BeamPose& pose, const BeamRates& rates, double time) {
  const auto end = [&](std::size_t i) {
    return BeamEnd3{pose.place[i] + time * rates.velocity[i], turn_of(rotation_by(time * rates.spin[i]) * pose.axes[i]),
                    rates.velocity[i], rates.spin[i]};
  };
  return {end(0), end(1), rest_length};
}

BeamStiffness3 some_stiffness() {
  return beam_stiffness_in_space({2.1e11, 8e10, true}, section_in_space(RectangleSection{0.2, 0.4}), rest_length,
                                 {false, false});
}

BeamRates some_rates(std::mt19937_64& bits) {
  return {{random_in_ball(bits), random_in_ball(bits)}, {random_in_ball(bits), random_in_ball(bits)}};
}

}  // namespace

TEST_CASE("strain rates of a beam in space match its strains, and its forces are the gradient of its energy") {
  std::mt19937_64 bits(3);
  const BeamStiffness3 stiffness = some_stiffness();
  for (int i = 0; i < 200; ++i) {
    const BeamPose pose = strained_pose(bits, i % 2 == 0 ? 0.02 : 0.5);
    const BeamRates rates = some_rates(bits);
    const double step = 1e-5;
    const BeamNow3 now = beam_at(pose, rates, 0), after = beam_at(pose, rates, step),
                   before = beam_at(pose, rates, -step);
    for (std::size_t k = 0; k < 6; ++k)
      CHECK(near_zero((after.strain()[k] - before.strain()[k]) / (2 * step) - now.rate()[k], 1e-8));
    const BeamAction3 action = now.action(stress_of(stiffness, now.strain()));
    const double power = action.force.dot(rates.velocity[0] - rates.velocity[1]) + action.moment[0].dot(rates.spin[0]) +
                         action.moment[1].dot(rates.spin[1]);
    const double slope = (stored_in(stiffness, after.strain()) - stored_in(stiffness, before.strain())) / (2 * step);
    CHECK(near_zero(power + slope, 1e-7 * (action.force.norm() + action.moment[0].norm() + action.moment[1].norm())));
  }
}

TEST_CASE("forces of a beam in space balance about every point") {
  std::mt19937_64 bits(4);
  const BeamStiffness3 stiffness = some_stiffness();
  for (int i = 0; i < 100; ++i) {
    const BeamPose pose = strained_pose(bits, 0.5);
    const BeamNow3 now = beam_at(pose, {{Vec3::Zero(), Vec3::Zero()}, {Vec3::Zero(), Vec3::Zero()}}, 0);
    const BeamAction3 action = now.action(stress_of(stiffness, now.strain()));
    const Vec3 left = action.moment[0] + action.moment[1] + cross(Vec3(pose.place[0] - pose.place[1]), action.force);
    CHECK(left.norm() < 1e-13 * (action.moment[0].norm() + action.moment[1].norm() + action.force.norm()));
  }
}

TEST_CASE("a rigid motion of any size strains no beam in space") {
  std::mt19937_64 bits(5);
  const BeamStiffness3 stiffness = some_stiffness();
  for (int i = 0; i < 200; ++i) {
    const UnitQuaternion own = rotation_by(3 * random_in_ball(bits)), turn = rotation_by(10 * random_in_ball(bits));
    const Vec3 from = 100 * random_in_ball(bits), spin = random_in_ball(bits), speed = random_in_ball(bits);
    const Vec3 chord = turn_of(turn * own).apply(Vec3(rest_length, 0, 0));
    const BeamNow3 now({from, turn_of(turn * own), speed, spin},
                       {from + chord, turn_of(turn * own), speed + cross(spin, chord), spin}, rest_length);
    const BeamAction3 action = now.action(stress_of(stiffness, now.strain()));
    CHECK(action.force.norm() < 1e-9 * stiffness.axial);
    CHECK(action.moment[0].norm() + action.moment[1].norm() < 1e-9 * stiffness.bend[1].bend[0]);
    for (const double rate : now.rate()) CHECK(near_zero(rate, 1e-12));
  }
}

TEST_CASE("a beam in space that moves in a plane has the forces of the beam in the plane") {
  std::mt19937_64 bits(6);
  const RectangleSection shape{0.2, 0.4};
  const BeamStiffness plane = beam_stiffness({2.1e11, 8e10}, shape.numbers(), rest_length, {false, false});
  const BeamStiffness3 space =
      beam_stiffness_in_space({2.1e11, 8e10, true}, section_in_space(shape), rest_length, {false, false});
  for (int i = 0; i < 50; ++i) {
    const Vec3 r = random_in_ball(bits), s = random_in_ball(bits), v = random_in_ball(bits), w = random_in_ball(bits);
    const Vec2 from(r.x(), r.y()), to = from + 1.3 * Vec2(1 + 0.05 * s.x(), 0.2 * s.y());
    const BeamNow flat({from, 0.3 * r.z(), Vec2(v.x(), v.y()), v.z()}, {to, 0.3 * s.z(), Vec2(w.x(), w.y()), w.z()},
                       rest_length, 0);
    const auto end = [](const Vec2& at, double angle, const Vec3& motion) {
      return BeamEnd3{Vec3(at.x(), at.y(), 0), turn_by(Vec3(0, 0, angle)), Vec3(motion.x(), motion.y(), 0),
                      Vec3(0, 0, motion.z())};
    };
    const BeamNow3 now(end(from, 0.3 * r.z(), v), end(to, 0.3 * s.z(), w), rest_length);
    const BeamStress expected = stress_of(plane, flat.strain);
    const BeamStress3 stress = stress_of(space, now.strain());
    for (const auto& [k, j] : {std::pair(0, 0), std::pair(2, 1), std::pair(4, 2)}) {
      CHECK(near(stress[static_cast<std::size_t>(k)], expected[static_cast<std::size_t>(j)], 1e-11));
      CHECK(near(now.rate()[static_cast<std::size_t>(k)], flat.rate[static_cast<std::size_t>(j)], 1e-11));
    }
    CHECK(near_zero(stress[1], 1e-6));
    CHECK(near_zero(stress[5], 1e-6));
    const Vec2 force = flat.force_on_start(expected);
    CHECK((now.action(stress).force.head<2>() - force).norm() < 1e-11 * force.norm());
  }
}

TEST_CASE("no frequency of a beam in space exceeds its bound, and a free beam has six motions without strain") {
  const Vec3 inertia(3, 1, 2);
  const double bound = beam_frequency2(some_stiffness(), rest_length, 100, inertia);
  // Each simple motion alone: ends apart, ends twisted against each other.
  CHECK(bound >= some_stiffness().axial * 2 / 100);
  CHECK(bound >= some_stiffness().torsion * 2 / inertia.x());
  CHECK(bound < 1e3 * some_stiffness().axial / 100);
}
