// Displacement of a point of a rotating body within a leapfrog step.
//
// A leapfrog step leaves a body with the velocity at its midpoint and the position at its end. The body's point that is
// at `arm` from its node now moved along a chord, at the mean velocity
//
//     velocity + spin x (arm - spin x arm dt / 2)
//
// to second order in spin dt. Without the part along the chord two bodies with a common rotation would slide relative
// to each other by spin^2 r dt / 2, always in the same direction. Only arms appear, so the result is independent of the
// frame.
#pragma once

#include "base/rotation_3d.hpp"
#include "base/simd/lane_vectors.hpp"

namespace trilith {

/// Smaller rotations within a step need no chord correction [rad].
inline constexpr double least_chord_turn = 1e-8;

/// In the plane, per unit arm [1/s]: for one body, or in lanes.
template <class T>
TRILITH_INLINE T chord_rate(const T& spin, double dt) {
  const T turn2 = (dt * dt) * (spin * spin), none{};
  return select(turn2 > none + least_chord_turn * least_chord_turn, (0.5 * dt) * (spin * spin), none);
}

/// In space, in lanes.
TRILITH_INLINE Triple<Lanes> chord_part(const Triple<Lanes>& spin, const Triple<Lanes>& arm, double dt) {
  const Lanes none{}, turn2 = (dt * dt) * spin.square();
  const Lanes half = select(turn2 > none + least_chord_turn * least_chord_turn, none + 0.5 * dt, none);
  return cross(spin, cross(spin, arm)) * (none - half);
}
inline Vec3 chord_part(const Vec3& spin, const Vec3& arm, double dt) {
  if (!(dt * dt * spin.squaredNorm() > least_chord_turn * least_chord_turn)) return Vec3::Zero();
  return -0.5 * dt * cross(spin, cross(spin, arm));
}

/// Mean velocity over the step of a body's point that is at x now. After an implicit step, whose velocities are at its
/// end, the present velocity. `origin`: of the body's node [m].
template <class BodySide>
Vec3 chord_velocity_at(const BodySide& body, const Vec3& origin, const Vec3& x, double dt) {
  Vec3 velocity = body.velocity_at(x);
  if (body.behind == nullptr) velocity += chord_part(body.spin, Vec3(x - origin), dt);
  return velocity;
}

}  // namespace trilith
