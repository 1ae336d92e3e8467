// Two ground motions against each other: what a structure standing on both is pulled apart by.
#pragma once

#include <optional>

#include "load/motion.hpp"
#include "load/motion_measures.hpp"

namespace trilith {

/// Motion of `right` less motion of `left` at time `t` [s]. The displacement is as given, start displacements included.
MotionAt relative_at(const GroundMotion& right, const GroundMotion& left, double t) noexcept;

/// Largest relative velocity [m/s] and largest change of the relative displacement since its begin [m], sampled every
/// `grid` s from the earlier begin to the later end (10 samples to a step of the finer motion where `grid` is 0).
struct RelativePeaks {
  Peak velocity;
  Peak displacement;
};
RelativePeaks relative_peaks(const GroundMotion& right, const GroundMotion& left, double grid = 0);

/// The first time [s], on the same grid, at which the relative displacement has changed by `level` [m] (above 0) either
/// way since its begin; none where it never does.
std::optional<double> relative_passage(const GroundMotion& right, const GroundMotion& left, double level,
                                       double grid = 0);

}  // namespace trilith
