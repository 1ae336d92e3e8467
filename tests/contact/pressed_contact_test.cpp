#include "contact/space/pressed_contact.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "contact/plane/edge_pressure.hpp"
#include "contact/space/solid_contact.hpp"
#include "geometry/space/random_convex_3d.hpp"

using namespace trilith;

namespace {

/// A pair of overlapping boxes in motion, with a memory of an earlier step.
struct RubbingBoxes {
  PlacedSolid a, b;
  Vec3 at_b, velocity_a, velocity_b, spin_a, spin_b;
  SolidMemory memory;

  /// `fast`: largest velocity [m/s] and spin [rad/s].
  RubbingBoxes(std::mt19937_64& bits, double fast) {
    static const ConvexSolid box_a = convex_solid(box_solid(Vec3(-1, -0.8, -0.6), Vec3(1, 0.8, 0.6)), "a"),
                             box_b = convex_solid(box_solid(Vec3(-0.7, -0.9, -1), Vec3(0.7, 0.9, 1)), "b");
    place(box_a, Turn3(random_rotation(bits)), Vec3::Zero(), a);
    const UnitQuaternion turn = random_rotation(bits);
    place(box_b, Turn3(turn), Vec3::Zero(), b);
    const Separation3 apart = separation(a, b);
    at_b = -0.98 * apart.distance * apart.axis;
    place(box_b, Turn3(turn), at_b, b);
    for (Vec3* v : {&velocity_a, &velocity_b, &spin_a, &spin_b}) *v = fast * random_in_ball(bits);
    memory.state = contact_touching | contact_general;
    memory.normal = (apart.axis + 0.01 * random_in_ball(bits)).normalized();
    for (Vec3* v : {&memory.shear.elastic, &memory.shear.total, &memory.damping, &memory.damping_moment})
      *v = 1e4 * random_in_ball(bits);
    memory.shear.area = 0.01, memory.slip = 0.5;
  }
  [[nodiscard]] MovingSolid lower() const { return {a, Vec3::Zero(), velocity_a, spin_a}; }
  [[nodiscard]] MovingSolid upper() const { return {b, at_b, velocity_b, spin_b}; }
};

void put(const Vec3& v, int lane, Triple<Lanes>& to) {
  to.x[lane] = v.x(), to.y[lane] = v.y(), to.z[lane] = v.z();
}

void put(const RubbingBoxes& of, const PlainFriction& law, const PairSums& sums, int lane, PressedContacts& in) {
  const MovingSolid a = of.lower(), b = of.upper();
  put(a.origin, lane, in.a.origin), put(a.velocity, lane, in.a.velocity), put(a.spin, lane, in.a.spin);
  put(b.origin, lane, in.b.origin), put(b.velocity, lane, in.b.velocity), put(b.spin, lane, in.b.spin);
  const SolidMemory& m = of.memory;
  put(m.shear.elastic, lane, in.before.shear.elastic), put(m.shear.total, lane, in.before.shear.total);
  put(m.normal, lane, in.before.normal), put(m.damping, lane, in.before.damping);
  put(m.damping_moment, lane, in.before.damping_moment);
  in.before.shear.area[lane] = m.shear.area, in.before.slip[lane] = m.slip;
  in.kn[lane] = law.kn, in.ks[lane] = law.ks, in.mu[lane] = law.mu, in.beta[lane] = law.beta, in.dt = law.dt;
  in.sums[static_cast<std::size_t>(lane)] = &sums;
}

double off(const Vec3& expected, const Vec3& found, double of) {
  return (expected - found).norm() / of;
}

/// Largest difference of a lane from a contact evaluated by itself: forces relative to the force, lengths to 1 m.
double difference(const SolidResponse& r, const FlatResponses& four, int lane, const Vec3& at_b) {
  const double force = r.force.norm() + r.memory.damping.norm(),
               energy = force * 1e-3 + std::abs(r.lost_damping) + std::abs(r.lost_friction);
  const Vec3 on_a = -r.moment - cross(r.centre, r.force), on_b = r.moment + cross(Vec3(r.centre - at_b), r.force);
  return std::max(
      {off(r.force, lane_of(four.force, lane), force), off(r.normal_force, lane_of(four.normal_force, lane), force),
       off(on_a, lane_of(four.moment_a, lane), force), off(on_b, lane_of(four.moment_b, lane), force),
       off(r.memory.shear.total, lane_of(four.memory.shear.total, lane), force),
       off(r.memory.shear.elastic, lane_of(four.memory.shear.elastic, lane), force),
       off(r.memory.damping, lane_of(four.memory.damping, lane), force),
       off(r.memory.damping_moment, lane_of(four.memory.damping_moment, lane), force),
       off(r.memory.normal, lane_of(four.memory.normal, lane), 1), off(r.centre, lane_of(four.centre, lane), 1),
       off(r.middle, lane_of(four.middle, lane), 1), std::abs(r.area / four.area[lane] - 1),
       std::abs(r.radius - four.radius[lane]), std::abs(r.friction_arm - four.friction_arm[lane]),
       std::abs(r.depth - four.depth[lane]), std::abs(r.memory.slip - four.memory.slip[lane]),
       std::abs(r.lost_damping - four.lost_damping[lane]) / energy,
       std::abs(r.lost_friction - four.lost_friction[lane]) / energy});
}

/// Four pairs by the kernel, and each of them with itself in all lanes.
struct FourPairs {
  std::vector<RubbingBoxes> pair;
  std::array<PairSums, lane_count> sums;
  PressedContacts in;

  FourPairs(std::mt19937_64& bits, const PlainFriction& law, double fast = 20) {
    std::vector<FourTriangles> room;
    while (pair.size() < lane_count) {
      RubbingBoxes next(bits, fast);
      PairSums& of = sums[pair.size()];
      if (edge_sums(next.lower(), next.upper(), law.beta, room, of)) pair.push_back(std::move(next));
    }
    for (int lane = 0; lane < lane_count; ++lane)
      put(pair[static_cast<std::size_t>(lane)], law, sums[static_cast<std::size_t>(lane)], lane, in);
  }
};

}  // namespace

TEST_CASE("four pressed contacts have the forces, memories and losses of single ones") {
  std::mt19937_64 bits(94);
  Frictional rubbing;
  rubbing.kn = 1e8, rubbing.ks = 5e7;
  int slides = 0, sticks = 0, without_force = 0;
  for (int trial = 0; trial < 500; ++trial) {
    rubbing.mu = trial % 2 == 0 ? 0.5 : 50.0, rubbing.beta = trial % 3 == 0 ? 0.0 : 1e-3;
    const ContactLaw law = rubbing;
    const LawInUse use{law, 1, 1e-4};
    const FourPairs of(bits, plain_friction(use), trial % 5 == 0 ? 2000 : 20);
    FlatResponses four;
    respond_pressed(of.in, four);
    SolidRoom room;
    for (int lane = 0; lane < lane_count; ++lane) {
      const RubbingBoxes& one = of.pair[static_cast<std::size_t>(lane)];
      const PairSums& sums = of.sums[static_cast<std::size_t>(lane)];
      const SolidPressure pressed = pressure_of_sums(sums.origin, 0.5 * rubbing.kn, sums.sums);
      const SolidResponse r = polyhedron_contact_forces(one.lower(), one.upper(), one.memory, use, pressed, room);
      REQUIRE((four.flat[lane] != 0));
      REQUIRE((four.presses[lane] != 0) == r.touching);
      // Newton's method ends at 1e-9 of the limit.
      CHECK(difference(r, four, lane, one.at_b) < 1e-8);
      const bool forced = pressed.pressure > 0;
      slides += forced && r.memory.slip > one.memory.slip + 1e-12 ? 1 : 0;
      sticks += forced && r.memory.slip <= one.memory.slip + 1e-12 ? 1 : 0;
      without_force += forced ? 0 : 1;
    }
  }
  CHECK(slides > 300);
  CHECK(sticks > 100);
  CHECK(without_force > 20);
}

TEST_CASE("... whatever is in the other lanes, to the last bit") {
  std::mt19937_64 bits(95);
  Frictional rubbing;
  rubbing.kn = 1e8, rubbing.ks = 5e7, rubbing.mu = 0.5, rubbing.beta = 1e-3;
  const ContactLaw law = rubbing;
  const PlainFriction plain = plain_friction({law, 1, 1e-4});
  for (int trial = 0; trial < 200; ++trial) {
    const FourPairs of(bits, plain);
    FlatResponses four;
    respond_pressed(of.in, four);
    for (int lane = 0; lane < lane_count; ++lane) {
      PressedContacts alone;
      const auto l = static_cast<std::size_t>(lane);
      for (int to = 0; to < lane_count; ++to) put(of.pair[l], plain, of.sums[l], to, alone);
      FlatResponses one;
      respond_pressed(alone, one);
      const auto same = [&](const Triple<Lanes>& p, const Triple<Lanes>& q) {
        return lane_of(p, lane) == lane_of(q, 0);
      };
      CHECK(same(four.force, one.force));
      CHECK(same(four.moment_a, one.moment_a));
      CHECK(same(four.moment_b, one.moment_b));
      CHECK(same(four.memory.shear.elastic, one.memory.shear.elastic));
      CHECK(double{four.lost_friction[lane]} == double{one.lost_friction[0]});
      CHECK(double{four.lost_damping[lane]} == double{one.lost_damping[0]});
    }
  }
}
