// Flat faces in space under a power of the overlap: closed forms, energy, and the two other ways to the same force.
#include "contact/space/sampled_faces.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "contact/space/solid_contact.hpp"
#include "contact/space/solid_energy.hpp"
#include "contact/space/solid_faces.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;
using testing::near_zero;

namespace {

constexpr double flat_secant = 1e9, flat_reach = 1e-4, wide = 1, deep = 0.6;

ContactLaw law_of_power(double exponent, double beta = 0) {
  return Power{flat_secant, flat_reach, exponent, 0, 0, beta};
}

/// A block of 1 m x 0.6 m that is pressed by `overlap` [m] at its middle into a larger one and tilted about y.
struct PressedBlock {
  ConvexSolid ground = convex_solid(box_solid(Vec3(-2, -2, -1), Vec3(2, 2, 0)), "ground");
  ConvexSolid block = convex_solid(box_solid(Vec3(-wide / 2, -deep / 2, 0), Vec3(wide / 2, deep / 2, 1)), "block");
  PlacedSolid a, b;

  PressedBlock(double overlap, double tilt) {
    place(ground, Turn3(UnitQuaternion()), Vec3::Zero(), a);
    place(block, Turn3(rotation_by(Vec3(0, tilt, 0))), Vec3(0, 0, -overlap), b);
  }
  [[nodiscard]] FaceOverlap3 faces() const {
    FaceOverlap3 out;
    REQUIRE(flat_faces(a, b, out));
    return out;
  }
  [[nodiscard]] SolidPressure sampled(const ContactLaw& law, const Vec3& velocity = Vec3::Zero(),
                                      const Vec3& spin = Vec3::Zero()) const {
    std::vector<FourTriangles> room;
    return sampled_face_pressure(at_rest(a), {b, Vec3::Zero(), velocity, spin}, {law}, faces(), room);
  }
  [[nodiscard]] double energy(const ContactLaw& law) const {
    std::vector<FourTriangles> room;
    return sampled_face_energy({law}, faces(), room);
  }
  [[nodiscard]] static MovingSolid at_rest(const PlacedSolid& solid) {
    return {solid, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  }
};

}  // namespace

TEST_CASE("evenly pressed faces in space press by kn d (overlap/d)^n over their area") {
  for (const double exponent : {1.0, 1.3, 1.5, 2.0, 2.7, 3.0})
    for (const double overlap : {1e-6, 1e-5, flat_reach, 5e-4}) {
      const SolidPressure p = PressedBlock(overlap, 0).sampled(law_of_power(exponent));
      const double pressure = flat_secant * flat_reach * std::pow(overlap / flat_reach, exponent);
      CHECK(near(p.force.z(), pressure * wide * deep, 1e-9));
      CHECK(near(p.area, wide * deep, 1e-12));
      CHECK(near_zero((p.centre - p.middle).norm(), 1e-12));
      CHECK(near(PressedBlock(overlap, 0).energy(law_of_power(exponent)),
                 pressure * wide * deep * overlap / (exponent + 1), 2e-5));
    }
}

TEST_CASE("tilted faces press by the integral of the power, closed or open in part") {
  for (const double exponent : {1.0, 1.3, 1.5, 2.0, 3.0})
    for (const double tilt : {1e-4, 3e-4, 1e-3}) {  // the second closes the edge, the third opens a part of the face
      const double overlap = 1.5e-4, c0 = std::max(0.0, overlap - tilt * wide / 2), c1 = overlap + tilt * wide / 2;
      const SolidPressure p = PressedBlock(overlap, tilt).sampled(law_of_power(exponent));
      const double scale = flat_secant * std::pow(flat_reach, 1 - exponent) * deep / tilt;
      const auto power = [&](double n) { return (std::pow(c1, n) - std::pow(c0, n)) / n; };
      const double force = scale * power(exponent + 1);
      // The centre of pressure, where the overlap is the ratio of its first moment to the force.
      const double at = (power(exponent + 2) / power(exponent + 1) - overlap) / tilt;
      CHECK(near(p.force.norm(), force, 2e-5));
      CHECK(near_zero(std::abs(p.centre.x()) - at, 2e-5 * wide));
      CHECK(near(p.area, deep * (c1 - c0) / tilt, 1e-5));
    }
}

TEST_CASE("the force of sampled faces is the derivative of their energy") {
  for (const double exponent : {1.3, 1.5, 2.7})
    for (const double tilt : {0.0, 5e-5, 1.5e-4, 1e-3}) {
      const double overlap = 1.5e-4, h = 1e-8;
      const ContactLaw law = law_of_power(exponent);
      const double slope =
          (PressedBlock(overlap + h, tilt).energy(law) - PressedBlock(overlap - h, tilt).energy(law)) / (2 * h);
      CHECK(near(PressedBlock(overlap, tilt).sampled(law).force.z(), slope, 1e-4));
    }
}

TEST_CASE("with the exponent 1 sampled faces have the pressure of linear ones, with damping") {
  const Vec3 velocity(0.01, -0.02, -0.03), spin(0.01, 0.02, 0.005);
  for (const double beta : {0.0, 1e-4}) {
    const PressedBlock block(3e-4, 1e-4);  // closed over the whole face, also with damping
    const SolidPressure one = block.sampled(law_of_power(1, beta), velocity, spin);
    const SolidPressure two = face_pressure(PressedBlock::at_rest(block.a), {block.b, Vec3::Zero(), velocity, spin},
                                            PlainFriction(Frictional{flat_secant, 0, 0, beta}, 1, 0), block.faces());
    const double size = two.force.norm();
    CHECK((one.force - two.force).norm() <= 1e-9 * size);
    CHECK((one.damping - two.damping).norm() <= 1e-9 * size);
    CHECK((one.centre - two.centre).norm() <= 1e-9);
    CHECK((one.moment - two.moment).norm() <= 1e-9 * size);
    CHECK((one.damping_moment - two.damping_moment).norm() <= 1e-9 * size);
    CHECK(near_zero(one.damped - two.damped, 1e-9 * size));
    CHECK(near(one.area, two.area, 1e-9));
    CHECK(near(one.radius, two.radius, 1e-9));
    CHECK(near(one.friction_arm, two.friction_arm, 1e-6));
    CHECK(near(one.depth, two.depth, 1e-9));
    CHECK((one.middle - two.middle).norm() <= 1e-9);
  }
}

TEST_CASE("sampled faces press as the shared volume does, within the overlap over the width") {
  for (const double exponent : {1.5, 1.8})
    for (const double overlap : {1e-6, 1e-5, 1e-4}) {
      const PressedBlock block(overlap, 0);
      const ContactLaw law = law_of_power(exponent);
      SolidOverlapBuffer shared, part;
      solid_overlap(block.a, block.b, shared);
      const SolidPressure whole =
          solid_pressure(PressedBlock::at_rest(block.a), PressedBlock::at_rest(block.b), {law}, shared);
      const SolidPressure flat = block.sampled(law);
      const double off = 4 * overlap / deep;
      CHECK(near(flat.force.z(), whole.force.z(), off));
      CHECK(near(flat.area, whole.area, off));
      CHECK(near(flat.radius, whole.radius, off));
      CHECK(near(flat.friction_arm, whole.friction_arm, off));
      CHECK(near(block.energy(law), solid_energy(block.a, block.b, {law}, shared, part), 5 * off));
    }
}

TEST_CASE("a power contact takes pressure and energy from its flat faces") {
  const PressedBlock block(1e-4, 1e-4);
  const ContactLaw law = law_of_power(1.5);
  SolidOverlapBuffer shared, scratch;
  Separation3 apart;
  const SolidPressure p =
      pressure_between(PressedBlock::at_rest(block.a), PressedBlock::at_rest(block.b), {law}, apart, shared);
  CHECK((p.force - block.sampled(law).force).norm() == 0);
  CHECK(p.face_a >= 0);
  CHECK(solid_contact_energy(block.a, block.b, {}, {law}, shared, scratch) == block.energy(law));
  CHECK(apart.distance == 0);
}
