// Displacement increments of bodies in space over a step of an implicit scheme.
//
// In a leapfrog step the displacement is the present velocity times the step. An implicit step computes positions, with
// velocities at its end; contacts then use the displacement itself. For a point x of a body with position p and
// rotation R, before the step p0 and R0, it is
//
//   x - p0 - R0 R' (x - p).
//
// The difference between two bodies is 0 to the last digits where both move as one, however far.
#pragma once

#include "base/rotation_3d.hpp"

namespace trilith {

/// Increment of one body.
struct StepBehind {
  Vec3 place = Vec3::Zero(), place_before = Vec3::Zero();  ///< of its node after and before the step [m]
  UnitQuaternion rotation_before;
  Turn3 back{UnitQuaternion{}};  ///< rotation from its present orientation back to its previous one
  Vec3 turned = Vec3::Zero();    ///< rotation vector of the step, in world axes [rad]

  StepBehind() = default;
  StepBehind(const Vec3& now, const UnitQuaternion& rotation, const Vec3& before, const UnitQuaternion& was)
      : place(now),
        place_before(before),
        rotation_before(was),
        back(was * inverse(rotation)),
        turned(angle_of(rotation * inverse(was))) {}

  /// Displacement of its point that is at x now [m].
  [[nodiscard]] Vec3 moved(const Vec3& x) const { return x - place_before - back.apply(Vec3(x - place)); }
};

// Mean motion over a step of length dt of a body with velocity_at, spin and `behind`. `behind` is a StepBehind, or
// nullptr where the body's velocities are the step's mean velocities.

template <class BodySide>
Vec3 mean_velocity_at(const BodySide& body, const Vec3& x, double dt) {
  if (body.behind == nullptr) return body.velocity_at(x);
  return dt > 0 ? Vec3(body.behind->moved(x) / dt) : Vec3(Vec3::Zero());
}
template <class BodySide>
Vec3 mean_spin(const BodySide& body, double dt) {
  if (body.behind == nullptr) return body.spin;
  return dt > 0 ? Vec3(body.behind->turned / dt) : Vec3(Vec3::Zero());
}

/// Mean velocity of b relative to a at x, in axes rotated by half of both rotations.
template <class BodySide>
Vec3 mean_slip(const BodySide& a, const BodySide& b, const Vec3& x, double dt) {
  const Vec3 rate = mean_velocity_at(b, x, dt) - mean_velocity_at(a, x, dt);
  if (a.behind == nullptr || b.behind == nullptr) return rate;
  return rate + 0.25 * cross(Vec3(a.behind->turned + b.behind->turned), rate);
}

}  // namespace trilith
