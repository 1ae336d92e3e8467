// Rotation of four free rigid bodies in space at once, by the method of element/rigid/rigid_turn.hpp.
#pragma once

#include "base/simd/lane_vectors.hpp"

namespace trilith {

/// Unit quaternions.
struct RotationInLanes {
  Lanes w, x, y, z;
};

struct TurningInLanes {
  RotationInLanes rotation;  ///< in: now; out: after the step
  Triple<Lanes> spin;        ///< in: now; out: after the step, for the new orientation [rad/s]
  Triple<Lanes> next;        ///< out: after the moment, for the present orientation [rad/s]
  Triple<Lanes> moment;      ///< [N m]
  Triple<Lanes> inertia;     ///< principal moments [kg m2]
};

/// The moment acts for a time `span`, then the bodies rotate freely for `dt` [s].
void turn_four(TurningInLanes& bodies, double span, double dt);

}  // namespace trilith
