#include "base/principal_axes.hpp"

#include <array>
#include <cmath>

namespace trilith {
namespace {

/// One Jacobi rotation: rotates the columns p and q of `axes` so that m(p, q) becomes 0. The smaller of the two angles
/// is used (Golub and Van Loan, "Matrix computations", section on Jacobi methods).
void clear_term(Eigen::Matrix3d& m, Eigen::Matrix3d& axes, int p, int q) {
  const double tau = (m(q, q) - m(p, p)) / (2 * m(p, q));
  const double t = (tau < 0 ? -1 : 1) / (std::abs(tau) + std::sqrt(1 + tau * tau));
  const double c = 1 / std::sqrt(1 + t * t), s = t * c;
  for (int k = 0; k < 3; ++k) {
    const double kp = m(k, p), kq = m(k, q), ap = axes(k, p), aq = axes(k, q);
    m(k, p) = c * kp - s * kq, m(k, q) = s * kp + c * kq;
    axes(k, p) = c * ap - s * aq, axes(k, q) = s * ap + c * aq;
  }
  for (int k = 0; k < 3; ++k) {
    const double pk = m(p, k), qk = m(q, k);
    m(p, k) = c * pk - s * qk, m(q, k) = s * pk + c * qk;
  }
  m(p, q) = m(q, p) = 0;
}

}  // namespace

/// Rotates until the off-diagonal terms vanish. Convergence is quadratic, so a few sweeps are enough.
PrincipalAxes principal_axes(const Eigen::Matrix3d& tensor, double nothing_left) {
  Eigen::Matrix3d m = tensor, axes = Eigen::Matrix3d::Identity();
  for (int round = 0; round < 16; ++round) {
    bool cleared = false;
    for (const auto [p, q] : {std::array{0, 1}, std::array{0, 2}, std::array{1, 2}})
      if (std::abs(m(p, q)) > nothing_left) clear_term(m, axes, p, q), cleared = true;
    if (!cleared) break;
  }
  return {m.diagonal(), axes};
}

}  // namespace trilith
