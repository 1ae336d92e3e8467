// Relative motion of two ground motions below one structure.
#pragma once

#include <optional>

#include "load/motion.hpp"
#include "load/motion_measures.hpp"

namespace trilith {

/// Motion of `right` minus motion of `left` at time `t` [s]. The displacement includes the start displacements.
MotionAt relative_at(const GroundMotion& right, const GroundMotion& left, double t) noexcept;

/// Largest relative velocity [m/s] and largest change of the relative displacement from its start [m]. They are sampled
/// every `grid` [s] from the earlier start to the later end (10 samples per step of the finer motion if `grid` is 0).
struct RelativePeaks {
  Peak velocity;
  Peak displacement;
};
RelativePeaks relative_peaks(const GroundMotion& right, const GroundMotion& left, double grid = 0);

/// The first time [s], on the same grid, at which the relative displacement has changed by `level` [m] (above 0) in
/// either sense; none if it never does.
std::optional<double> relative_passage(const GroundMotion& right, const GroundMotion& left, double level,
                                       double grid = 0);

}  // namespace trilith
