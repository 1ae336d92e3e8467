// The part of a tangent that resists.
#pragma once

#include <Eigen/Eigenvalues>

namespace trilith {

/// Where fibres soften some eigenvalues are below 0; a dashpot of those would feed the motion, so they count as 0.
template <int N>
Eigen::Matrix<double, N, N> psd_part(const Eigen::Matrix<double, N, N>& tangent) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> modes(0.5 * (tangent + tangent.transpose()));
  return modes.eigenvectors() * modes.eigenvalues().cwiseMax(0).asDiagonal() * modes.eigenvectors().transpose();
}

}  // namespace trilith
