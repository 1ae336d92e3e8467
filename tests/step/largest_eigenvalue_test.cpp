// The bound of the largest eigenvalue of a small stiffness, from above and close to it.
#include "step/largest_eigenvalue.hpp"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>

#include "step/local_springs.hpp"

using namespace trilith;

namespace {

/// Of N random springs of stiffnesses that differ by up to `decades`.
template <int N>
Eigen::Matrix<double, N, N> random_springs(std::mt19937_64& random, int springs, double decades) {
  std::uniform_real_distribution<double> side(-1, 1), tenths(0, decades);
  Eigen::Matrix<double, N, N> m = Eigen::Matrix<double, N, N>::Zero();
  for (int i = 0; i < springs; ++i) {
    Eigen::Matrix<double, N, 1> b;
    for (int k = 0; k < N; ++k) b[k] = side(random);
    m += std::pow(10, tenths(random)) * b * b.transpose();
  }
  return m;
}

template <int N>
void check_bound(const Eigen::Matrix<double, N, N>& m) {
  using Solver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>>;
  const double largest = Solver(m, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff(),
               bound = largest_eigenvalue_bound<N>(m);
  CHECK(bound >= largest * (1 - 1e-13));
  CHECK(bound <= largest * std::pow(N, 1.0 / 64) * (1 + 1e-13));
}

}  // namespace

TEST_CASE("the bound of the largest eigenvalue lies above it and within a root of order 64 of the size") {
  std::mt19937_64 random(7);
  for (int i = 0; i < 2000; ++i) {
    const int springs = 1 + i % 9;
    const double decades = i % 13;
    check_bound(random_springs<3>(random, springs, decades));
    check_bound(random_springs<6>(random, springs, decades));
  }
  // One spring has but one; of even ones all are the same.
  const Eigen::Vector3d b(1, 2, -3);
  CHECK(largest_eigenvalue_bound<3>(b * b.transpose()) == doctest::Approx(14).epsilon(1e-12));
  CHECK(largest_eigenvalue_bound<3>(5 * Eigen::Matrix3d::Identity()) ==
        doctest::Approx(5 * std::pow(3, 1.0 / 64)).epsilon(1e-12));
  CHECK(largest_eigenvalue_bound<3>(Eigen::Matrix3d::Zero()) == 0);
}

TEST_CASE("rates neither run away nor vanish from 1e-150 to 1e150") {
  for (const double size : {1e-150, 1e-20, 1e20, 1e150}) {
    const Eigen::Matrix3d m = size * Eigen::Vector3d(1, 0.5, 0.25).asDiagonal().toDenseMatrix();
    CHECK(largest_eigenvalue_bound<3>(m) / size == doctest::Approx(1).epsilon(1e-8));
  }
}

TEST_CASE("a bound is raised by no more than row sums, and not by what is held") {
  std::mt19937_64 random(8);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Matrix3d m = random_springs<3>(random, 1 + i % 5, 6);
    double most = 0;
    raise_to_bound(most, m, 1, 1, {true, true, true});
    CHECK(most <= m.cwiseAbs().rowwise().sum().maxCoeff());
    double held = 0;
    raise_to_bound(held, m, 1, 1, {true, false, false});
    CHECK(held == doctest::Approx(m(0, 0)).epsilon(1e-12));
    double before = 2 * most;
    raise_to_bound(before, m, 1, 1, {true, true, true});
    CHECK(before == 2 * most);
  }
}
