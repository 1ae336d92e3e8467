// Longest explicit step for the water enclosed in joints through which it flows in stages of motion.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Shortens the stable step `other` of contacts, bearings and elements by the stiffness of the water: 1/dt^2 =
/// 1/other^2 + 1/water^2. The largest eigenvalue of a sum is at most the sum of the largest ones. As the water flows,
/// its force decays. An implicit Euler step of a spring in series with a dashpot is stable wherever the spring alone
/// is. Without water that flows between bodies the result is `other`.
double step_with_water(const Model<2>& model, const State<2>& state, double other);
double step_with_water(const Model<3>& model, const State<3>& state, double other);

}  // namespace trilith
