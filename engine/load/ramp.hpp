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

/// By `distance` [m] likewise, but for a fifth of the time at either end, so that it speeds up by no more than
/// `acceleration` [m/s2] and takes at least `duration` [s].
GroundMotion gentle_motion(double distance, double acceleration, double duration);
/// The speed in the middle of it [m/s].
double gentle_speed(const GroundMotion& motion);

/// From `displacement` [m] at `velocity` [m/s] to rest within `duration` [s], above 0.
GroundMotion stopping_motion(double displacement, double velocity, double duration);

}  // namespace trilith
