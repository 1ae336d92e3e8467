// How four free rigid bodies turn in space at once: as element/rigid/rigid_turn.hpp.
#pragma once

#include "base/simd/lane_vectors.hpp"

namespace trilith {

/// Unit quaternions.
struct RotationInLanes {
  Lanes w, x, y, z;
};

struct TurningInLanes {
  RotationInLanes rotation;  ///< in: now; out: after the step
  Triple<Lanes> spin;        ///< in: now; out: after the step, of the body as it is turned then [rad/s]
  Triple<Lanes> next;        ///< out: after the moment, of the body as it is turned now [rad/s]
  Triple<Lanes> moment;      ///< [N m]
  Triple<Lanes> inertia;     ///< principal moments [kg m2]
};

/// The moment works for a time `span`, then the bodies turn freely for `dt` [s].
void turn_four(TurningInLanes& bodies, double span, double dt);

}  // namespace trilith
