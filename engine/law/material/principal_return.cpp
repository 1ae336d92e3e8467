#include "law/material/principal_return.hpp"

#include <Eigen/Dense>

#include <cmath>

namespace trilith {
namespace {

/// Return to the planes of `set`; false where they do not meet in one point or a multiplier is negative.
bool return_to_set(const Eigen::Vector3d& trial, const Eigen::Matrix3d& elastic, std::span<const YieldPlane> planes,
                   std::span<const int> set, PrincipalReturn& out) {
  const auto count = static_cast<Eigen::Index>(set.size());
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  Eigen::Vector3d excess = Eigen::Vector3d::Zero();
  // f_i(trial) = sum_j n_i . D r_j multiplier_j: the stress lies exactly on each plane of the set after the return.
  for (Eigen::Index i = 0; i < count; ++i) {
    const YieldPlane& p = planes[set[i]];
    excess[i] = p.normal.dot(trial) - p.limit;
    for (Eigen::Index j = 0; j < count; ++j) matrix(i, j) = p.normal.dot(elastic * planes[set[j]].flow);
  }
  const auto block = matrix.topLeftCorner(count, count).eval();
  // Parallel or nearly parallel planes do not meet in one point.
  const double scale = block.diagonal().cwiseAbs().prod();
  if (!(std::abs(block.determinant()) > 1e-12 * scale)) return false;
  const Eigen::VectorXd multiplier = block.fullPivLu().solve(excess.head(count));
  if (multiplier.minCoeff() < 0) return false;
  out.plastic.setZero();
  for (Eigen::Index i = 0; i < count; ++i) out.plastic += multiplier[i] * planes[set[i]].flow;
  out.stress = trial - elastic * out.plastic;
  return true;
}

bool within(std::span<const YieldPlane> planes, const Eigen::Vector3d& stress, double tolerance) {
  for (const YieldPlane& p : planes)
    if (p.normal.dot(stress) - p.limit > tolerance) return false;
  return true;
}

}  // namespace

PrincipalReturn return_to_planes(const Eigen::Vector3d& trial, const Eigen::Matrix3d& elastic,
                                 std::span<const YieldPlane> planes, double size) {
  PrincipalReturn out;
  const double tolerance = 1e-11 * std::max(size, trial.cwiseAbs().maxCoeff());
  const int count = static_cast<int>(planes.size());
  // Sides first, then edges, then corners. With associated flow no other set would give a different result.
  const auto is_answer = [&](std::span<const int> set) {
    return return_to_set(trial, elastic, planes, set, out) && within(planes, out.stress, tolerance);
  };
  out.found = true;
  for (int i = 0; i < count; ++i)
    if (is_answer(std::array{i})) return out;
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count; ++j)
      if (is_answer(std::array{i, j})) return out;
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count; ++j)
      for (int k = j + 1; k < count; ++k)
        if (is_answer(std::array{i, j, k})) return out;
  out.found = false;
  return out;
}

}  // namespace trilith
