// Factorisation of sparse matrices with symmetric pattern.
#include "assembly/tangent/sparse_factors.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace trilith::testing {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

bool compute(SparseFactors& factors, Matrix& matrix) {
  matrix.makeCompressed();
  return factors.compute(Eigen::Map<const Matrix>(matrix.rows(), matrix.cols(), matrix.nonZeros(),
                                                  matrix.outerIndexPtr(), matrix.innerIndexPtr(), matrix.valuePtr()));
}

/// A grid of springs, `side` by `side`, whose couplings differ in both directions by `skew`; its diagonal is multiplied
/// by `heavy`.
Matrix grid(int side, double skew, double heavy) {
  Matrix out(side * side, side * side);
  const auto number = [&](int i, int j) { return i * side + j; };
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const int n = number(i, j);
      out.coeffRef(n, n) += heavy * 4.1;
      for (const auto& [a, b] : {std::pair{i + 1, j}, std::pair{i, j + 1}}) {
        if (a == side || b == side) continue;
        out.coeffRef(n, number(a, b)) = -1 - skew * std::sin(n + 1.0);
        out.coeffRef(number(a, b), n) = -1 + skew * std::cos(3.0 * n);
      }
    }
  return out;
}

double left_of_solution(const SparseFactors& factors, const Matrix& matrix) {
  Eigen::VectorXd right(matrix.rows());
  for (Eigen::Index i = 0; i < right.size(); ++i) right[i] = 1 + std::sin(2.0 * static_cast<double>(i));
  return (matrix * factors.solve(right) - right).norm() / right.norm();
}

TEST_CASE("a matrix of symmetric pattern is solved with symmetric and unsymmetric values") {
  SparseFactors factors;
  for (const double skew : {0.0, 0.1, 0.7})
    for (const int side : {1, 2, 13, 40}) {
      Matrix matrix = grid(side, skew, 1);
      REQUIRE(compute(factors, matrix));
      CHECK(!factors.is_pivoted());
      CHECK(left_of_solution(factors, matrix) < 1e-12);
      // The same pattern again, with other numbers.
      matrix *= 3;
      REQUIRE(compute(factors, matrix));
      CHECK(left_of_solution(factors, matrix) < 1e-12);
    }
}

TEST_CASE("a matrix without a diagonal is factored with pivots, and a singular one is rejected") {
  SparseFactors factors;
  Matrix pair(2, 2);
  pair.insert(0, 1) = 2, pair.insert(1, 0) = 3, pair.insert(0, 0) = 0, pair.insert(1, 1) = 0;
  REQUIRE(compute(factors, pair));
  CHECK(factors.is_pivoted());
  CHECK(left_of_solution(factors, pair) < 1e-14);
  Matrix singular(2, 2);
  singular.insert(0, 0) = 1, singular.insert(1, 1) = 1, singular.insert(0, 1) = 1, singular.insert(1, 0) = 1;
  CHECK(!compute(factors, singular));
  // Bodies that touch nothing have no stiffness.
  Matrix empty(39, 39);
  CHECK(!compute(factors, empty));
}

}  // namespace
}  // namespace trilith::testing
