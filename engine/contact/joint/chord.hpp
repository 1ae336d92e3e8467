// How far a point of a turning body goes within a leapfrog step.
//
// A leapfrog step leaves a body with the velocity of its middle and the place of its end. The point of the body that
// stands at `arm` from its node now went along a chord, at the mean velocity
//
//     velocity + spin x (arm - spin x arm dt / 2)
//
// to second order in spin dt. Without the part along the chord two bodies that turn as one would slide against each
// other by spin^2 r dt / 2, always in the same direction. Only arms enter, so every observer finds the same.
#pragma once

#include "base/rotation_3d.hpp"
#include "base/simd/lane_vectors.hpp"

namespace trilith {

/// What turns by less within a step has no chord to speak of, and is left as it is [rad].
inline constexpr double least_chord_turn = 1e-8;

/// In the plane, per arm [1/s]: for one body, or lane by lane.
template <class T>
TRILITH_INLINE T chord_rate(const T& spin, double dt) {
  const T turn2 = (dt * dt) * (spin * spin), none{};
  return select(turn2 > none + least_chord_turn * least_chord_turn, (0.5 * dt) * (spin * spin), none);
}

/// In space, lane by lane.
TRILITH_INLINE Triple<Lanes> chord_part(const Triple<Lanes>& spin, const Triple<Lanes>& arm, double dt) {
  const Lanes none{}, turn2 = (dt * dt) * spin.square();
  const Lanes half = select(turn2 > none + least_chord_turn * least_chord_turn, none + 0.5 * dt, none);
  return cross(spin, cross(spin, arm)) * (none - half);
}
inline Vec3 chord_part(const Vec3& spin, const Vec3& arm, double dt) {
  if (!(dt * dt * spin.squaredNorm() > least_chord_turn * least_chord_turn)) return Vec3::Zero();
  return -0.5 * dt * cross(spin, cross(spin, arm));
}

/// Mean velocity over the step of the point of a body that is at x now; after an implicit step, whose velocities are
/// those of its end, the velocity of now. `origin`: of the body's node [m].
template <class BodySide>
Vec3 chord_velocity_at(const BodySide& body, const Vec3& origin, const Vec3& x, double dt) {
  Vec3 velocity = body.velocity_at(x);
  if (body.behind == nullptr) velocity += chord_part(body.spin, Vec3(x - origin), dt);
  return velocity;
}

}  // namespace trilith
