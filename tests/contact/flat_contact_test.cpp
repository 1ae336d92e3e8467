#include "contact/flat_contact.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "contact/laid_bricks.hpp"
#include "contact/solid_faces.hpp"
#include "near.hpp"
#include "shape/facing_faces.hpp"

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

/// All lanes alike.
FlatContacts flat_contact(const MovingSolid& a, const MovingSolid& b, const FacePair& pair, const SolidMemory& m,
                          const Coulomb& law) {
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

/// The largest difference of two vectors over the size of the first, or over `least`.
double off(const Vec3& expected, const Vec3& found, double least = 1e-6) {
  return (expected - found).norm() / std::max(expected.norm(), least);
}

/// A law of friction with shear.
ContactLaw rubbing(double mu, double beta) {
  Frictional law;
  law.kn = 1e9, law.ks = 4e8, law.mu = mu, law.beta = beta;
  return law;
}

/// The largest difference between what four lanes and one contact after the other give, along a slide of 30 steps.
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
    const SolidPressure pressed = with_kernel(use, [&](const Coulomb& k) { return face_pressure(a, b, k, faces); });
    const SolidResponse r = respond_solids(a, b, memory, use, pressed, room);
    FlatResponses four;
    with_kernel(use, [&](const Coulomb& k) { respond_flat(flat_contact(a, b, pair, memory, k), four); });
    REQUIRE(four.flat[0] != 0);
    REQUIRE(four.rough[0] == 0);
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

}  // namespace

TEST_CASE("four flat contacts at once give what one after the other does") {
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
  // Edges count as farther out by 1e-12 of their length, and an arm of some micrometres comes of sums over metres.
  CHECK(most < 2e-7);
}

TEST_CASE("the pair of faces that may lie flat is the only one until it says so") {
  std::mt19937_64 bits(12);
  int alone = 0;
  for (int i = 0; i < 300; ++i) {
    const Laid laid(bits, 1e-5, 1e-3);
    const FacePair pair = facing_pair(laid.a, laid.b, 0);
    if (pair.a < 0) continue;
    ++alone;
    CHECK(pair.until > 1e-3);
    // Both bodies moved by chance, no corner farther than that: no other pair of faces may lie flat then.
    const auto moved = [&](const PlacedSolid& of) {
      const UnitQuaternion turn = rotation_by(Vec3(pair.until / 1.5 * random_in_ball(bits)));
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
      for (Vec3& x : out.corners) x += std::max(0.0, 0.999 * pair.until - farthest) * shift;
      return out;
    };
    const PlacedSolid a = moved(laid.a), b = moved(laid.b);
    const FacePair later = facing_pair(a, b, 0);
    CHECK(((later.a == pair.a && later.b == pair.b) || later.a == FacePair::none));
  }
  CHECK(alone > 250);
}
