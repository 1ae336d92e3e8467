// Area, middle and second moments of a plane figure, and four points that have them all.
#pragma once

#include <array>
#include <span>

#include "base/space.hpp"

namespace trilith {

struct OutlineMoments {
  double area = 0;                ///< [m2]
  Vec2 middle = Vec2::Zero();     ///< [m]
  double xx = 0, xy = 0, yy = 0;  ///< about the middle [m4]

  OutlineMoments() = default;
  /// Of a simple polygon, counter-clockwise.
  explicit OutlineMoments(std::span<const Vec2> corners);

  /// That of another figure beside this one, or of a hole in it where `sign` is -1. The middle stays where nothing of
  /// the area is left.
  void add(const OutlineMoments& other, double sign);

  [[nodiscard]] bool has_axis() const;
  /// The principal axis of the larger second moment, of length 1: x where there is none.
  [[nodiscard]] Vec2 axis() const;
  /// Arms from the middle to four points: with a quarter of the area each they have its middle and its second moments.
  /// Of a rectangle they are the points of Gauss.
  [[nodiscard]] std::array<Vec2, 4> arms() const;

 private:
  [[nodiscard]] double spread() const;
};

}  // namespace trilith
