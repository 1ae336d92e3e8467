// Prescribed displacements as motions: from rest to rest, at constant speed, and to a stop.
#pragma once

#include "load/motion.hpp"

namespace trilith {

/// Displacement by `distance` [m] or [rad] within `duration` [s], from rest to rest. The acceleration rises and falls
/// linearly, once in each sense, so that the velocity is smooth and at most twice the mean. Afterwards the motion
/// remains at `distance`. Throws InputError for a distance that is 0 or not finite, and a duration not above 0.
GroundMotion ramp_motion(double distance, double duration);

/// Displacement by `distance` [m] at `speed` [m/s]. At first it accelerates like ramp_motion, for `ramp` [s], at least
/// 2 % and at most 20 % of the time. In the last 2 % it decelerates. Either sign of distance; throws InputError as
/// ramp_motion does.
GroundMotion even_motion(double distance, double speed, double ramp = 0);

/// Displacement by `distance` [m] with acceleration over 20 % of the time at either end: at most `acceleration` [m/s2],
/// and at least `duration` [s].
GroundMotion gentle_motion(double distance, double acceleration, double duration);
/// Its speed in the middle [m/s].
double gentle_speed(const GroundMotion& motion);

/// From `displacement` [m] at `velocity` [m/s] to rest within `duration` [s], above 0.
GroundMotion stopping_motion(double displacement, double velocity, double duration);

}  // namespace trilith
