#include "contact/solid_pressure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "base/lanes.hpp"
#include "shape/depth_table.hpp"

namespace trilith {
namespace {

// Stages of one call: depths of all points of the shared solid below the faces of both; for each face of the shared
// solid, its rim as triangles about one of its points; for each triangle, the cells in which one face of the other
// solid is nearest; over each cell the pressure and its moments.

/// A point of a pressed face: where it is, how deep in the other solid, and how fast the two close there.
struct PressedPoint {
  Vec3 x;
  double depth, closing;  // [m], [m/s]
};

/// A convex polygon with room for a triangle cut by many planes.
struct PressedPolygon {
  static constexpr std::size_t most = 128;
  std::array<PressedPoint, most> corner;
  std::size_t count = 0;

  void add(const PressedPoint& p) {
    if (count < most) corner[count++] = p;
  }
};

/// Of a function at the corners of a polygon.
using CornerHeights = std::array<double, PressedPolygon::most>;

PressedPoint between(const PressedPoint& p, const PressedPoint& q, double share) {
  return {p.x + share * (q.x - p.x), p.depth + share * (q.depth - p.depth),
          p.closing + share * (q.closing - p.closing)};
}

/// The part of a polygon where a function that is linear over it is not negative.
void keep_above(const PressedPolygon& from, const CornerHeights& height, PressedPolygon& kept) {
  kept.count = 0;
  for (std::size_t i = 0; i < from.count; ++i) {
    const std::size_t next = i + 1 == from.count ? 0 : i + 1;
    const double hp = height[i], hq = height[next];
    if (hp >= 0) kept.add(from.corner[i]);
    if ((hp > 0 && hq < 0) || (hp < 0 && hq > 0)) kept.add(between(from.corner[i], from.corner[next], hp / (hp - hq)));
  }
}

/// Integrals over a triangle, over kn: of the pressure and of its first moment about some point, of the pressure times
/// the closing speed.
struct TriangleSums {
  double force = 0, power = 0;
  Vec3 first = Vec3::Zero();
};

/// Of a pressure that is linear over the triangle; arms are from the point the moment is about, and their sum.
TRILITH_INLINE void add_linear(double area, const std::array<double, 3>& p, const std::array<Vec3, 3>& arm,
                               const Vec3& arms, const std::array<double, 3>& closing, TriangleSums& sums) {
  const double sum = p[0] + p[1] + p[2], speed = closing[0] + closing[1] + closing[2], twelfth = area / 12;
  sums.force += 4 * twelfth * sum;
  sums.first += twelfth * (sum * arms + p[0] * arm[0] + p[1] * arm[1] + p[2] * arm[2]);
  sums.power += twelfth * (sum * speed + p[0] * closing[0] + p[1] * closing[1] + p[2] * closing[2]);
}

/// Six points of a triangle, exact to degree 4 (Dunavant 1985, as in contact/power.hpp), for laws that are not linear.
template <class Pressure>
void add_sampled(double area, const std::array<PressedPoint, 3>& at, const std::array<Vec3, 3>& arm,
                 Pressure&& pressure, TriangleSums& sums) {
  constexpr std::array<std::array<double, 3>, 2> rule{{{0.108103018168070, 0.445948490915965, 0.223381589678011},
                                                       {0.816847572980459, 0.091576213509771, 0.109951743655322}}};
  for (const auto& [own, other, weight] : rule)
    for (const std::size_t i : {0U, 1U, 2U}) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const double closing = own * at[i].closing + other * (at[j].closing + at[k].closing);
      const double p = weight * area * pressure(own * at[i].depth + other * (at[j].depth + at[k].depth), closing);
      sums.force += p, sums.power += p * closing;
      sums.first += p * (own * arm[i] + other * (arm[j] + arm[k]));
    }
}

/// Calls visit(area, corners) for the triangles of a polygon about its first corner.
template <class Visit>
void for_triangles(const PressedPolygon& polygon, const Vec3& normal, Visit&& visit) {
  if (polygon.count < 3) return;
  const Vec3& first = polygon.corner[0].x;
  Vec3 before = polygon.corner[1].x - first;
  for (std::size_t i = 2; i < polygon.count; ++i) {
    const Vec3 now = polygon.corner[i].x - first;
    visit(0.5 * normal.dot(cross(before, now)), std::array<std::size_t, 3>{0, i - 1, i});
    before = now;
  }
}

/// Sums over all pressed faces. Moments are about `origin`, a point near the contact.
struct SolidSums {
  Vec3 origin;
  SolidPressure out;
  Vec3 arm_sum = Vec3::Zero();     // integral of pressure times arm
  Vec3 area_arm = Vec3::Zero();    // ... of the arm over the area, by halves as the area is
  std::array<double, 6> second{};  // ... of its square: xx, yy, zz, xy, yz, zx
};

TRILITH_INLINE void add_area(double area, const std::array<Vec3, 3>& arm, const Vec3& arms, SolidSums& sums) {
  sums.out.area += 0.5 * area;
  sums.area_arm += area / 6 * arms;
  const double share = area / 24;
  const auto product = [&](int i, int j) {
    return share * (arms[i] * arms[j] + arm[0][i] * arm[0][j] + arm[1][i] * arm[1][j] + arm[2][i] * arm[2][j]);
  };
  sums.second[0] += product(0, 0), sums.second[1] += product(1, 1), sums.second[2] += product(2, 2);
  sums.second[3] += product(0, 1), sums.second[4] += product(1, 2), sums.second[5] += product(2, 0);
}

/// A face of the walker inside the owner.
template <class K>
struct PressedFace {
  const K& law;
  Vec3 normal;  // out of the walker
  bool walker_is_b;

  /// Adds one cell, over which depth and closing speed are linear.
  void add_cell(const PressedPolygon& cell, SolidSums& sums) const {
    if constexpr (K::linear)
      add_linear_cell(cell, sums);
    else
      add_sampled_cell(cell, sums);
    for (std::size_t i = 0; i < cell.count; ++i) sums.out.depth = std::max(sums.out.depth, cell.corner[i].depth);
  }

 private:
  static std::array<double, 3> three(const CornerHeights& of, const std::array<std::size_t, 3>& at) {
    return {of[at[0]], of[at[1]], of[at[2]]};
  }
  static std::array<double, 3> closings(const PressedPolygon& cell, const std::array<std::size_t, 3>& at) {
    return {cell.corner[at[0]].closing, cell.corner[at[1]].closing, cell.corner[at[2]].closing};
  }
  static std::array<Vec3, 3> arms_of(const PressedPolygon& cell, const std::array<std::size_t, 3>& at,
                                     const Vec3& origin) {
    return {cell.corner[at[0]].x - origin, cell.corner[at[1]].x - origin, cell.corner[at[2]].x - origin};
  }

  void add_linear_cell(const PressedPolygon& cell, SolidSums& sums) const {
    CornerHeights damped;
    bool some = false, all = true;
    for (std::size_t i = 0; i < cell.count; ++i) {
      damped[i] = cell.corner[i].depth + law.beta * cell.corner[i].closing;
      some = some || damped[i] > 0, all = all && damped[i] >= 0;
    }
    const bool along = law.beta > 0 && all;  // pressed everywhere: both sums by the same triangles
    TriangleSums springs, total;
    for_triangles(cell, normal, [&](double area, const std::array<std::size_t, 3>& at) {
      const std::array<Vec3, 3> arm = arms_of(cell, at, sums.origin);
      const std::array<double, 3> closing = closings(cell, at);
      const Vec3 arms = arm[0] + arm[1] + arm[2];
      add_area(area, arm, arms, sums);
      add_linear(area, {cell.corner[at[0]].depth, cell.corner[at[1]].depth, cell.corner[at[2]].depth}, arm, arms,
                 closing, springs);
      if (along) add_linear(area, three(damped, at), arm, arms, closing, total);
    });
    if (!(law.beta > 0))
      total = springs;
    else if (some && !all)
      add_part(cell, damped, sums.origin, total);
    add(springs, total, sums);
  }

  /// The pressure with its damping over the part of a cell where that is above 0.
  void add_part(const PressedPolygon& cell, const CornerHeights& damped, const Vec3& origin,
                TriangleSums& total) const {
    PressedPolygon pressed;
    keep_above(cell, damped, pressed);
    CornerHeights pressure;
    for (std::size_t i = 0; i < pressed.count; ++i)
      pressure[i] = pressed.corner[i].depth + law.beta * pressed.corner[i].closing;
    for_triangles(pressed, normal, [&](double area, const std::array<std::size_t, 3>& at) {
      const std::array<Vec3, 3> arm = arms_of(pressed, at, origin);
      add_linear(area, three(pressure, at), arm, arm[0] + arm[1] + arm[2], closings(pressed, at), total);
    });
  }

  void add_sampled_cell(const PressedPolygon& cell, SolidSums& sums) const {
    TriangleSums springs, total;
    for_triangles(cell, normal, [&](double area, const std::array<std::size_t, 3>& at) {
      const std::array<PressedPoint, 3> corner{cell.corner[at[0]], cell.corner[at[1]], cell.corner[at[2]]};
      const std::array<Vec3, 3> arm = arms_of(cell, at, sums.origin);
      add_area(area, arm, arm[0] + arm[1] + arm[2], sums);
      add_sampled(
          area, corner, arm, [&](double d, double) { return law.effective(d); }, springs);
      add_sampled(
          area, corner, arm, [&](double d, double c) { return std::max(0.0, law.effective(d) + law.beta * c); }, total);
    });
    add(springs, total, sums);
  }

  /// k is half of kn, as the faces of the other solid bring the other half. On b acts -n where b walks, as n then
  /// points from b into a, and +n where a does.
  void add(const TriangleSums& springs, const TriangleSums& total, SolidSums& sums) const {
    const double k = 0.5 * law.kn, sign = walker_is_b ? -1 : 1;
    const Vec3 n = sign * k * normal;
    SolidPressure& out = sums.out;
    out.force += total.force * n, out.moment += cross(total.first, n);
    out.damping += (total.force - springs.force) * n;
    out.damping_moment += cross(Vec3(total.first - springs.first), n);
    out.damped += k * (total.power - springs.power);
    out.pressure += k * total.force, sums.arm_sum += k * total.first;
  }
};

double least_of(double a, double b, double c) {
  return std::min(std::min(a, b), c);
}
double largest_of(double a, double b, double c) {
  return std::max(std::max(a, b), c);
}

/// A triangle of a face of the walker: points of the shared solid, and the speeds at which the two close there.
struct PressedTriangle {
  std::array<int, 3> point;
  std::array<double, 3> closing;
};

/// Faces of the owner that may be nearest to some point of a triangle, and their depths at its corners. A face that all
/// of the triangle is deeper below than below some other is nearest nowhere.
struct NearFaces {
  struct Row {
    int column;
    std::array<double, 3> depth;
  };
  static constexpr std::size_t most = 256;
  std::array<Row, most> row;
  std::size_t count = 0;

  NearFaces(const DepthTable& owner, const std::array<int, 3>& point) {
    const double *d0 = owner.row(point[0]), *d1 = owner.row(point[1]), *d2 = owner.row(point[2]);
    double reach = std::numeric_limits<double>::infinity();
    for (int k = 0; k < owner.columns(); ++k) reach = std::min(reach, std::max(0.0, largest_of(d0[k], d1[k], d2[k])));
    for (int k = 0; k < owner.columns() && count < most; ++k)
      if (least_of(d0[k], d1[k], d2[k]) <= reach && !owner.has_first_like(k)) row[count++] = {k, {d0[k], d1[k], d2[k]}};
  }
};

/// What of a triangle is nearest to one of the faces near it. Of most others its corners tell that they cut nothing
/// away, or all of it; `noise` is well above what rounding does to a depth [m].
class CellCutter {
 public:
  CellCutter(const DepthTable& owner, std::span<const Vec3> points, const PressedTriangle& triangle, double noise)
      : owner_(owner), points_(points), triangle_(triangle), faces_(owner, triangle.point), noise_(noise) {}

  [[nodiscard]] std::size_t faces() const { return faces_.count; }

  /// The cell of face `f`; null where there is none.
  const PressedPolygon* cell(std::size_t f) {
    std::array<double, 3> depth;
    for (std::size_t i = 0; i < 3; ++i) depth[i] = std::max(0.0, faces_.row[f].depth[i]);
    if (!list_cutters(f, depth)) return nullptr;
    cell_ = &polygon_[0], spare_ = &polygon_[1];
    cell_->count = 0;
    for (std::size_t i = 0; i < 3; ++i)
      cell_->add({points_[static_cast<std::size_t>(triangle_.point[i])], depth[i], triangle_.closing[i]});
    for (std::size_t c = 0; c < cutters_ && cell_->count > 2; ++c) cut_by(faces_.row[cutter_[c]].column);
    return cell_->count > 2 ? cell_ : nullptr;
  }

 private:
  /// Those that may cut something away; false where one takes all.
  bool list_cutters(std::size_t f, const std::array<double, 3>& depth) {
    cutters_ = 0;
    for (std::size_t g = 0; g < faces_.count; ++g) {
      if (g == f) continue;
      const std::array<double, 3>& other = faces_.row[g].depth;
      const double h0 = other[0] - depth[0], h1 = other[1] - depth[1], h2 = other[2] - depth[2];
      if (largest_of(h0, h1, h2) < -noise_) return false;
      if (least_of(h0, h1, h2) <= noise_) cutter_[cutters_++] = g;
    }
    return true;
  }

  void cut_by(int column) {
    CornerHeights height;
    bool all = true;
    for (std::size_t i = 0; i < cell_->count; ++i) {
      const PressedPoint& p = cell_->corner[i];
      height[i] = owner_.below(column, p.x) - p.depth;
      all = all && height[i] >= 0;
    }
    if (all) return;
    keep_above(*cell_, height, *spare_);
    std::swap(cell_, spare_);
  }

  const DepthTable& owner_;
  std::span<const Vec3> points_;
  const PressedTriangle& triangle_;
  NearFaces faces_;
  double noise_;
  std::array<std::size_t, NearFaces::most> cutter_;
  std::size_t cutters_ = 0;
  std::array<PressedPolygon, 2> polygon_;
  PressedPolygon *cell_ = nullptr, *spare_ = nullptr;
};

/// What is pressed: the shared solid, and how fast b moves away from a at its points.
struct PressedSolid {
  const SolidOverlapBuffer& shared;
  std::array<DepthTable, 2> depths;  // below the faces of a and of b
  double noise;                      // see CellCutter

  PressedSolid(const MovingSolid& a, const MovingSolid& b, SolidOverlapBuffer& of)
      : shared(of),
        depths{DepthTable(a.placed, of.points, of.depths[0]), DepthTable(b.placed, of.points, of.depths[1])} {
    double farthest = 0;
    of.rate.clear();
    for (const Vec3& x : of.points) {
      of.rate.push_back(b.velocity_at(x) - a.velocity_at(x));
      farthest = std::max(farthest, x.cwiseAbs().maxCoeff());
    }
    noise = 1e-13 * (farthest + a.placed.solid->size + b.placed.solid->size);
  }
};

/// Presses one triangle of a face of the walker against the owner's nearest faces. Where one face is nearest to all
/// three corners it is so to all of the triangle, as depths are linear.
template <class K>
void press_triangle(const PressedSolid& solid, const DepthTable& owner, const PressedFace<K>& face,
                    const PressedTriangle& triangle, SolidSums& sums) {
  const auto& [p, q, r] = triangle.point;
  const int nearest = owner.nearest(p);
  if (nearest < 0) return;  // a piece without a surface presses nothing
  if (owner.nearest(q) == nearest && owner.nearest(r) == nearest) {
    PressedPolygon cell;
    for (std::size_t i = 0; i < 3; ++i) {
      const int point = triangle.point[i];
      cell.add({solid.shared.points[static_cast<std::size_t>(point)], std::max(0.0, owner.row(point)[nearest]),
                triangle.closing[i]});
    }
    return face.add_cell(cell, sums);
  }
  CellCutter cutter(owner, solid.shared.points, triangle, solid.noise);
  for (std::size_t f = 0; f < cutter.faces(); ++f)
    if (const PressedPolygon* cell = cutter.cell(f)) face.add_cell(*cell, sums);
}

/// One face of the shared solid: the edges `first` to `end` of its rim.
template <class K>
void press_face(const PressedSolid& solid, const PressedFace<K>& face, int first, int end, SolidSums& sums) {
  const DepthTable& owner = solid.depths[face.walker_is_b ? 0 : 1];
  const auto closing_at = [&](int point) {
    const double along = face.normal.dot(solid.shared.rate[static_cast<std::size_t>(point)]);
    return face.walker_is_b ? along : -along;
  };
  const int base = solid.shared.edges[static_cast<std::size_t>(first)].from;
  const double at_base = closing_at(base);
  for (int i = first; i < end; ++i) {
    const auto [from, to] = solid.shared.edges[static_cast<std::size_t>(i)];
    if (from == base || to == base) continue;
    press_triangle(solid, owner, face, {{base, from, to}, {at_base, closing_at(from), closing_at(to)}}, sums);
  }
}

/// Moves the moments to the centre of pressure and finds the mean distance from it.
SolidPressure finished(SolidSums& sums) {
  SolidPressure& out = sums.out;
  if (!(out.area > 0)) return {};
  const Vec3 middle = sums.area_arm / out.area;
  const Vec3 arm = out.pressure > 0 ? Vec3(sums.arm_sum / out.pressure) : middle;
  out.centre = sums.origin + arm, out.middle = sums.origin + middle;
  out.moment -= cross(arm, out.force), out.damping_moment -= cross(arm, out.damping);
  const auto& [xx, yy, zz, xy, yz, zx] = sums.second;
  Eigen::Matrix3d about;
  about << xx, xy, zx, xy, yy, yz, zx, yz, zz;
  about = (about / out.area - middle * middle.transpose()).eval();
  // A plane area has one principal value of 0, so the sum of the products by twos is that of the other two.
  const double product = about(0, 0) * about(1, 1) + about(1, 1) * about(2, 2) + about(2, 2) * about(0, 0) -
                         about(0, 1) * about(0, 1) - about(1, 2) * about(1, 2) - about(2, 0) * about(2, 0);
  out.radius = turning_radius(about.trace(), product), out.spread = larger_principal(about.trace(), product);
  return out;
}

/// Which face of which solid a face of the shared one is.
const Vec3& normal_of(const PlacedSolid& a, const PlacedSolid& b, int of) {
  return of >= 0 ? a.normals[static_cast<std::size_t>(of)] : b.normals[static_cast<std::size_t>(-1 - of)];
}
bool on_surface(const PlacedSolid& a, const PlacedSolid& b, int of) {
  return of >= 0 ? a.solid->is_surface(of) : b.solid->is_surface(-1 - of);
}

template <class K>
SolidPressure press(const MovingSolid& a, const MovingSolid& b, const K& law, SolidOverlapBuffer& shared) {
  const PressedSolid solid(a, b, shared);
  SolidSums sums;
  sums.origin = shared.points[static_cast<std::size_t>(shared.edges[0].from)];
  int first = 0;
  for (const auto& [of, end] : shared.faces) {
    const bool of_b = of < 0;
    if (on_surface(a.placed, b.placed, of)) {
      const PressedFace<K> face{law, normal_of(a.placed, b.placed, of), of_b};
      press_face(solid, face, first, end, sums);
    }
    first = end;
  }
  return finished(sums);
}

}  // namespace

double turning_radius(double trace, double product) {
  if (!(trace > 0)) return 0;
  const double roundness = std::clamp(4 * product / (trace * trace), 0.0, 1.0);
  return std::sqrt(trace) * (0.8660 + 0.0725 * std::sqrt(roundness));
}

double larger_principal(double trace, double product) {
  return 0.5 * (trace + std::sqrt(std::max(0.0, trace * trace - 4 * product)));
}

SolidPressure solid_pressure(const MovingSolid& a, const MovingSolid& b, const LawInUse& law,
                             SolidOverlapBuffer& shared) {
  if (shared.faces.empty()) return {};
  return with_kernel(law, [&](const auto& kernel) { return press(a, b, kernel, shared); });
}

}  // namespace trilith
