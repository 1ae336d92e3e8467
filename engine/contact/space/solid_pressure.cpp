#include "contact/space/solid_pressure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "base/simd/lanes.hpp"
#include "contact/plane/depth_partition.hpp"
#include "contact/space/pressed_triangles.hpp"
#include "contact/space/sampled_triangles.hpp"

namespace trilith {
namespace {

// Stages of one call. First the depths of all points of the shared solid below the faces of both. Then for each face of
// the shared solid its rim as a loop of points, and the cells in which one face of the other solid is nearest, as
// triangles. Last, four triangles at a time, the pressure and its moments.

/// For a law with nonlinear pressure.
template <class K>
PressedSums sampled_triangles(std::span<const FourTriangles> triangles, const K& law, const ClosingMotion& motion,
                              const Vec3* along) {
  Vec3 push = Vec3::Zero();
  for (const FourTriangles& in : triangles) push += sampled_push(in, law);
  const DampedMotion damped(along == nullptr ? push : *along, motion);
  TriangleSums sums;
  for (const FourTriangles& in : triangles) sum_sampled(in, law, damped, sums);
  return over_lanes(sums, damped.normal, along == nullptr ? nullptr : &push);
}

/// A face of the walker inside the owner. Its part deeper than `crushed` [m] carries pressure for the excess depth.
class PressedFace {
 public:
  /// `normal`: out of the walker. The force on b is along -n where b walks, because n points from b into a, and along
  /// +n where a does.
  PressedFace(const Vec3& normal, bool walker_is_b, double crushed, TriangleLanes& triangles)
      : face_{normal.x(), normal.y(), normal.z(), walker_is_b ? -1.0 : 1.0},
        crushed_(crushed),
        triangles_(triangles),
        owner_(walker_is_b ? 0 : 1) {}

  /// 0: a, 1: b.
  [[nodiscard]] std::size_t owner() const { return owner_; }

  /// Adds one cell, over which the depth is linear.
  void add_cell(const PressedPolygon& cell) const {
    if (!(crushed_ > 0)) return add_triangles(cell);
    CornerHeights left;
    for (std::size_t i = 0; i < cell.count; ++i) left[i] = cell.corner[i].depth - crushed_;
    PressedPolygon deeper;
    keep_above(cell, left, deeper);
    for (std::size_t i = 0; i < deeper.count; ++i)
      deeper.corner[i].depth = larger(deeper.corner[i].depth - crushed_, 0.0);
    add_triangles(deeper);
  }

 private:
  /// The triangles of a polygon about its first corner.
  void add_triangles(const PressedPolygon& of) const {
    const auto corner = [&](std::size_t i) TRILITH_INLINE_LAMBDA {
      const PressedPoint& p = of.corner[i];
      return Lanes{p.arm.x(), p.arm.y(), p.arm.z(), p.depth};
    };
    for (std::size_t i = 2; i < of.count; ++i) triangles_.add(face_, corner(0), corner(i - 1), corner(i));
  }

  Lanes face_;
  double crushed_;
  TriangleLanes& triangles_;
  std::size_t owner_;
};

/// The shared solid, and the depths of its points in both.
struct PressedSolid {
  const SolidOverlapBuffer& shared;
  Vec3 origin;                       // origin of arms
  double noise;                      // see CellCutter
  std::array<DepthTable, 2> depths;  // below the faces of a and of b

  PressedSolid(const MovingSolid& a, const MovingSolid& b, SolidOverlapBuffer& of)
      : shared(of),
        origin(of.points[static_cast<std::size_t>(of.edges[0].from)]),
        noise(1e-13 * (a.placed.solid->size + b.placed.solid->size)),
        depths{DepthTable(a.placed, origin, arms(of), of.depths[0]),
               DepthTable(b.placed, origin, of.arm, of.depths[1])} {}
  [[nodiscard]] const Vec3& arm(int point) const { return shared.arm[static_cast<std::size_t>(point)]; }

 private:
  [[nodiscard]] std::span<const Vec3> arms(SolidOverlapBuffer& of) const {
    of.arm.clear();
    for (const Vec3& x : of.points) of.arm.push_back(x - origin);
    return of.arm;
  }
};

/// Presses a part of a face of the walker against the owner's nearest faces. If one face is nearest to all corners it
/// is nearest to the whole part, because depths are linear.
void press_rim(const PressedSolid& solid, const DepthTable& owner, const Rim& rim, const PressedFace& face) {
  const int nearest = owner.nearest(rim.point[0]);
  const auto end = rim.point.begin() + static_cast<std::ptrdiff_t>(rim.count);
  if (std::all_of(rim.point.begin(), end, [&](int p) { return owner.nearest(p) == nearest; })) {
    PressedPolygon cell;
    for (std::size_t i = 0; i < rim.count; ++i)
      cell.add({solid.arm(rim.point[i]), larger(owner.row(rim.point[i])[nearest], 0.0)});
    return face.add_cell(cell);
  }
  CellCutter cutter(owner, solid.shared.arm, rim, solid.noise);
  for (std::size_t f = 0; f < cutter.faces(); ++f)
    if (const PressedPolygon* cell = cutter.cell(f)) face.add_cell(*cell);
}

using RimEdges = std::span<const SolidOverlapBuffer::Edge>;

/// The points of these edges in connected order; false where rounding leaves more than one loop, or the loop exceeds
/// the capacity.
bool make_rim(RimEdges edges, Rim& rim) {
  if (edges.size() < 3 || edges.size() > Rim::most) return false;
  const int first = edges[0].from;
  int at = first;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i > 0 && at == first) return false;
    rim.add(at);
    std::size_t next = i;  // usually the next in the list
    if (edges[i].from != at)
      for (next = 0; next < edges.size() && edges[next].from != at;) ++next;
    if (next == edges.size()) return false;
    at = edges[next].to;
  }
  return at == first;
}

/// One face of the shared solid: as a whole, or as triangles about one of its points for nonlinear laws, whose
/// quadrature improves with smaller cells.
void press_face(const PressedSolid& solid, const PressedFace& face, RimEdges edges, bool whole) {
  const DepthTable& owner = solid.depths[face.owner()];
  if (owner.columns() == 0) return;  // a piece without surface carries no pressure
  Rim rim;
  if (whole && make_rim(edges, rim)) return press_rim(solid, owner, rim, face);
  const int base = edges[0].from;
  for (const auto& [from, to] : edges) {
    if (from == base || to == base) continue;
    Rim triangle;
    for (const int point : {base, from, to}) triangle.add(point);
    press_rim(solid, owner, triangle, face);
  }
}

/// Second moments per area or force about `middle`.
Eigen::Matrix3d spread_about(const std::array<double, 6>& second, double whole, const Vec3& middle) {
  const auto& [xx, yy, zz, xy, yz, zx] = second;
  Eigen::Matrix3d about;
  about << xx, xy, zx, xy, yy, yz, zx, yz, zz;
  return about / whole - middle * middle.transpose();
}

/// The normal of the solid's face that a face of the shared solid belongs to.
const Vec3& normal_of(const PlacedSolid& a, const PlacedSolid& b, int of) {
  return of >= 0 ? a.normals[static_cast<std::size_t>(of)] : b.normals[static_cast<std::size_t>(-1 - of)];
}
bool is_pressed(const PlacedSolid& a, const PlacedSolid& b, int of) {
  return of >= 0 ? a.solid->is_pressed(of) : b.solid->is_pressed(-1 - of);
}

/// Lists the triangles of all pressed faces of the shared solid.
void list_triangles(const PressedSolid& solid, const PlacedSolid& a, const PlacedSolid& b, bool whole, double crushed,
                    TriangleLanes& triangles) {
  int first = 0;
  for (const auto& [of, end] : solid.shared.faces) {
    if (is_pressed(a, b, of)) {
      const RimEdges edges =
          RimEdges(solid.shared.edges).subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(end - first));
      press_face(solid, PressedFace(normal_of(a, b, of), of < 0, crushed, triangles), edges, whole);
    }
    first = end;
  }
}

template <class K>
SolidPressure press(const MovingSolid& a, const MovingSolid& b, const K& law, SolidOverlapBuffer& shared,
                    double crushed, const Vec3* along) {
  const PressedSolid solid(a, b, shared);
  TriangleLanes triangles(shared.triangles);
  list_triangles(solid, a.placed, b.placed, K::linear, crushed, triangles);
  const ClosingMotion motion{b.velocity_at(solid.origin) - a.velocity_at(solid.origin), b.spin - a.spin};
  const auto sums = [&] {
    if constexpr (K::linear)
      return pressed_triangles(triangles.all(), law.beta, motion, along);
    else
      return sampled_triangles(triangles.all(), law, motion, along);
  };
  SolidPressure out = pressure_of_sums(solid.origin, 0.5 * law.kn, sums());
  if (along != nullptr) out.along = *along;
  return out;
}

}  // namespace

Vec3 line_across(const Vec3& n) {
  int least = 0;
  n.cwiseAbs().minCoeff(&least);
  return cross(n, Vec3(Vec3::Unit(least))).normalized();
}

/// Cholesky decomposition: a = (sqrt(xx), xy / sqrt(xx)), b = (0, the root of the remainder).
std::array<Vec3, 2> spread_arms(double xx, double xy, double yy, const Vec3& x, const Vec3& y) {
  if (!(xx > 0)) return {Vec3(Vec3::Zero()), Vec3(std::sqrt(std::max(0.0, yy)) * y)};
  const double along = std::sqrt(xx), aside = xy / along;
  return {Vec3(along * x + aside * y), Vec3(std::sqrt(std::max(0.0, yy - aside * aside)) * y)};
}

SolidPressure pressure_of_sums(const Vec3& origin, double k, const PressedSums& sums) {
  if (!(sums.area > 0)) return {};
  SolidPressure out;
  out.force = k * sums.force, out.damping = k * sums.damping;
  out.damped = k * sums.damped, out.pressure = k * sums.pressure, out.depth = sums.depth;
  out.area = 0.5 * sums.area;
  const Vec3 middle = sums.area_arm / sums.area;
  const Vec3 arm = sums.pressure > 0 ? Vec3(sums.arm / sums.pressure) : middle;
  out.centre = origin + arm, out.middle = origin + middle;
  out.moment = k * sums.moment - cross(arm, out.force);
  out.damping_moment = k * sums.damping_moment - cross(arm, out.damping);
  const Vec3 n = out.force.squaredNorm() > 0 ? Vec3(out.force.normalized()) : Vec3(Vec3::UnitZ());
  const Vec3 x = line_across(n), y = cross(n, x);
  const auto in_plane = [&](const Eigen::Matrix3d& of, const auto& take) {
    return take(x.dot(of * x), x.dot(of * y), y.dot(of * y));
  };
  in_plane(spread_about(sums.area_second, sums.area, middle), [&](double xx, double xy, double yy) {
    out.radius = std::sqrt(std::max(0.0, xx + yy)), out.arm = spread_arms(xx, xy, yy, x, y);
  });
  if (sums.pressure > 0)
    in_plane(spread_about(sums.arm_second, sums.pressure, arm),
             [&](double xx, double xy, double yy) { out.friction_arm = mean_distance(xx + yy, xx * yy - xy * xy); });
  return out;
}

SolidPressure solid_pressure(const MovingSolid& a, const MovingSolid& b, const LawInUse& law,
                             SolidOverlapBuffer& shared, double crushed, const Vec3* along) {
  if (shared.faces.empty()) return {};
  return with_kernel(law, [&](const auto& kernel) { return press(a, b, kernel, shared, crushed, along); });
}

}  // namespace trilith
