#include "geometry/plane/random_convex.hpp"

#include <cmath>

namespace trilith {
namespace {

/// Unit vector `way` quarter circles from the x axis; rational within each quarter: ((1-t^2), 2t)/(1+t^2).
Vec2 on_circle(double way) {
  const double whole = std::floor(way), t = way - whole, scale = 1 / (1 + t * t);
  Vec2 p((1 - t * t) * scale, 2 * t * scale);
  for (int quarter = static_cast<int>(whole) & 3; quarter > 0; --quarter) p = left_of(p);
  return p;
}

}  // namespace

/// A double in [0, 1) has 53 bits.
double random_between(std::mt19937_64& bits, double low, double high) {
  return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
}

int random_count(std::mt19937_64& bits, int low, int high) {
  return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
}

Vec2 random_direction(std::mt19937_64& bits) {
  return on_circle(random_between(bits, 0, 4));
}

/// Corners in order around an ellipse, so that the polygon is convex, about its centroid and randomly rotated.
Polygon random_convex(std::mt19937_64& bits, const RandomConvex& wanted) {
  const int n = random_count(bits, wanted.fewest_corners, wanted.most_corners);
  const double size = random_between(bits, wanted.smallest, wanted.largest);
  const double ratio = random_between(bits, 1, wanted.slenderest);
  const double start = random_between(bits, 0, 4);
  Polygon outline;
  for (int i = 0; i < n; ++i) {
    // One corner in each n-th of the ellipse, away from the ends of the section: no two are very near.
    const double within = random_between(bits, 0.15, 0.85);
    const Vec2 p = on_circle(start + 4 * (i + within) / n);
    outline.emplace_back(size / 2 * p.x(), size / (2 * ratio) * p.y());
  }
  const Vec2 centre = polygon_moments(outline).centroid;
  for (Vec2& p : outline) p -= centre;
  return placed(outline, random_direction(bits), Vec2::Zero());
}

Polygon placed(const Polygon& outline, const Vec2& direction, const Vec2& shift) {
  Polygon moved;
  moved.reserve(outline.size());
  for (const Vec2& p : outline) moved.push_back(shift + p.x() * direction + p.y() * left_of(direction));
  return moved;
}

}  // namespace trilith
