// Check of a ground motion before a run.
#pragma once

#include <string>

#include "load/motion.hpp"

namespace trilith {

enum class Drift { refuse, allow };

/// "" for a usable motion, otherwise one line with the reason and advice.
///
/// Rejected motions are:
///   - a motion whose acceleration is zero everywhere.
///   - a motion that drifts, unless `drift` permits it: the ground does not come to rest. Either |v_end| > 10 % of PGV,
///   or
///     |v_end| > 1 % of PGV and the mean velocity over the last quarter of the record is above 5 % of PGV.
/// A permanent offset alone is not a drift: faults cause one. The limits were derived from the processed records of 36
/// stations, whose end velocity reaches 6.1 % of PGV with 0.2 % mean velocity. Records integrated from a wrong start
/// velocity end at 7 % with 12 % mean velocity, or worse.
std::string why_not_usable(const GroundMotion& motion, Drift drift = Drift::refuse);

/// Throws InputError with the text of why_not_usable unless it is empty.
void check_usable(const GroundMotion& motion, Drift drift = Drift::refuse);

/// "" for a motion that ends at rest, within 1 % of PGV. Otherwise how fast the ground still moves at the end, and how
/// far it is from its start, in words for a note; also for a usable motion.
std::string end_drift(const GroundMotion& motion);

/// The start velocity [m/s] for which the motion's mean velocity is zero: a first estimate if a record does not contain
/// it.
double balanced_start_velocity(const GroundMotion& motion);

}  // namespace trilith
