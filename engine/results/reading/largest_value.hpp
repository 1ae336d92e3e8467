// Largest absolute value of a curve.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace trilith::results {

/// The largest absolute value among finite ones; 0 if there is none.
inline double largest_value(const std::vector<double>& values) {
  double most = 0;
  for (const double v : values) most = std::isfinite(v) ? std::max(most, std::abs(v)) : most;
  return most;
}

}  // namespace trilith::results
