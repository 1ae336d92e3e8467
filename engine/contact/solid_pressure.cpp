#include "contact/solid_pressure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "base/lanes.hpp"
#include "contact/nearest_cells.hpp"
#include "contact/pressed_triangles.hpp"

namespace trilith {
namespace {

// Stages of one call: depths of all points of the shared solid below the faces of both; for each face of the shared
// solid, its rim as a loop of points; of each rim the cells in which one face of the other solid is nearest; over the
// triangles of each cell the pressure and its moments, four triangles at a time where the law is linear.

/// Integrals over a triangle, over kn: of the pressure and of its first moment about some point, of the pressure times
/// the closing speed, of its second moments (xx, yy, zz, xy, yz, zx).
struct TriangleSums {
  double force = 0, power = 0;
  Vec3 first = Vec3::Zero();
  std::array<double, 6> second{};
};

/// f(place in such a list, row, column) for all of them.
template <class F>
TRILITH_INLINE void for_products(F&& f) {
  f(0, 0, 0), f(1, 1, 1), f(2, 2, 2), f(3, 0, 1), f(4, 1, 2), f(5, 2, 0);
}

/// Six points of a triangle, exact to degree 4 (Dunavant 1985, as in contact/power.hpp), for laws that are not linear.
template <class Pressure>
void add_sampled(double area, const PressedPolygon& cell, const std::array<std::size_t, 3>& corners,
                 Pressure&& pressure, TriangleSums& sums) {
  constexpr std::array<std::array<double, 3>, 2> rule{{{0.108103018168070, 0.445948490915965, 0.223381589678011},
                                                       {0.816847572980459, 0.091576213509771, 0.109951743655322}}};
  for (const auto& [own, other, weight] : rule)
    for (const std::size_t i : {0U, 1U, 2U}) {
      const PressedPoint &p = cell.corner[corners[i]], &q = cell.corner[corners[(i + 1) % 3]],
                         &r = cell.corner[corners[(i + 2) % 3]];
      const double closing = own * p.closing + other * (q.closing + r.closing);
      const double at = weight * area * pressure(own * p.depth + other * (q.depth + r.depth), closing);
      sums.force += at, sums.power += at * closing;
      const Vec3 arm = own * p.arm + other * (q.arm + r.arm);
      sums.first += at * arm;
      for_products([&](std::size_t k, int row, int column) { sums.second[k] += at * arm[row] * arm[column]; });
    }
}

/// Adds a triangle to the area in contact.
void add_area(double area, const Vec3& p, const Vec3& q, const Vec3& r, PressedSums& sums) {
  const Vec3 sum = p + q + r;
  sums.area += area, sums.area_arm += area / 3 * sum;
  for_products([&](std::size_t k, int i, int j) {
    sums.area_second[k] += area / 12 * (sum[i] * sum[j] + p[i] * p[j] + q[i] * q[j] + r[i] * r[j]);
  });
}

/// Where what is pressed is summed up: triangles by lanes, and apart from them what laws come to that are not linear.
struct PressedParts {
  PressedTriangles triangles;
  PressedSums sampled;
};

/// A face of the walker inside the owner.
template <class K>
struct PressedFace {
  const K& law;
  Vec3 normal;  // out of the walker
  bool walker_is_b;
  double crushed;  // [m]
  PressedParts& parts;

  /// On b acts -n where b walks, as n then points from b into a, and +n where a does.
  [[nodiscard]] double sign() const { return walker_is_b ? -1 : 1; }

  /// Adds one cell, over which depth and closing speed are linear.
  void add_cell(const PressedPolygon& cell) const {
    if (crushed > 0)
      add_deeper_part(cell);
    else
      add_whole(cell);
  }

 private:
  void add_whole(const PressedPolygon& cell) const {
    if constexpr (K::linear)
      add_linear_cell(cell);
    else
      add_sampled_cell(cell);
  }

  /// The triangles of a polygon about its first corner.
  void add_triangles(const PressedPolygon& of, TriangleShare share) const {
    const auto corner = [&](std::size_t i) -> TriangleCorner {
      const PressedPoint& p = of.corner[i];
      return {p.arm, p.depth, p.closing};
    };
    for (std::size_t i = 2; i < of.count; ++i)
      parts.triangles.add(normal, sign(), share, {corner(0), corner(i - 1), corner(i)});
  }

  /// What of a cell lies deeper than the mortar is crushed, by the depth that is left to it.
  void add_deeper_part(const PressedPolygon& cell) const {
    CornerHeights left;
    for (std::size_t i = 0; i < cell.count; ++i) left[i] = cell.corner[i].depth - crushed;
    PressedPolygon deeper;
    keep_above(cell, left, deeper);
    for (std::size_t i = 0; i < deeper.count; ++i)
      deeper.corner[i].depth = larger(deeper.corner[i].depth - crushed, 0.0);
    if (deeper.count > 2) add_whole(deeper);
  }

  /// The damped pressure acts over the part of a cell where it is above 0.
  void add_linear_cell(const PressedPolygon& cell) const {
    CornerHeights damped;
    bool some = false, all = true;
    for (std::size_t i = 0; i < cell.count; ++i) {
      damped[i] = cell.corner[i].depth + law.beta * cell.corner[i].closing;
      some = some || damped[i] > 0, all = all && damped[i] >= 0;
    }
    add_triangles(cell, all ? TriangleShare::both : TriangleShare::springs);
    if (all || !some) return;
    PressedPolygon pressed;
    keep_above(cell, damped, pressed);
    add_triangles(pressed, TriangleShare::damped);
  }

  void add_sampled_cell(const PressedPolygon& cell) const {
    TriangleSums springs, total;
    const Vec3& p = cell.corner[0].arm;
    for (std::size_t i = 2; i < cell.count; ++i) {
      const Vec3 &q = cell.corner[i - 1].arm, &r = cell.corner[i].arm;
      const double area = 0.5 * normal.dot(cross(Vec3(q - p), Vec3(r - p)));
      const std::array<std::size_t, 3> at{0, i - 1, i};
      add_sampled(
          area, cell, at, [&](double d, double) { return law.effective(d); }, springs);
      add_sampled(
          area, cell, at, [&](double d, double c) { return std::max(0.0, law.effective(d) + law.beta * c); }, total);
      add_area(area, p, q, r, parts.sampled);
    }
    for (std::size_t i = 0; i < cell.count; ++i)
      parts.sampled.depth = std::max(parts.sampled.depth, cell.corner[i].depth);
    add_to(parts.sampled, springs, total);
  }

  void add_to(PressedSums& sums, const TriangleSums& springs, const TriangleSums& total) const {
    const Vec3 n = sign() * normal;
    sums.force += total.force * n, sums.moment += cross(total.first, n);
    sums.damping += (total.force - springs.force) * n;
    sums.damping_moment += cross(Vec3(total.first - springs.first), n);
    sums.damped += total.power - springs.power;
    sums.pressure += total.force, sums.arm += total.first;
    for (std::size_t i = 0; i < 6; ++i) sums.arm_second[i] += total.second[i];
  }
};

/// What is pressed: the shared solid, and how fast b moves away from a at its points.
struct PressedSolid {
  const SolidOverlapBuffer& shared;
  Vec3 origin;                       // of arms
  double noise;                      // see CellCutter
  std::array<DepthTable, 2> depths;  // below the faces of a and of b

  PressedSolid(const MovingSolid& a, const MovingSolid& b, SolidOverlapBuffer& of)
      : shared(of),
        origin(of.points[static_cast<std::size_t>(of.edges[0].from)]),
        noise(1e-13 * (a.placed.solid->size + b.placed.solid->size)),
        depths{DepthTable(a.placed, origin, arms(of), of.depths[0]),
               DepthTable(b.placed, origin, of.arm, of.depths[1])} {
    of.rate.clear();
    for (const Vec3& x : of.points) of.rate.push_back(b.velocity_at(x) - a.velocity_at(x));
  }
  [[nodiscard]] const Vec3& arm(int point) const { return shared.arm[static_cast<std::size_t>(point)]; }

 private:
  [[nodiscard]] std::span<const Vec3> arms(SolidOverlapBuffer& of) const {
    of.arm.clear();
    for (const Vec3& x : of.points) of.arm.push_back(x - origin);
    return of.arm;
  }
};

/// Presses a part of a face of the walker against the owner's nearest faces. Where one face is nearest to all corners
/// it is so to all of the part, as depths are linear.
template <class K>
void press_rim(const PressedSolid& solid, const DepthTable& owner, const Rim& rim, const PressedFace<K>& face) {
  const int nearest = owner.nearest(rim.point[0]);
  const auto end = rim.point.begin() + static_cast<std::ptrdiff_t>(rim.count);
  if (std::all_of(rim.point.begin(), end, [&](int p) { return owner.nearest(p) == nearest; })) {
    PressedPolygon cell;
    for (std::size_t i = 0; i < rim.count; ++i)
      cell.add({solid.arm(rim.point[i]), larger(owner.row(rim.point[i])[nearest], 0.0), rim.closing[i]});
    return face.add_cell(cell);
  }
  CellCutter cutter(owner, solid.shared.arm, rim, solid.noise);
  for (std::size_t f = 0; f < cutter.faces(); ++f)
    if (const PressedPolygon* cell = cutter.cell(f)) face.add_cell(*cell);
}

using RimEdges = std::span<const SolidOverlapBuffer::Edge>;

/// The points of these edges in the order in which they follow on each other; false where they are not one loop that
/// has room, as rounding may leave them.
template <class Closing>
bool make_rim(RimEdges edges, Closing&& closing, Rim& rim) {
  if (edges.size() < 3 || edges.size() > Rim::most) return false;
  const int first = edges[0].from;
  int at = first;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i > 0 && at == first) return false;
    rim.add(at, closing(at));
    std::size_t next = i;  // mostly the next in the list
    if (edges[i].from != at)
      for (next = 0; next < edges.size() && edges[next].from != at;) ++next;
    if (next == edges.size()) return false;
    at = edges[next].to;
  }
  return at == first;
}

/// One face of the shared solid: whole, or as triangles about one of its points, as laws are that are not linear, whose
/// sums are the better the smaller the cells.
template <class K>
void press_face(const PressedSolid& solid, const PressedFace<K>& face, RimEdges edges) {
  const DepthTable& owner = solid.depths[face.walker_is_b ? 0 : 1];
  if (owner.columns() == 0) return;  // a piece without a surface presses nothing
  const auto closing_at = [&](int point) {
    const double along = face.normal.dot(solid.shared.rate[static_cast<std::size_t>(point)]);
    return face.walker_is_b ? along : -along;
  };
  Rim rim;
  if (K::linear && make_rim(edges, closing_at, rim)) return press_rim(solid, owner, rim, face);
  const int base = edges[0].from;
  for (const auto& [from, to] : edges) {
    if (from == base || to == base) continue;
    Rim triangle;
    for (const int point : {base, from, to}) triangle.add(point, closing_at(point));
    press_rim(solid, owner, triangle, face);
  }
}

/// Second moments of unit area or force about `middle`.
Eigen::Matrix3d spread_about(const std::array<double, 6>& second, double whole, const Vec3& middle) {
  const auto& [xx, yy, zz, xy, yz, zx] = second;
  Eigen::Matrix3d about;
  about << xx, xy, zx, xy, yy, yz, zx, yz, zz;
  return about / whole - middle * middle.transpose();
}

/// Which face of which solid a face of the shared one is.
const Vec3& normal_of(const PlacedSolid& a, const PlacedSolid& b, int of) {
  return of >= 0 ? a.normals[static_cast<std::size_t>(of)] : b.normals[static_cast<std::size_t>(-1 - of)];
}
bool on_surface(const PlacedSolid& a, const PlacedSolid& b, int of) {
  return of >= 0 ? a.solid->is_surface(of) : b.solid->is_surface(-1 - of);
}

template <class K>
SolidPressure press(const MovingSolid& a, const MovingSolid& b, const K& law, SolidOverlapBuffer& shared,
                    double crushed) {
  const PressedSolid solid(a, b, shared);
  PressedParts parts{PressedTriangles(law.beta), {}};
  int first = 0;
  for (const auto& [of, end] : shared.faces) {
    const bool of_b = of < 0;
    if (on_surface(a.placed, b.placed, of)) {
      const RimEdges edges =
          RimEdges(shared.edges).subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(end - first));
      press_face(solid, PressedFace<K>{law, normal_of(a.placed, b.placed, of), of_b, crushed, parts}, edges);
    }
    first = end;
  }
  return pressure_of_sums(solid.origin, 0.5 * law.kn, K::linear ? parts.triangles.sums() : parts.sampled);
}

}  // namespace

Vec3 line_across(const Vec3& n) {
  int least = 0;
  n.cwiseAbs().minCoeff(&least);
  return cross(n, Vec3(Vec3::Unit(least))).normalized();
}

/// By Cholesky: a = (sqrt(xx), xy / sqrt(xx)), b = (0, the root of what is left).
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
                             SolidOverlapBuffer& shared, double crushed) {
  if (shared.faces.empty()) return {};
  return with_kernel(law, [&](const auto& kernel) { return press(a, b, kernel, shared, crushed); });
}

}  // namespace trilith
