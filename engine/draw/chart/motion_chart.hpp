// Charts of ground motions for a report: three time histories and the response spectrum.
#pragma once

#include <vector>

#include "draw/chart/chart.hpp"
#include "load/motion.hpp"

namespace trilith::draw {

/// Acceleration [g], velocity and displacement over time in `units`, each with its peak.
Chart motion_chart(const GroundMotion& motion, const UnitSystem& units = {});

/// Pseudo-acceleration [g] over period, 5 % of critical damping, one line for each motion; both axes logarithmic.
Chart spectrum_chart(const std::vector<GroundMotion>& motions);

}  // namespace trilith::draw
