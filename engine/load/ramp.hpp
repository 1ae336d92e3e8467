// Prescribed displacements as motions: from rest to rest, evenly on, to a stop.
#pragma once

#include "load/motion.hpp"

namespace trilith {

/// By `distance` [m] or [rad] within `duration` [s], from rest to rest: the acceleration rises and falls linearly, each
/// way once, so that the velocity is smooth and twice the mean at most; at rest at `distance` from then on. Throws
/// InputError for a distance that is 0 or not finite, and a duration not above 0.
GroundMotion ramp_motion(double distance, double duration);

/// By `distance` [m] at `speed` [m/s], but for the first and the last fiftieth of the time, in which it gets going and
/// comes to rest as ramp_motion does. Either sign of distance; throws InputError as ramp_motion does.
GroundMotion even_motion(double distance, double speed);

/// From `displacement` [m] at `velocity` [m/s] to rest within `duration` [s], above 0.
GroundMotion stopping_motion(double displacement, double velocity, double duration);

}  // namespace trilith
