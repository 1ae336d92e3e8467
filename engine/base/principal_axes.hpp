// Principal values and axes of symmetric tensors in space by Jacobi rotations. They need square roots alone, so the
// bits are the same on every machine.
#pragma once

#include <Eigen/Core>

namespace trilith {

/// Principal values and axes (columns, right-handed), not sorted.
struct PrincipalAxes {
  Eigen::Vector3d value;
  Eigen::Matrix3d axes;
};

/// Eigenvalues and eigenvectors of a symmetric tensor. Off-diagonal terms of magnitude `nothing_left` or less count as
/// 0.
PrincipalAxes principal_axes(const Eigen::Matrix3d& tensor, double nothing_left);

}  // namespace trilith
