// Triangles under a pressure that is linear over each, summed four at a time.
//
// Comes in: triangles of the pressed faces of two solids (contact/solid_pressure.hpp), each in one cell, with the depth
// and the closing speed at its corners. Goes out: force, moments, power and spread of the pressure, and how the area
// lies. With u = p + q + r the sum of the arms of its corners, s = f(p) + f(q) + f(r) that of a linear function at
// them, and A its area:
//
//   integral f = A s / 3                   integral f x = A / 12 (s u + f(p) p + f(q) q + f(r) r)
//   integral x x' = A / 12 (u u' + p p' + q q' + r r')
//   integral f x x' = A / 60 (s u u' + u w' + w u' + (s + 2 f(p)) p p' + ...),   w = f(p) p + f(q) q + f(r) r
#pragma once

#include <array>

#include "base/lane_vectors.hpp"

namespace trilith {

/// What a triangle counts for: the springs and the area, the springs with their damping, or both.
enum class TriangleShare { springs, damped, both };

/// Sums over triangles in the room of one pair of solids, all over half the stiffness. Moments are about the point that
/// arms are from.
struct PressedSums {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();            ///< on b
  Vec3 damping = Vec3::Zero(), damping_moment = Vec3::Zero();  ///< the part that damping adds
  double damped = 0;                                           ///< power that damping takes
  double pressure = 0;                                         ///< integral of the pressure, whatever way it acts
  Vec3 arm = Vec3::Zero();                                     ///< ... of the pressure times the arm
  std::array<double, 6> arm_second{};                          ///< ... and times its products: xx, yy, zz, xy, yz, zx
  double area = 0;                                             ///< of both sides
  Vec3 area_arm = Vec3::Zero();                                ///< integral of the arm over it
  std::array<double, 6> area_second{};                         ///< ... of its products
  double depth = 0;                                            ///< greatest [m]
};

struct SolidPressure;
/// What such sums come to, with arms from `origin` [m] and `k` half of the stiffness [Pa/m], as the faces of the other
/// solid bring the other half: moments about the centre of pressure, and how area and pressure are spread.
SolidPressure pressure_of_sums(const Vec3& origin, double k, const PressedSums& sums);

/// One corner of a triangle: its arm, its depth and its closing speed.
struct TriangleCorner {
  const Vec3& arm;
  double depth, closing;
};

/// Triangles by lanes, and the sums of those before.
class PressedTriangles {
 public:
  /// Four triangles; those of no share count for nothing.
  struct Four {
    std::array<Triple<Lanes>, 3> arm;
    std::array<Lanes, 3> depth, closing;
    Triple<Lanes> normal;
    Lanes sign, springs, damped;
  };

  explicit PressedTriangles(double beta);

  /// `normal`: of length 1, out of the solid that the triangle bounds, about which its corners run counter-clockwise;
  /// `sign`: 1 where the pressure pushes b along it, -1 where against it.
  void add(const Vec3& normal, double sign, TriangleShare share, const std::array<TriangleCorner, 3>& corners) {
    set(four_.normal, normal), four_.sign[count_] = sign;
    four_.springs[count_] = share == TriangleShare::damped ? 0 : 1;
    four_.damped[count_] = share == TriangleShare::springs ? 0 : 1;
    for (std::size_t i = 0; i < 3; ++i) {
      set(four_.arm[i], corners[i].arm);
      four_.depth[i][count_] = corners[i].depth, four_.closing[i][count_] = corners[i].closing;
    }
    if (++count_ == lane_count) flush();
  }

  /// Four at once, beside those that wait.
  void add_four(const Four& four);

  /// Of all triangles.
  PressedSums sums();

  /// PressedSums in each lane.
  struct Lane4 {
    Triple<Lanes> force, moment, damping, damping_moment, arm, area_arm;
    Lanes power, pressure, area, depth;
    std::array<Lanes, 6> arm_second, area_second;
  };

 private:
  void set(Triple<Lanes>& to, const Vec3& v) { to.x[count_] = v.x(), to.y[count_] = v.y(), to.z[count_] = v.z(); }
  void flush();
  void leave_out(int lane);

  double beta_;
  int count_ = 0;
  Four four_;
  Lane4 sums_;
};

}  // namespace trilith
