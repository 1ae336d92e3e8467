// Stacked bricks with random tilt and motion.
#pragma once

#include <random>

#include "contact/space/solid_contact.hpp"
#include "geometry/space/random_convex_3d.hpp"

namespace trilith::testing {

inline PlacedSolid set_down(const ConvexSolid& solid, const UnitQuaternion& rotation, const Vec3& at) {
  PlacedSolid out;
  place(solid, Turn3(rotation), at, out);
  return out;
}

inline ConvexSolid brick(double x, double y, double z) {
  return convex_solid(box_solid(Vec3(-x, -y, -z) / 2, Vec3(x, y, z) / 2), "brick");
}

inline ContactLaw joint(double kn, double beta) {
  Frictional law;
  law.kn = kn, law.beta = beta;
  return law;
}

/// A brick on a larger one, with random tilt and motion, both in a randomly rotated world.
struct Laid {
  ConvexSolid below = brick(1, 0.8, 0.3), above = brick(0.6, 0.5, 0.2);
  PlacedSolid a, b;
  Vec3 velocity, spin;

  Laid(std::mt19937_64& bits, double overlap, double tilt) {
    const UnitQuaternion world = random_rotation(bits);
    const Turn3 turn(world);
    const Vec3 lean = tilt * random_in_ball(bits), aside = 0.6 * random_in_ball(bits);
    a = set_down(below, world, turn.apply(Vec3(0, 0, -0.15)));
    b = set_down(above, world * rotation_by(lean), turn.apply(Vec3(aside.x(), 0.8 * aside.y(), 0.1 - overlap)));
    velocity = 0.01 * random_in_ball(bits), spin = 0.05 * random_in_ball(bits);
  }
  [[nodiscard]] Vec3 origin_of_b() const { return b.corners[0]; }
  [[nodiscard]] MovingSolid lower() const { return {a, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}; }
  [[nodiscard]] MovingSolid upper() const { return {b, origin_of_b(), velocity, spin}; }
};

}  // namespace trilith::testing
