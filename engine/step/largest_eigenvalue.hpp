// The largest eigenvalue of a small stiffness, from above: what bounds of the longest stable step are made of.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

namespace trilith {

/// At least the largest eigenvalue of a symmetric N x N matrix that has none below 0, and at most N^(1/64) times that:
/// 1.02 for 3 x 3, 1.03 for 6 x 6. The root of order 32 of the Frobenius norm of the 32nd power, which is squared five
/// times and divided by its trace each time, so that no number runs away. 0 where the trace is not above 0.
template <int N>
double largest_eigenvalue_bound(const Eigen::Matrix<double, N, N>& m) {
  const double trace = m.trace();
  if (!(trace > 0)) return 0;
  Eigen::Matrix<double, N, N> power = m / trace;
  std::array<double, 5> traces;
  for (double& t : traces) {
    power = (power * power).eval();
    t = power.trace();
    power /= t;
  }
  double bound = power.norm();
  for (auto t = traces.rbegin(); t != traces.rend(); ++t) bound = std::sqrt(*t * bound);
  return trace * bound;
}

}  // namespace trilith
