#include "contact/space/solid_faces.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "contact/laid_bricks.hpp"
#include "contact/space/solid_contact.hpp"
#include "contact/space/solid_energy.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

TEST_CASE("flat faces press as the volume they share does") {
  std::mt19937_64 bits(5);
  const double overlap = 1e-5;
  for (const double beta : {0.0, 1e-4}) {
    const ContactLaw law = joint(1e9, beta);
    int flat = 0;
    for (int i = 0; i < 400; ++i) {
      const Laid laid(bits, overlap, 5e-5);
      FaceOverlap3 faces;
      if (!flat_faces(laid.a, laid.b, faces)) continue;
      ++flat;
      SolidOverlapBuffer shared, cell;
      solid_overlap(laid.a, laid.b, shared);
      const LawInUse use{law};
      const SolidPressure whole = solid_pressure(laid.lower(), laid.upper(), use, shared);
      const SolidPressure face = face_pressure(laid.lower(), laid.upper(), plain_friction(use), faces);
      // The strips along the edges are as wide as the penetration.
      const double within = 2e-3, size = std::max(whole.force.norm(), 1.0);
      CHECK((face.force - whole.force).norm() <= within * size);
      CHECK((face.damping - whole.damping).norm() <= within * size);
      CHECK((face.centre - whole.centre).norm() <= within);
      CHECK(near_zero(face.damped - whole.damped, within * size * 0.05));
      CHECK(
          (face.damping_moment + cross(Vec3(face.centre - whole.centre), face.damping) - whole.damping_moment).norm() <=
          within * size);
      CHECK(near(face.area, whole.area, 1e-2));
      CHECK(near(face.radius, whole.radius, 1e-2));
      CHECK(near(face.friction_arm, whole.friction_arm, 1e-2));
      const double energy = face_energy(plain_friction(use), faces);
      CHECK(near(energy, solid_energy(laid.a, laid.b, use, shared, cell), 1e-2));
    }
    CHECK(flat > 200);
  }
}

TEST_CASE("force and moment of flat faces without sliding are the gradient of their energy") {
  std::mt19937_64 bits(6);
  const ContactLaw law = joint(1e9, 0);
  for (int i = 0; i < 50; ++i) {
    const Laid laid(bits, 1e-5, 2e-4);
    FaceOverlap3 faces;
    if (!flat_faces(laid.a, laid.b, faces)) continue;
    const LawInUse use{law};
    const auto pressed = [&](const PlacedSolid& b) {
      FaceOverlap3 f;
      REQUIRE(flat_faces(laid.a, b, f));
      return face_energy(plain_friction(use), f);
    };
    const SolidPressure p = face_pressure(laid.lower(), laid.upper(), plain_friction(use), faces);
    const Vec3 n = faces.plane.normal;
    const double h = 1e-8;
    PlacedSolid up = laid.b, down = laid.b;
    for (Vec3& x : up.corners) x += h * n;
    for (Vec3& x : down.corners) x -= h * n;
    CHECK(near(p.force.dot(n), -(pressed(up) - pressed(down)) / (2 * h), 1e-4));
  }
}

TEST_CASE("bricks side by side, apart or deep in each other are not flat faces") {
  const ConvexSolid one = brick(1, 1, 1);
  FaceOverlap3 faces;
  const PlacedSolid at_home = set_down(one, {}, Vec3::Zero());
  CHECK(!flat_faces(at_home, set_down(one, {}, Vec3(0, 0, 1.0001)), faces));
  CHECK(flat_faces(at_home, set_down(one, {}, Vec3(0, 0, 0.9999)), faces));
  CHECK(!flat_faces(at_home, set_down(one, {}, Vec3(0, 0, 0.9)), faces));
  CHECK(!flat_faces(at_home, set_down(one, rotation_by({0.02, 0, 0}), Vec3(0, 0, 0.9999)), faces));
  CHECK(!flat_faces(at_home, set_down(one, {}, Vec3(0.9999, 0, 0.9999)), faces));  // corner of edges: a strip too thin
  CHECK(!flat_faces(at_home, set_down(one, {}, Vec3(3, 0, 0.9999)), faces));
}
