// Damping of a beam of fibres, proportional to its tangent at the start of the step without the softening part.
//
// The matrix is constant within a step. A matrix of the tangent at the end of the step would jump whenever a fibre
// cracks, closes or yields between two iterations, and Newton's method would not converge over these jumps.
#pragma once

#include <Eigen/Core>

#include <span>

#include "element/solid/psd_part.hpp"

namespace trilith {

/// The part of a beam's memory that belongs to its damping: 1 after the first step, then the lower triangle of the
/// matrix for N strains [N/m] and so on.
template <int N>
struct FibreDamping {
  using Matrix = Eigen::Matrix<double, N, N>;
  static constexpr int memory_size = 1 + N * (N + 1) / 2;

  /// The matrix of this step. A beam in its first step has no earlier tangent and takes its present one.
  static Matrix matrix(std::span<const double> before, const Matrix& tangent) {
    if (before[0] == 0) return psd_part(tangent);
    Matrix out;
    std::size_t place = 1;
    for (int i = 0; i < N; ++i)
      for (int j = 0; j <= i; ++j) out(i, j) = out(j, i) = before[place++];
    return out;
  }
  /// The matrix of the next step, from the tangent at the end of this one.
  static void keep(const Matrix& tangent, std::span<double> after) {
    const Matrix next = psd_part(tangent);
    after[0] = 1;
    std::size_t place = 1;
    for (int i = 0; i < N; ++i)
      for (int j = 0; j <= i; ++j) after[place++] = next(i, j);
  }
};

}  // namespace trilith
