// Two tangents that should be the same.
#pragma once

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace trilith::testing {

/// Largest difference between two matrices, as a share of the larger one of the largest entries of `expected` in its
/// row and its column. 0 where there is nothing but zeros.
inline double worst_difference(const Eigen::MatrixXd& found, const Eigen::MatrixXd& expected) {
  double worst = 0;
  for (Eigen::Index i = 0; i < expected.rows(); ++i)
    for (Eigen::Index j = 0; j < expected.cols(); ++j) {
      const double size = std::max(expected.row(i).cwiseAbs().maxCoeff(), expected.col(j).cwiseAbs().maxCoeff());
      if (size > 0) worst = std::max(worst, std::abs(found(i, j) - expected(i, j)) / size);
    }
  return worst;
}

}  // namespace trilith::testing
