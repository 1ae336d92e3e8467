// Closed form of VALIDATION M7: frequencies of masses on springs in a grid of up to three directions.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace trilith::testing {

/// Rising frequencies of masses of 10 kg with one degree of freedom each in a grid of `count` [Hz]. Springs of
/// `stiffness` [N/m] connect each mass to its neighbours and to walls on all sides:
///     w^2 = (4/m) sum k_i sin^2(pi n_i / (2 (N_i + 1)))
inline std::vector<double> grid_frequencies(const std::array<int, 3>& count, const std::array<double, 3>& stiffness) {
  std::vector<double> out;
  std::array<int, 3> n{};
  for (n[0] = 1; n[0] <= count[0]; ++n[0])
    for (n[1] = 1; n[1] <= count[1]; ++n[1])
      for (n[2] = 1; n[2] <= count[2]; ++n[2]) {
        double square = 0;
        for (int k = 0; k < 3; ++k)
          square += 4 / 10.0 * stiffness[k] * std::pow(std::sin(M_PI * n[k] / (2 * (count[k] + 1))), 2);
        out.push_back(std::sqrt(square) / (2 * M_PI));
      }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace trilith::testing
