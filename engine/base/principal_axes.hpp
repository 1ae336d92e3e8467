// Principal values and axes of symmetric tensors in space, by Jacobi's rotations: with square roots alone, so that they
// have the same bits everywhere.
#pragma once

#include <Eigen/Core>

namespace trilith {

/// Principal values and axes (columns, right-handed), in no order.
struct PrincipalAxes {
  Eigen::Vector3d value;
  Eigen::Matrix3d axes;
};

/// Of a symmetric tensor. Terms off the diagonal of at most `nothing_left` count as 0.
PrincipalAxes principal_axes(const Eigen::Matrix3d& tensor, double nothing_left);

}  // namespace trilith
