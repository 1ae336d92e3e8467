// Factors of a sparse matrix with a symmetric pattern and unsymmetric values: L D U, without pivoting.
//
// Tangents have such a pattern, because forces between nodes act on both. Their diagonal is large (stiffness, inertia),
// so the rows keep the order of least fill. L and U share one pattern and are found in one pass along the elimination
// tree: row k of L and column k of U at a time. The method follows Davis, "Algorithm 849: a concise sparse Cholesky
// factorization package", ACM Trans. Math. Softw. 31, 2005, with two triangles instead of one. If a pivot is lost, or a
// solution is inaccurate, the matrix is factorised again with pivoting (Eigen's SparseLU).
#pragma once

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <memory>
#include <vector>

namespace trilith {

class SparseFactors {
 public:
  /// Factorises a square, compressed matrix. False if it is singular. The result depends on the matrix alone.
  bool compute(const Eigen::Map<const Eigen::SparseMatrix<double>>& matrix);
  /// x of A x = right.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  /// True if pivoting was needed.
  [[nodiscard]] bool is_pivoted() const { return pivoted_ != nullptr; }

 private:
  using Matrix = Eigen::SparseMatrix<double>;
  void choose_order();
  bool factorise();
  [[nodiscard]] Eigen::VectorXd solve_once(const Eigen::VectorXd& right) const;
  bool is_good();

  Matrix matrix_, turned_;           // as given, and its transpose
  std::vector<int> column_, row_;    // pattern for which the order was chosen
  std::vector<int> order_, place_;   // [position] its unknown; [unknown] its position
  std::vector<int> parent_, first_;  // [position] in the elimination tree; [position + 1] begin of the columns of L
  std::vector<int> index_;           // [entry] rows of the columns of L, which are the columns of the rows of U
  std::vector<double> l_, u_;        // [entry]
  std::vector<double> diagonal_;     // [position] D
  std::unique_ptr<Eigen::SparseLU<Matrix>> pivoted_;
};

}  // namespace trilith
