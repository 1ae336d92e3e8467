// Comparison of two tangent stiffness matrices that must agree.
#pragma once

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace trilith::testing {

/// Largest difference between two matrices, relative to the larger of the largest entries of `expected` in its row and
/// its column [1]. 0 for zero matrices.
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
