// The positive semidefinite part of a tangent.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace trilith {

/// Softening fibres give negative eigenvalues. A dashpot proportional to them would add energy, so they count as 0. A
/// tangent that has a Cholesky factor has none, which is the usual case and costs far less than the eigenvalues.
template <int N>
Eigen::Matrix<double, N, N> psd_part(const Eigen::Matrix<double, N, N>& tangent) {
  const Eigen::Matrix<double, N, N> even = 0.5 * (tangent + tangent.transpose());
  if (even.llt().info() == Eigen::Success) return even;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> modes(even);
  return modes.eigenvectors() * modes.eigenvalues().cwiseMax(0).asDiagonal() * modes.eigenvectors().transpose();
}

}  // namespace trilith
