// Integrals of linear pressure over parts of faces, exact.
//
// Pressure in water at rest is p(x) = w (h - z), with the weight w of its unit volume, the elevation z and the head h:
// the level of open water, or a linear function along a joint. Negative values count as 0.
//
// In the plane a part of a face extends from s0 to s1, relative to its length. The forces at the ends of the face do
// the work of the pressure,
//
//     f_a = l int p (1 - s) ds,   f_b = l int p s ds.
//
// In space a part is a convex polygon, cut into triangles of area A about its first corner:
//
//     int p dA = A (p1 + p2 + p3) / 3,   int p x dA = A ((p1 + p2 + p3) (x1 + x2 + x3) + sum p_i x_i) / 12.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "base/space.hpp"
#include "geometry/space/face_overlap_3d.hpp"

namespace trilith {

/// Integrals of p (1 - s) and p s [Pa].
struct EndShares {
  double a = 0, b = 0;
  EndShares& operator+=(const EndShares& o) {
    a += o.a, b += o.b;
    return *this;
  }
};

/// Over a pressure that is linear from p0 at s0 to p1 at s1 [Pa].
inline EndShares pressed_ends(double s0, double p0, double s1, double p1) {
  if (!(s1 > s0) || (p0 <= 0 && p1 <= 0)) return {};
  if (p0 < 0) s0 += p0 / (p0 - p1) * (s1 - s0), p0 = 0;
  if (p1 < 0) s1 -= p1 / (p1 - p0) * (s1 - s0), p1 = 0;
  const double width = s1 - s0, whole = 0.5 * (p0 + p1) * width;
  const double at_b = width * (p0 * (2 * s0 + s1) + p1 * (s0 + 2 * s1)) / 6;
  return {whole - at_b, at_b};
}

/// A convex polygon without allocation.
struct WetPolygon {
  static constexpr int most = 2 * max_face_corners + 8;
  int count = 0;
  std::array<Vec3, most> corner;

  void add(const Vec3& x) {
    if (count < most) corner[static_cast<std::size_t>(count++)] = x;
  }
  [[nodiscard]] const Vec3& at(int i) const { return corner[static_cast<std::size_t>(i)]; }
  [[nodiscard]] std::span<const Vec3> corners() const { return {corner.data(), static_cast<std::size_t>(count)}; }
};

/// A linear function of the position.
struct LinearField {
  double at = 0;              ///< at the origin
  Vec3 slope = Vec3::Zero();  ///< [1/m]
  [[nodiscard]] double operator()(const Vec3& x) const { return at + slope.dot(x); }
};

/// The part of a convex polygon where `field` is not negative (Sutherland and Hodgman 1974).
inline WetPolygon cut(std::span<const Vec3> corners, const LinearField& field) {
  WetPolygon out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 &x = corners[i], &y = corners[(i + 1) % corners.size()];
    const double f = field(x), g = field(y);
    if (f >= 0) out.add(x);
    if ((f > 0 && g < 0) || (f < 0 && g > 0)) out.add(x + f / (f - g) * (y - x));
  }
  return out;
}

/// Force and first moment of a pressure over polygons.
struct PressureSum {
  double force = 0;           ///< int p dA [N]
  Vec3 first = Vec3::Zero();  ///< int p x dA [N m]

  /// Adds `sign` times the integrals over the part of a polygon where the pressure is positive. `normal`: of its plane,
  /// on whose side its corners run counter-clockwise or clockwise.
  void add(std::span<const Vec3> polygon, const Vec3& normal, const LinearField& pressure, double sign) {
    const WetPolygon wet = cut(polygon, pressure);
    for (int i = 2; i < wet.count; ++i) {
      const Vec3 &x = wet.at(0), &y = wet.at(i - 1), &z = wet.at(i);
      const double area = 0.5 * std::abs(normal.dot(cross(Vec3(y - x), Vec3(z - x))));
      const double px = pressure(x), py = pressure(y), pz = pressure(z), sum = px + py + pz;
      force += sign * area * sum / 3;
      first += sign * area / 12 * (sum * (x + y + z) + px * x + py * y + pz * z);
    }
  }
};

}  // namespace trilith
