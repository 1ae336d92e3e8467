// How large the values of a curve become.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace trilith::results {

/// The largest absolute value, of those that are finite; 0 where there is none.
inline double largest_value(const std::vector<double>& values) {
  double most = 0;
  for (const double v : values) most = std::isfinite(v) ? std::max(most, std::abs(v)) : most;
  return most;
}

}  // namespace trilith::results
