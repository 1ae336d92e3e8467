#include "law/material/space_point.hpp"

namespace trilith {

SpaceMatrix elastic_in_space(double young, double poisson) {
  const double shear = young / (2 * (1 + poisson)), lambda = 2 * shear * poisson / (1 - 2 * poisson);
  SpaceMatrix c = SpaceMatrix::Zero();
  c.topLeftCorner<3, 3>() = lambda * Eigen::Matrix3d::Ones() + 2 * shear * Eigen::Matrix3d::Identity();
  c.bottomRightCorner<3, 3>() = shear * Eigen::Matrix3d::Identity();
  return c;
}

SpaceMatrix elastic_in_space(const Solid& solid) {
  return std::visit([](const auto& l) { return elastic_in_space(l.young, l.poisson); }, solid.law);
}

SpaceVector stress_in_space(const Solid& solid, const SpaceVector& strain, const SpaceMemory& memory) {
  return elastic_in_space(solid) * (strain - memory.strain());
}

Eigen::Matrix3d tensor_of_strain(const SpaceVector& e) {
  Eigen::Matrix3d t;
  t << e[0], 0.5 * e[3], 0.5 * e[5], 0.5 * e[3], e[1], 0.5 * e[4], 0.5 * e[5], 0.5 * e[4], e[2];
  return t;
}

}  // namespace trilith
