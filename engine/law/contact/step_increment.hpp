// How far bodies in space went in a step that an implicit scheme took.
//
// In a leapfrog step the velocity of now, times the step, is the way that was gone. An implicit step leads from place
// to place, with velocities of its end; what contacts slide by is then the way itself: of the point x of a body, which
// stands at p and was turned by R, and stood at p0 with R0,
//
//   x - p0 - R0 R' (x - p)
//
// The difference of two bodies is 0 to the last digits where both turn and move as one, however far.
#pragma once

#include "base/rotation_3d.hpp"

namespace trilith {

/// Of one body.
struct StepBehind {
  Vec3 place = Vec3::Zero(), place_before = Vec3::Zero();  ///< of its node at the end of the step and at its begin [m]
  UnitQuaternion rotation_before;
  Turn3 back{UnitQuaternion{}};  ///< from how it is turned now to how it was
  Vec3 turned = Vec3::Zero();    ///< the rotation vector of the step, in the world [rad]

  StepBehind() = default;
  StepBehind(const Vec3& now, const UnitQuaternion& rotation, const Vec3& before, const UnitQuaternion& was)
      : place(now),
        place_before(before),
        rotation_before(was),
        back(was * inverse(rotation)),
        turned(angle_of(rotation * inverse(was))) {}

  /// How far its point that is at x now has come [m].
  [[nodiscard]] Vec3 moved(const Vec3& x) const { return x - place_before - back.apply(Vec3(x - place)); }
};

// Mean motion over a step of length dt of a body with velocity_at, spin and `behind`, which is a StepBehind, or nullptr
// where its velocities are those of the step.

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

/// Mean velocity of b against a at x, in axes that have turned half of the way with both.
template <class BodySide>
Vec3 mean_slip(const BodySide& a, const BodySide& b, const Vec3& x, double dt) {
  const Vec3 rate = mean_velocity_at(b, x, dt) - mean_velocity_at(a, x, dt);
  if (a.behind == nullptr || b.behind == nullptr) return rate;
  return rate + 0.25 * cross(Vec3(a.behind->turned + b.behind->turned), rate);
}

}  // namespace trilith
