// Area, centroid and second moments of a plane figure, and four points that have the same moments.
#pragma once

#include <array>
#include <span>

#include "base/space.hpp"

namespace trilith {

struct OutlineMoments {
  double area = 0;                ///< [m2]
  Vec2 middle = Vec2::Zero();     ///< centroid [m]
  double xx = 0, xy = 0, yy = 0;  ///< about the centroid [m4]

  OutlineMoments() = default;
  /// Moments of a simple counter-clockwise polygon.
  explicit OutlineMoments(std::span<const Vec2> corners);

  /// Adds another figure, or subtracts a hole where `sign` is -1. The centroid is unchanged where the remaining area is
  /// 0.
  void add(const OutlineMoments& other, double sign);

  [[nodiscard]] bool has_axis() const;
  /// Unit vector of the principal axis of the larger second moment; x if there is none.
  [[nodiscard]] Vec2 axis() const;
  /// Arms from the centroid to four points. With a quarter of the area each, they have the figure's centroid and second
  /// moments. For a rectangle they are the Gauss points.
  [[nodiscard]] std::array<Vec2, 4> arms() const;

 private:
  [[nodiscard]] double spread() const;
};

}  // namespace trilith
