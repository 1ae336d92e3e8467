// Factors of a sparse matrix whose pattern is symmetric and whose numbers are not: L D U, without pivoting.
//
// Tangents have such a pattern: what acts on a node is acted on by it. Their diagonal is heavy (stiffness, inertia), so
// rows stay in the order that fills least, and L and U, of one pattern, are found in one walk: row k of L and column k
// of U at a time, along the elimination tree (after Davis, "Algorithm 849: a concise sparse Cholesky factorization
// package", ACM Trans. Math. Softw. 31, 2005, with two triangles in place of one). Where a pivot is lost all the same,
// or a solution is not one, the matrix is factored anew with pivots (Eigen's SparseLU).
#pragma once

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <memory>
#include <vector>

namespace trilith {

class SparseFactors {
 public:
  /// Of a square matrix, compressed. False where it is singular. What is found depends on the matrix alone.
  bool compute(const Eigen::Map<const Eigen::SparseMatrix<double>>& matrix);
  /// x of A x = right.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  /// True where pivots were needed.
  [[nodiscard]] bool is_pivoted() const { return pivoted_ != nullptr; }

 private:
  using Matrix = Eigen::SparseMatrix<double>;
  void choose_order();
  bool factorise();
  [[nodiscard]] Eigen::VectorXd solve_once(const Eigen::VectorXd& right) const;
  bool is_good();

  Matrix matrix_, turned_;           // as given, and its transpose
  std::vector<int> column_, row_;    // its pattern, which the order was chosen for
  std::vector<int> order_, place_;   // [place] the unknown that stands there; [unknown] its place
  std::vector<int> parent_, first_;  // [place] in the elimination tree; [place + 1] where columns of L begin
  std::vector<int> index_;           // [entry] rows of the columns of L, which are the columns of the rows of U
  std::vector<double> l_, u_;        // [entry]
  std::vector<double> diagonal_;     // [place] D
  std::unique_ptr<Eigen::SparseLU<Matrix>> pivoted_;
};

}  // namespace trilith
