// Elements of one shape share their rows of Model::element_number, such as equal units of a wall. A step then reads
// several hundred bytes for each shape, not for each element.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace trilith {

/// Relative difference allowed between the numbers of two elements of one shape at this distance from the origin [1].
/// It covers the rounding of their positions, which grows in gradients and stiffness.
template <class Place>
double rounding_of(std::span<const Place> nodes) {
  constexpr double growth = 64;
  Place mean = Place::Zero();
  for (const Place& x : nodes) mean += x / static_cast<double>(nodes.size());
  double reach = 0, size = 0;
  for (const Place& x : nodes)
    reach = std::max(reach, x.cwiseAbs().maxCoeff()), size = std::max(size, (x - mean).norm());
  return growth * std::numeric_limits<double>::epsilon() * reach / size;
}

/// Numbers of one element in the order of Model::element_number: shape and gradients, `part` each, then the numbers
/// derived from them and the solid.
struct ElementNumbers {
  std::vector<double> all;
  std::size_t part;
  double rounding;  ///< see rounding_of [1]

  /// True if the numbers from `other` on belong to the same shape. Shape, gradients and the rest differ by many powers
  /// of ten, so each group is compared relative to its largest number.
  [[nodiscard]] bool are_those_of(const double* other) const {
    const auto are = [&](std::size_t from, std::size_t to) {
      double most = 0, off = 0;
      for (std::size_t i = from; i < to; ++i)
        most = std::max(most, std::abs(all[i])), off = std::max(off, std::abs(all[i] - other[i]));
      return off <= rounding * most;
    };
    return are(0, part) && are(part, 2 * part) && are(2 * part, all.size());
  }
};

/// Index of an element's numbers in `rows`. They are shared with one of the last `elements` of the same kind and solid,
/// for which `is_like(other)` is true, if the shapes agree; otherwise they are appended.
template <class E, class IsLike>
int shared_numbers(const std::vector<E>& elements, const IsLike& is_like, const ElementNumbers& numbers,
                   std::vector<double>& rows) {
  constexpr std::size_t most_shapes = 24, farthest = 4096;
  std::array<int, most_shapes> seen{};
  std::size_t shapes = 0;
  for (std::size_t back = 1; back <= std::min(farthest, elements.size()) && shapes < most_shapes; ++back) {
    const E& other = elements[elements.size() - back];
    const auto end = seen.begin() + static_cast<std::ptrdiff_t>(shapes);
    if (std::find(seen.begin(), end, other.first_number) != end) continue;
    seen[shapes++] = other.first_number;
    if (is_like(other) && numbers.are_those_of(&rows[static_cast<std::size_t>(other.first_number)]))
      return other.first_number;
  }
  const auto first = static_cast<int>(rows.size());
  rows.insert(rows.end(), numbers.all.begin(), numbers.all.end());
  return first;
}

}  // namespace trilith
