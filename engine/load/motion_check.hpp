// Is a ground motion fit to shake a model? Asked before the run.
#pragma once

#include <string>

#include "load/motion.hpp"

namespace trilith {

enum class Drift { refuse, allow };

/// "" where the motion can be used, otherwise one line that says why not and what to try.
///
/// Refused are
/// - a motion whose acceleration is zero everywhere;
/// - a motion that drifts (unless `drift` allows it): the ground does not come to rest, because
///   |v_end| > 10 % of PGV, or because |v_end| > 1 % of PGV while the mean velocity over the last quarter of the record
///   is above 5 % of PGV, which is ground that still travels one way.
/// A permanent offset alone is no drift: faults leave one. Limits from the processed records of 36 stations, whose end
/// velocity reaches 6.1 % of PGV with 0.2 % mean velocity, and from records integrated from the wrong start velocity,
/// which end at 7 % with 12 % mean velocity, or worse.
std::string why_not_usable(const GroundMotion& motion, Drift drift = Drift::refuse);

/// Throws InputError with the text of why_not_usable where that is not empty.
void check_usable(const GroundMotion& motion, Drift drift = Drift::refuse);

/// The start velocity [m/s] from which the motion's mean velocity is zero: the first guess where a record does not say.
double balanced_start_velocity(const GroundMotion& motion);

}  // namespace trilith
