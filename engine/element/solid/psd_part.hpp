// The positive semidefinite part of a tangent.
#pragma once

#include <Eigen/Eigenvalues>

namespace trilith {

/// Softening fibres give negative eigenvalues. A dashpot proportional to them would add energy, so they count as 0.
template <int N>
Eigen::Matrix<double, N, N> psd_part(const Eigen::Matrix<double, N, N>& tangent) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> modes(0.5 * (tangent + tangent.transpose()));
  return modes.eigenvectors() * modes.eigenvalues().cwiseMax(0).asDiagonal() * modes.eigenvectors().transpose();
}

}  // namespace trilith
