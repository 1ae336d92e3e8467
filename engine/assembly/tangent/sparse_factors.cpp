#include "assembly/tangent/sparse_factors.hpp"

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <cmath>

namespace trilith {
namespace {

/// A pivot below this share of its diagonal entry and of the largest one of its row and column has lost all digits.
constexpr double least_pivot = 1e-12;
/// Largest residual of a solution, as a share of the largest term of a row.
constexpr double good_solution = 1e-9;

}  // namespace

bool SparseFactors::compute(const Eigen::Map<const Eigen::SparseMatrix<double>>& matrix) {
  matrix_ = matrix;
  pivoted_.reset();
  const auto size = static_cast<std::size_t>(matrix_.cols()), entries = static_cast<std::size_t>(matrix_.nonZeros());
  if (entries < size) return false;  // singular; SparseLU does not return without entries
  const int *column = matrix_.outerIndexPtr(), *row = matrix_.innerIndexPtr();
  const bool same = column_.size() == size + 1 && row_.size() == entries &&
                    std::equal(column_.begin(), column_.end(), column) && std::equal(row_.begin(), row_.end(), row);
  if (!same) {
    column_.assign(column, column + size + 1), row_.assign(row, row + entries);
    choose_order();
  }
  turned_ = matrix_.transpose();
  if (factorise() && is_good()) return true;
  pivoted_ = std::make_unique<Eigen::SparseLU<Matrix>>(matrix_);
  return pivoted_->info() == Eigen::Success;
}

/// Minimum degree order of A + A', and its elimination tree and columns of L.
void SparseFactors::choose_order() {
  const auto size = static_cast<std::size_t>(matrix_.cols());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> from;
  Eigen::AMDOrdering<int>()(matrix_, from);
  order_.assign(from.indices().data(), from.indices().data() + size);
  place_.resize(size);
  for (std::size_t k = 0; k < size; ++k) place_[order_[k]] = static_cast<int>(k);
  // Entry (i, k) above the diagonal leads from i up the tree to k, and all nodes on this path have an entry in row k of
  // L.
  std::vector<std::vector<int>> above(size);
  for (int c = 0; c < matrix_.cols(); ++c)
    for (Matrix::InnerIterator at(matrix_, c); at; ++at) {
      const int i = place_[at.row()], k = place_[c];
      if (i != k) above[std::max(i, k)].push_back(std::min(i, k));
    }
  parent_.assign(size, -1);
  std::vector<int> count(size, 0), seen(size, -1);
  for (int k = 0; k < static_cast<int>(size); ++k) {
    seen[k] = k;
    for (int i : above[k])
      for (; seen[i] != k; i = parent_[i]) {
        if (parent_[i] < 0) parent_[i] = k;
        ++count[i], seen[i] = k;
      }
  }
  first_.assign(size + 1, 0);
  for (std::size_t k = 0; k < size; ++k) first_[k + 1] = first_[k] + count[k];
  index_.resize(static_cast<std::size_t>(first_[size]));
  l_.resize(index_.size()), u_.resize(index_.size()), diagonal_.resize(size);
}

/// With w = D u for column k of U and z = l D for row k of L:
///
///     L w = a(:, k),   z U = a(k, :),   d_k = a_kk - sum z_i w_i / d_i.
///
/// Both are 0 except along the paths from the entries of row and column k up the tree.
bool SparseFactors::factorise() {
  const int size = static_cast<int>(matrix_.cols());
  std::vector<double> w(size, 0.0), z(size, 0.0);
  std::vector<int> path(size), stack(size), seen(size, -1), end(first_.begin(), first_.end() - 1);
  for (int k = 0; k < size; ++k) {
    int top = size;
    double pivot = 0, largest = 0;
    seen[k] = k;
    const auto scatter = [&](const Matrix& columns, std::vector<double>& to) {
      for (Matrix::InnerIterator at(columns, order_[k]); at; ++at) {
        int i = place_[at.row()], length = 0;
        largest = std::max(largest, std::abs(at.value()));
        if (i == k) pivot = at.value();
        if (i >= k) continue;
        to[i] += at.value();
        for (; seen[i] != k; i = parent_[i]) path[length++] = i, seen[i] = k;
        while (length > 0) stack[--top] = path[--length];
      }
    };
    scatter(matrix_, w), scatter(turned_, z);
    for (; top < size; ++top) {
      const int i = stack[top];
      const double wi = w[i], zi = z[i], per = 1 / diagonal_[i];
      w[i] = z[i] = 0;
      for (int at = first_[i]; at < end[i]; ++at) {
        w[index_[at]] -= l_[at] * wi;
        z[index_[at]] -= u_[at] * zi;
      }
      pivot -= zi * wi * per;
      const int at = end[i]++;
      index_[at] = k, l_[at] = zi * per, u_[at] = wi * per;
    }
    if (!(std::abs(pivot) > least_pivot * largest)) return false;
    diagonal_[k] = pivot;
  }
  return true;
}

Eigen::VectorXd SparseFactors::solve_once(const Eigen::VectorXd& right) const {
  const int size = static_cast<int>(matrix_.cols());
  std::vector<double> x(size);
  for (int k = 0; k < size; ++k) x[k] = right[order_[k]];
  for (int k = 0; k < size; ++k)
    for (int at = first_[k]; at < first_[k + 1]; ++at) x[index_[at]] -= l_[at] * x[k];
  for (int k = size - 1; k >= 0; --k) {
    double sum = x[k] / diagonal_[k];
    for (int at = first_[k]; at < first_[k + 1]; ++at) sum -= u_[at] * x[index_[at]];
    x[k] = sum;
  }
  Eigen::VectorXd out(size);
  for (int k = 0; k < size; ++k) out[order_[k]] = x[k];
  return out;
}

/// Solves for a right side without the symmetry of any structure; the residual shows whether the pivots were
/// sufficient.
bool SparseFactors::is_good() {
  Eigen::VectorXd right(matrix_.cols());
  for (Eigen::Index i = 0; i < right.size(); ++i) right[i] = 1 + 0.37 * static_cast<double>(i % 7);
  const Eigen::VectorXd x = solve_once(right), left = right - matrix_ * x;
  double most = right.cwiseAbs().maxCoeff();
  for (int c = 0; c < matrix_.cols(); ++c)
    for (Matrix::InnerIterator at(matrix_, c); at; ++at) most = std::max(most, std::abs(at.value() * x[c]));
  return left.cwiseAbs().maxCoeff() <= good_solution * most;
}

Eigen::VectorXd SparseFactors::solve(const Eigen::VectorXd& right) const {
  return pivoted_ != nullptr ? Eigen::VectorXd(pivoted_->solve(right)) : solve_once(right);
}

}  // namespace trilith
