#include "base/principal_axes.hpp"

#include <doctest/doctest.h>

#include <Eigen/LU>

#include "near.hpp"

using namespace trilith;
using testing::near_zero;

TEST_CASE("principal values and axes compose the tensor, and the axes are orthonormal and right-handed") {
  // In the second one the signs of all differences of the diagonal and of the other terms are changed.
  for (const double sign : {1.0, -1.0}) {
    Eigen::Matrix3d tensor;
    tensor << 4, 1, -2, 1, 2, 0.5, -2, 0.5, 7;
    tensor *= sign;
    const PrincipalAxes found = principal_axes(tensor, 1e-14);
    const Eigen::Matrix3d again = found.axes * found.value.asDiagonal() * found.axes.transpose();
    CHECK(near_zero((again - tensor).norm(), 1e-12));
    CHECK(near_zero((found.axes.transpose() * found.axes - Eigen::Matrix3d::Identity()).norm(), 1e-13));
    CHECK(near_zero(found.axes.determinant() - 1, 1e-13));
  }
}

TEST_CASE("the principal values of pure shear are its size with both signs") {
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  tensor(0, 2) = tensor(2, 0) = 3;
  const PrincipalAxes found = principal_axes(tensor, 1e-14);
  CHECK(near_zero(found.value.maxCoeff() - 3, 1e-13));
  CHECK(near_zero(found.value.minCoeff() + 3, 1e-13));
  CHECK(near_zero(found.value[1], 1e-13));
}
