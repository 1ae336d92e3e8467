#include "contact/space/flat_contact.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>

#include "contact/laid_bricks.hpp"
#include "contact/space/solid_faces.hpp"
#include "geometry/space/facing_faces.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

Triple<Lanes> in_all(const Vec3& v) {
  return four_of(v, v, v, v);
}
Lanes in_all(double v) {
  return Lanes{} + v;
}

MovingInLanes moving(const MovingSolid& of) {
  return {in_all(of.origin), in_all(of.velocity), in_all(of.spin)};
}

/// A contact with the same data in all lanes.
FlatContacts flat_contact(const MovingSolid& a, const MovingSolid& b, const FacePair& pair, const SolidMemory& m,
                          const PlainFriction& law) {
  FlatContacts in;
  FaceRoom room_a, room_b;
  const PlacedFace face_a = face_of(a.placed, pair.a, room_a), face_b = face_of(b.placed, pair.b, room_b);
  in.faces.corners_a = static_cast<int>(face_a.corners.size()),
  in.faces.corners_b = static_cast<int>(face_b.corners.size());
  for (std::size_t i = 0; i < face_a.corners.size(); ++i) in.faces.a[i] = in_all(face_a.corners[i]);
  for (std::size_t i = 0; i < face_b.corners.size(); ++i) in.faces.b[i] = in_all(face_b.corners[i]);
  in.faces.normal_a = in_all(face_a.normal), in.faces.normal_b = in_all(face_b.normal);
  in.near = in_all(near_faces(a.placed, b.placed));
  in.b_is_larger = LaneMask{} - (a.placed.solid->size < b.placed.solid->size ? 1 : 0);
  in.a = moving(a), in.b = moving(b);
  in.before = {{in_all(m.shear.elastic), in_all(m.shear.total), in_all(m.shear.area)},
               in_all(m.normal),
               in_all(m.damping),
               in_all(m.damping_moment),
               in_all(m.slip)};
  in.kn = in_all(law.kn), in.ks = in_all(law.ks), in.mu = in_all(law.mu), in.beta = in_all(law.beta), in.dt = law.dt;
  return in;
}

/// Largest difference of two vectors over the size of the first, or over `least`.
double off(const Vec3& expected, const Vec3& found, double least = 1e-6) {
  return (expected - found).norm() / std::max(expected.norm(), least);
}

/// A friction law with shear stiffness.
ContactLaw rubbing(double mu, double beta) {
  Frictional law;
  law.kn = 1e9, law.ks = 4e8, law.mu = mu, law.beta = beta;
  return law;
}

/// Largest difference between four lanes and single contacts, along a slide of 30 steps.
double largest_difference(const Laid& laid, const ContactLaw& law, int& flat, int& sliding) {
  const LawInUse use{law, 1, 1e-4};
  const FacePair pair = facing_pair(laid.a, laid.b, 0);
  if (pair.a < 0) return 0;
  double most = 0;
  SolidMemory memory;
  FaceOverlap3 faces;
  SolidRoom room;
  for (int step = 0; step < 30 && flat_faces(laid.a, laid.b, faces); ++step) {
    const MovingSolid a = laid.lower(), b = laid.upper();
    const SolidPressure pressed = face_pressure(a, b, plain_friction(use), faces);
    const SolidResponse r = polyhedron_contact_forces(a, b, memory, use, pressed, room);
    FlatResponses four;
    respond_flat(flat_contact(a, b, pair, memory, plain_friction(use)), four);
    REQUIRE((four.flat[0] != 0));
    REQUIRE((four.rough[0] == 0));
    REQUIRE((four.presses[0] != 0) == r.touching);
    if (!r.touching) break;
    ++flat;
    if (r.memory.slip > memory.slip + 1e-12) ++sliding;
    for (int lane = 0; lane < lane_count; ++lane) {
      const double force = r.force.norm(), energy = std::abs(r.lost_damping) + std::abs(r.lost_friction) +
                                                    sliding_energy(4e8, r.memory.shear) + 1e-9;
      most = std::max(
          {most, off(r.force, lane_of(four.force, lane)), off(r.normal_force, lane_of(four.normal_force, lane)),
           off(r.memory.shear.total, lane_of(four.memory.shear.total, lane), 1e-3 * force),
           off(r.memory.shear.elastic, lane_of(four.memory.shear.elastic, lane), 1e-3 * force),
           off(r.memory.damping, lane_of(four.memory.damping, lane), 1e-3 * force),
           off(r.memory.damping_moment, lane_of(four.memory.damping_moment, lane), 1e-3 * force),
           std::abs(r.area - four.area[lane]) / r.area, off(r.centre, lane_of(four.centre, lane), 1),
           off(r.middle, lane_of(four.middle, lane), 1), std::abs(r.radius - four.radius[lane]),
           std::abs(r.friction_arm - four.friction_arm[lane]), std::abs(r.depth - four.depth[lane]) / r.depth,
           std::abs(r.lost_damping - four.lost_damping[lane]) / energy,
           std::abs(r.lost_friction - four.lost_friction[lane]) / energy});
      const Vec3 about_b = r.moment + cross(Vec3(r.centre - b.origin), r.force);
      most = std::max(most, off(about_b, lane_of(four.moment_b, lane), 1e-3 * force));
    }
    memory = r.memory;
  }
  return most;
}

void take(const Lanes& from, int lane, Lanes& to) {
  to[lane] = from[lane];
}
void take(const Triple<Lanes>& from, int lane, Triple<Lanes>& to) {
  take(from.x, lane, to.x), take(from.y, lane, to.y), take(from.z, lane, to.z);
}

/// Copies one lane of the input of four contacts; both have faces of four corners.
void take(const FlatContacts& from, int lane, FlatContacts& to) {
  for (std::size_t k = 0; k < 4; ++k)
    take(from.faces.a[k], lane, to.faces.a[k]), take(from.faces.b[k], lane, to.faces.b[k]);
  take(from.faces.normal_a, lane, to.faces.normal_a), take(from.faces.normal_b, lane, to.faces.normal_b);
  take(from.near, lane, to.near), to.b_is_larger[lane] = from.b_is_larger[lane];
  for (const auto m : {&FlatContacts::a, &FlatContacts::b})
    for (const auto v : {&MovingInLanes::origin, &MovingInLanes::velocity, &MovingInLanes::spin})
      take(from.*m.*v, lane, to.*m.*v);
  const FlatMemory& m = from.before;
  take(m.shear.elastic, lane, to.before.shear.elastic), take(m.shear.total, lane, to.before.shear.total);
  take(m.shear.area, lane, to.before.shear.area), take(m.slip, lane, to.before.slip);
  take(m.normal, lane, to.before.normal), take(m.damping, lane, to.before.damping);
  take(m.damping_moment, lane, to.before.damping_moment);
}

/// Whether a lane of both has the same bits.
bool same_lane(const FlatResponses& one, const FlatResponses& other, int lane) {
  bool same = one.flat[lane] == other.flat[lane] && one.rough[lane] == other.rough[lane];
  if (one.flat[lane] == 0 || one.rough[lane] != 0) return same;
  same = same && one.kind[lane] == other.kind[lane] && one.presses[lane] == other.presses[lane];
  for (const auto v : {&FlatResponses::force, &FlatResponses::moment_a, &FlatResponses::moment_b,
                       &FlatResponses::normal_force, &FlatResponses::centre, &FlatResponses::middle})
    same = same && lane_of(one.*v, lane) == lane_of(other.*v, lane);
  for (const auto v : {&FlatMemory::damping, &FlatMemory::damping_moment, &FlatMemory::normal})
    same = same && lane_of(one.memory.*v, lane) == lane_of(other.memory.*v, lane);
  for (const auto v : {&ShearForce<Lanes>::elastic, &ShearForce<Lanes>::total})
    same = same && lane_of(one.memory.shear.*v, lane) == lane_of(other.memory.shear.*v, lane);
  for (const auto x : {&FlatResponses::area, &FlatResponses::depth, &FlatResponses::radius,
                       &FlatResponses::friction_arm, &FlatResponses::lost_damping, &FlatResponses::lost_friction})
    same = same && (one.*x)[lane] == (other.*x)[lane];
  return same;
}

/// Four contacts after a slip of three steps.
FlatContacts rubbed(std::mt19937_64& bits, double tilt, const ContactLaw& law) {
  const LawInUse use{law, 1, 1e-4};
  SolidMemory memory;
  while (true) {
    const Laid laid(bits, 1e-5, tilt);
    const FacePair pair = facing_pair(laid.a, laid.b, 0);
    if (pair.a < 0) continue;
    FlatContacts in;
    for (int step = 0; step < 3; ++step) {
      FlatResponses out;
      in = flat_contact(laid.lower(), laid.upper(), pair, memory, plain_friction(use));
      respond_flat(in, out);
      if (out.flat[0] == 0 || out.presses[0] == 0) break;
      const FlatMemory& m = out.memory;
      memory.shear = {lane_of(m.shear.elastic, 0), lane_of(m.shear.total, 0), m.shear.area[0]};
      memory.normal = lane_of(m.normal, 0), memory.damping = lane_of(m.damping, 0);
      memory.damping_moment = lane_of(m.damping_moment, 0), memory.slip = m.slip[0];
    }
    return in;
  }
}

}  // namespace

TEST_CASE("four flat contacts at once give the bits of one after the other") {
  std::mt19937_64 bits(11);
  int flat = 0, sliding = 0;
  double most = 0;
  for (const double beta : {0.0, 1e-4})
    for (const double mu : {0.05, 5.0})
      for (const double tilt : {0.0, 5e-5, 4e-4})
        for (int i = 0; i < 60; ++i)
          most = std::max(most, largest_difference(Laid(bits, 1e-5, tilt), rubbing(mu, beta), flat, sliding));
  CHECK(flat > 5000);
  CHECK(sliding > 500);
  // Edges are shifted outwards by 1e-12 of their length, and an arm of a few micrometres is a difference of sums over
  // metres.
  CHECK(most < 2e-7);
}

TEST_CASE("only the pair of faces that may lie flat is tested until it fails") {
  std::mt19937_64 bits(12);
  int alone = 0;
  for (int i = 0; i < 300; ++i) {
    const Laid laid(bits, 1e-5, 1e-3);
    const FacePair pair = facing_pair(laid.a, laid.b, 0);
    if (pair.a < 0) continue;
    ++alone;
    CHECK(pair.until > 1e-3);
    // Both bodies moved at random, with corner displacements up to the remaining distance together: no other faces may
    // be in flat contact.
    const auto moved = [&](const PlacedSolid& of, double until) {
      const UnitQuaternion turn = rotation_by(Vec3(until / 1.5 * random_in_ball(bits)));
      const Vec3 shift = random_in_ball(bits);
      PlacedSolid out;
      double farthest = 0;
      const Polyhedron now = placed({of.corners, of.solid->shape.faces}, turn, Vec3::Zero());
      out.solid = of.solid, out.corners = now.corners, out.normals = face_normals(now);
      Vec3 mean = Vec3::Zero(), mean_before = Vec3::Zero();
      for (std::size_t k = 0; k < now.corners.size(); ++k) mean += now.corners[k], mean_before += of.corners[k];
      const Vec3 back = (mean_before - mean) / static_cast<double>(now.corners.size());
      for (std::size_t k = 0; k < now.corners.size(); ++k) {
        out.corners[k] += back;
        farthest = std::max(farthest, (out.corners[k] - of.corners[k]).norm());
      }
      for (Vec3& x : out.corners) x += std::max(0.0, 0.999 * until - farthest) * shift;
      return out;
    };
    const double share = std::uniform_real_distribution(0.0, 1.0)(bits);
    const PlacedSolid a = moved(laid.a, share * pair.until), b = moved(laid.b, (1 - share) * pair.until);
    const FacePair later = facing_pair(a, b, 0);
    CHECK(((later.a == pair.a && later.b == pair.b) || later.a == FacePair::none));
  }
  CHECK(alone > 250);
}

TEST_CASE("a flat contact has the same bits alone and among others") {
  std::mt19937_64 bits(47);
  std::set<std::int64_t> kinds;
  int sliding = 0, flat = 0;
  for (int round = 0; round < 1500; ++round) {
    std::array<FlatContacts, lane_count> alone;
    std::array<FlatResponses, lane_count> expected;
    // Fully closed, partly open, and some sliding.
    for (std::size_t i = 0; i < alone.size(); ++i)
      alone[i] = rubbed(bits, i % 2 == 0 ? 0 : 4e-4, rubbing(i < 2 ? 0.05 : 5.0, 1e-4));
    FlatContacts mixed = alone[0];
    for (int lane = 0; lane < lane_count; ++lane) {
      const auto i = static_cast<std::size_t>(lane);
      respond_flat(alone[i], expected[i]);
      take(alone[i], lane, mixed);
      mixed.mu[lane] = alone[i].mu[lane];
    }
    FlatResponses out;
    respond_flat(mixed, out);
    for (int lane = 0; lane < lane_count; ++lane) {
      const FlatResponses& one = expected[static_cast<std::size_t>(lane)];
      REQUIRE(same_lane(one, out, lane));
      if (one.flat[lane] == 0) continue;
      ++flat, kinds.insert(one.kind[lane]);
      sliding += one.kind[lane] >= flat_kinds / 2 ? 1 : 0;
    }
  }
  CHECK(flat > 4000);
  CHECK(kinds.size() > 20);
  CHECK(sliding > 500);
}

TEST_CASE("a pair of faces names the corners of both") {
  std::mt19937_64 bits(13);
  for (int i = 0; i < 50; ++i) {
    const Laid laid(bits, 1e-5, 0);
    const FacePair pair = facing_pair(laid.a, laid.b, 0);
    if (pair.a < 0) continue;
    REQUIRE(pair.few);
    CHECK(pair.near == near_faces(laid.a, laid.b));
    CHECK(pair.b_is_larger == (laid.a.solid->size < laid.b.solid->size));
    for (std::size_t k = 0; k < few_corners; ++k) {
      CHECK(pair.corner_a[k] == laid.a.solid->shape.faces[pair.a][k]);
      CHECK(pair.corner_b[k] == laid.b.solid->shape.faces[pair.b][k]);
    }
  }
}
